package raytracing.compiled;

import raytracing.area.ConvexShadows;

/**
 * The shadow of a sphere on the square of a shaft. Between hit and square it is the section of a cone. A sphere that
 * reaches through the plane of the square hides what is behind its tangent circle in that cone, and the disc that the
 * plane cuts out of it; a sphere around the hit hides all but the disc. One thread.
 */
final class SphereShadow {
    private final ConvexShadows shadows;

    SphereShadow(ConvexShadows shadows) {
        this.shadows = shadows;
    }

    /** Adds the shadow of a sphere with centre m, in the shaft's coordinates, and radius r, not that which was hit. */
    void add(ShadowShaft shaft, int surface, double mx, double my, double mz, double r, double passing) {
        double slack = shaft.margin + 2 * ShadowShaft.ROUNDING * (Math.abs(mx) + Math.abs(my) + Math.abs(mz) + r);
        double distance = Math.sqrt(mx * mx + my * my + mz * mz);
        if (distance > r + slack) {
            addOutside(shaft, mx, my, mz, r, (distance - r) * (distance + r), passing);
        } else if (distance < r - slack) {
            addAround(shaft, mx, my, mz, r, passing, 0, 0, 1);
        } else {
            addOnWall(shaft, shaft.sideOf(surface), mx, my, mz, r, passing);
        }
    }

    /** From close to the wall: from outside everything behind it is hidden, from inside all that is not in the sphere. */
    private void addOnWall(ShadowShaft shaft, int side, double mx, double my, double mz, double r, double passing) {
        if (side > 0) {
            shadows.beginFigure(passing);
            shadows.addLine(mx, my, mz * shaft.depth);
        } else if (side < 0) {
            addAround(shaft, mx, my, mz, r, passing, 0, 0, 1);
        } else {
            addAround(shaft, mx, my, mz, r, passing, mx, my, mz * shaft.depth);
        }
    }

    /**
     * Of a sphere that the hit is not in, the disc matters only where the square is not wholly behind the tangent
     * circle. A sphere behind the square throws no shadow on it.
     */
    private void addOutside(ShadowShaft shaft, double mx, double my, double mz, double r, double k, double passing) {
        double gap = mz - shaft.depth;
        double behindCircle = mz * shaft.depth - k - shaft.halfWidth * (Math.abs(mx) + Math.abs(my));
        if (Math.abs(gap) < r && behindCircle < 0) {
            shadows.discs().addThroughPlane(mx, my, mz, r, Math.sqrt((r - gap) * (r + gap)), passing);
        } else if (gap < r) {
            shadows.balls().add(mx, my, mz, r, passing);
        }
    }

    /**
     * Adds the shadow of a sphere around the hit: everything on the inner side of a line but the disc in the sphere.
     */
    void addAround(ShadowShaft shaft, double mx, double my, double mz, double r, double passing,
                   double lineA, double lineB, double lineC) {
        double radius = discRadius(shaft, mx, my, mz, r);
        if (radius > 0) {
            shadows.discs().addAround(mx, my, radius, passing, lineA, lineB, lineC);
        } else {
            shadows.beginFigure(passing);
            shadows.addLine(lineA, lineB, lineC);
        }
    }

    /** Radius of the disc that the square's plane cuts out of a sphere; 0 if it does not touch the square. */
    private static double discRadius(ShadowShaft shaft, double mx, double my, double mz, double r) {
        double besideX = Math.max(Math.abs(mx) - shaft.halfWidth, 0);
        double besideY = Math.max(Math.abs(my) - shaft.halfWidth, 0);
        double gap = mz - shaft.depth;
        double squaredRadius = (r - gap) * (r + gap);
        return besideX * besideX + besideY * besideY < squaredRadius ? Math.sqrt(squaredRadius) : 0;
    }
}
