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
        if (!(r > Sight.SHORT && size < Sight.LONG)) {
            sight.setUnknown();
            return;
        }
        double along = cone.along(x, y, z);
        double across = cone.across(x, y, z);
        double rounding = Sight.ROUNDING * size;
        if (cone.beyond(along, across) > r + rounding + touching) {
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
        double mostProduct = cone.mostProduct(along, across, distance);
        if (mostProduct < -rounding) {                                 // all of the cone is over a right angle off
            sight.cover = Cover.NONE;
            return;
        }
        double square = (distance - r) * (distance + r);
        double error = rounding * (distance + r);
        double tangent = Math.sqrt(square + error);                    // the longest way to a point that is seen
        double least = cone.leastProduct(along, across) - rounding;    // D cos(gamma + alpha)
        double most = mostProduct + rounding;
        double outermost = across * cone.cosine + along * cone.sine;   // D sin(gamma + alpha)
        boolean isCovered = least > 0 && (outermost + rounding < r || least > tangent + rounding);
        double nearest = crossing(square - error, most);
        double from = Math.max(distance - r - rounding, Math.min(nearest, tangent - rounding) * (1 - Sight.ROUNDING));
        double to = isCovered ? Math.min(crossing(square + error, least), tangent) : tangent;
        sight.set(isCovered ? Cover.ALL : Cover.SOME, Math.min(from, (1 - Sight.ROUNDING) * tangent),
            to * (1 + Sight.ROUNDING) + rounding);
    }

    /** The first crossing of a ray whose way to the point nearest to the centre is given, or that point if it passes. */
    private static double crossing(double squaredTangent, double way) {
        return squaredTangent / (way + Math.sqrt(Math.max(0, way * way - squaredTangent)));
    }

    private void seeFromInside(double along, double across, double distance, double r, double rounding, Sight sight) {
        double c = cone.cosine;
        double s = cone.sine;
        double least = (along * c + across * s < 0 ? -distance : along * c - across * s) - rounding;
        double most = cone.mostProduct(along, across, distance) + rounding;
        double square = (r - distance) * (r + distance);
        double error = rounding * (r + distance);
        sight.set(Cover.ALL, exit(square - error, least) * (1 - Sight.ROUNDING),
            exit(square + error, most) * (1 + Sight.ROUNDING));
    }

    private static double exit(double square, double way) {
        double root = Math.sqrt(way * way + square);
        return way > 0 ? way + root : square / (root - way);
    }
}
