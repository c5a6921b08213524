package raytracing.compiled;

import raytracing.area.ConvexShadows;

/**
 * The lines that bound the shadow of a box on the square of a shaft. Every one is the trace of a plane: through the hit
 * and an edge that the hit sees as part of the box's outline, or of a wall that faces the hit. One thread, box after
 * box.
 */
final class BoxShadow {
    private static final int AXES = 3;

    private final ConvexShadows shadows;
    private ShadowShaft shaft;

    /** The way from the hit to the centre along each axis, and from the hit to the wall that faces it. */
    private final double[] toCentre = new double[AXES];
    private final double[] toWall = new double[AXES];
    private final boolean[] isFacing = new boolean[AXES];
    private double half;

    BoxShadow(ConvexShadows shadows) {
        this.shadows = shadows;
    }

    private void set(ShadowShaft newShaft, double fx, double fy, double fz, double halfEdge) {
        shaft = newShaft;
        half = halfEdge;
        toCentre[0] = fx;
        toCentre[1] = fy;
        toCentre[2] = fz;
    }

    /**
     * Adds the shadow of a box, not that which was hit.
     *
     * @param surface number of the box
     * @param fx way from the hit to the centre, world axes, x part
     * @param fy y part
     * @param fz z part
     * @param halfEdge half its edge
     * @param slack how far its walls may be off; of a hit so near to a wall, exact numbers tell the side
     * @param passing share of light that the box lets through
     */
    void add(ShadowShaft newShaft, int surface, double fx, double fy, double fz, double halfEdge, double slack, double passing) {
        set(newShaft, fx, fy, fz, halfEdge);
        boolean isOutside = false;
        for (int i = 0; i < AXES; i++) {
            double distance = Math.abs(toCentre[i]) - half;
            double side = Math.abs(distance) > slack ? distance : shaft.sideOf(surface, i);
            isFacing[i] = side >= 0;
            toWall[i] = Math.abs(distance) > slack ? distance : 0;
            isOutside |= side > 0;
        }
        if (isOutside) {
            addOutside(passing);
        } else {
            addInsideOrOn(passing);
        }
    }

    private void addOutside(double passing) {
        shadows.beginFigure(passing);
        for (int i = 0; i < AXES; i++) {
            if (isFacing[i]) {
                addLine(i, 1, -toWall[i]);
                addOutline(i, (i + 1) % AXES);
                addOutline(i, (i + 2) % AXES);
            }
        }
    }

    /** Everything behind the walls that the hit is on, but for what is in the box. */
    private void addInsideOrOn(double passing) {
        shadows.beginAllButFigure(passing);
        for (int i = 0; i < AXES; i++) {
            if (isFacing[i]) {
                addLine(i, 1, 0);
            }
        }
        addInside();
    }

    /**
     * The outline's edges between a facing wall and the two walls across an axis, one near and one far. With all axes
     * turned so that the centre is ahead, the hit sees the edge at (toWall, reach).
     */
    private void addOutline(int wall, int across) {
        double ahead = Math.abs(toCentre[across]);
        addLine(wall, ahead + half, across, -toWall[wall]);
        if (!isFacing[across] && toWall[across] != 0) {
            addLine(wall, half - ahead, across, toWall[wall]);
        }
    }

    /** Adds the shadow of the box that was hit: everything on the inner side of a line but what is in the box. */
    void addOwn(ShadowShaft newShaft, double fx, double fy, double fz, double halfEdge, double passing,
                double lineA, double lineB, double lineC) {
        set(newShaft, fx, fy, fz, halfEdge);
        shadows.beginAllButFigure(passing);
        shadows.addLine(lineA, lineB, lineC);
        addInside();
    }

    private void addInside() {
        shadows.exceptFigure();
        for (int i = 0; i < AXES; i++) {
            addLine(i, 1, half - Math.abs(toCentre[i]));
            addLine(i, -1, half + Math.abs(toCentre[i]));
        }
    }

    /** factor e_i + constant &gt;= 0, the axis turned so that the centre is ahead. */
    private void addLine(int axis, double factor, double constant) {
        double f = toCentre[axis] < 0 ? -factor : factor;
        shadows.addLine(f * alongU(axis), f * alongV(axis), f * toLight(axis) + constant);
    }

    /** first e_i + second e_j &gt;= 0, both axes turned so that the centre is ahead. */
    private void addLine(int i, double first, int j, double second) {
        double f = toCentre[i] < 0 ? -first : first;
        double s = toCentre[j] < 0 ? -second : second;
        shadows.addLine(f * alongU(i) + s * alongU(j), f * alongV(i) + s * alongV(j), f * toLight(i) + s * toLight(j));
    }

    private double alongU(int axis) {
        return axis == 0 ? shaft.ux : axis == 1 ? shaft.uy : shaft.uz;
    }

    private double alongV(int axis) {
        return axis == 0 ? shaft.vx : axis == 1 ? shaft.vy : shaft.vz;
    }

    private double toLight(int axis) {
        return axis == 0 ? shaft.tx : axis == 1 ? shaft.ty : shaft.tz;
    }
}
