package raytracing.outline;

import raytracing.math.Vector;
import raytracing.outline.Sight.Cover;
import raytracing.surface.Sphere;

/**
 * A sphere against a cone. Seen from outside, the sphere is a disc of directions: its angular radius is asin(r / D), with r
 * the radius and D the distance of the centre. With gamma the angle between the centre's direction and the axis, and alpha
 * that of the cone, the cone is beside the disc if gamma - alpha is above the disc's radius, and inside if gamma + alpha is
 * below it. Both are compared by their sines, whose rounding is a few parts in 2^53 also for tiny angles. Not thread-safe.
 */
final class SphereSight {
    /** 512 u, with u = 2^-53: no length here is off by more of D + r (proved: at most 40 roundings). */
    private static final double ROUNDING = 0x1p-44;

    /** Of lengths in this range, squares and products of squares are normal numbers. */
    private static final double SHORT = 0x1p-200;
    private static final double LONG = 0x1p200;

    private final SquareCone cone;
    private final double touching;

    /** With the distance below which an eye may touch a surface. */
    SphereSight(SquareCone cone, double touching) {
        this.cone = cone;
        this.touching = touching;
    }

    void test(Sphere sphere, Sight sight) {
        Vector centre = sphere.centre();
        double r = sphere.radius();
        double x = centre.x() - cone.eyeX;
        double y = centre.y() - cone.eyeY;
        double z = centre.z() - cone.eyeZ;
        double size = Math.abs(x) + Math.abs(y) + Math.abs(z) + r;
        if (!(r > SHORT && size < LONG)) {
            sight.setUnknown();
            return;
        }
        double along = cone.along(x, y, z);
        double across = cone.across(x, y, z);
        double rounding = ROUNDING * size;
        double beyond = across * cone.cosine - along * cone.sine;      // D sin(gamma - alpha)
        if (beyond > r + rounding + touching) {
            sight.cover = Cover.NONE;
            return;
        }
        double distance = Math.sqrt(along * along + across * across);
        if (distance - r > 4 * rounding + touching) {
            testFromOutside(along, across, distance, r, rounding, sight);
        } else if (r - distance > 4 * rounding + touching) {
            seeFromInside(along, across, distance, r, rounding, sight);
        } else {
            sight.setUnknown();
        }
    }

    private void testFromOutside(double along, double across, double distance, double r, double rounding, Sight sight) {
        double c = cone.cosine;
        double s = cone.sine;
        if (along * c + across * s < -rounding) {                      // all of the cone is over a right angle off
            sight.cover = Cover.NONE;
            return;
        }
        double square = (distance - r) * (distance + r);
        double error = rounding * (distance + r);
        double tangent = Math.sqrt(square + error);                    // the longest way to a point that is seen
        double least = along * c - across * s - rounding;              // D cos(gamma + alpha)
        double most = (across * c < along * s ? distance : along * c + across * s) + rounding;
        boolean isCovered = least > 0 && (across * c + along * s + rounding < r || least > tangent + rounding);
        double nearest = crossing(square - error, most);
        double from = Math.max(distance - r - rounding, Math.min(nearest, tangent - rounding) * (1 - ROUNDING));
        double to = isCovered ? Math.min(crossing(square + error, least), tangent) : tangent;
        sight.set(isCovered ? Cover.ALL : Cover.SOME, Math.min(from, (1 - ROUNDING) * tangent),
            to * (1 + ROUNDING) + rounding);
    }

    /** The first crossing of a ray whose way to the point nearest to the centre is given, or that point if it passes. */
    private static double crossing(double squaredTangent, double way) {
        return squaredTangent / (way + Math.sqrt(Math.max(0, way * way - squaredTangent)));
    }

    private void seeFromInside(double along, double across, double distance, double r, double rounding, Sight sight) {
        double c = cone.cosine;
        double s = cone.sine;
        double least = (along * c + across * s < 0 ? -distance : along * c - across * s) - rounding;
        double most = (across * c < along * s ? distance : along * c + across * s) + rounding;
        double square = (r - distance) * (r + distance);
        double error = rounding * (r + distance);
        sight.set(Cover.ALL, exit(square - error, least) * (1 - ROUNDING), exit(square + error, most) * (1 + ROUNDING));
    }

    private static double exit(double square, double way) {
        double root = Math.sqrt(way * way + square);
        return way > 0 ? way + root : square / (root - way);
    }
}
