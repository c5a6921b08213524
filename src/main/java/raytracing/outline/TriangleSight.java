package raytracing.outline;

import raytracing.math.Determinant;
import raytracing.math.Vector;
import raytracing.outline.Sight.Cover;
import raytracing.surface.Triangle;

/**
 * A triangle against a cone. Each edge and the eye span a plane, and the triangle is seen by the directions on the inner side
 * of all three. A cone that is inside all of them sees the triangle alone; a cone that is beyond one of them, or beside a ball
 * around the triangle, does not see it. Not thread-safe.
 */
final class TriangleSight {
    /** With a gap that is less certain than this, a triangle has no useful flatness. */
    private static final double CERTAIN = 0x1p-10;

    private final SquareCone cone;
    private final double touching;
    private final double eyeSize;

    /** Of all edges so far, the smallest of their least and of their greatest products with the cone's directions. */
    private double least;
    private double most;

    TriangleSight(SquareCone cone, double touching) {
        this.cone = cone;
        this.touching = touching;
        eyeSize = Math.abs(cone.eyeX) + Math.abs(cone.eyeY) + Math.abs(cone.eyeZ);
    }

    void test(Triangle triangle, Sight sight) {
        double x = triangle.middleX() - cone.eyeX;
        double y = triangle.middleY() - cone.eyeY;
        double z = triangle.middleZ() - cone.eyeZ;
        double radius = triangle.radius();
        double size = Math.abs(x) + Math.abs(y) + Math.abs(z) + radius;
        double margin = Sight.ROUNDING * (size + eyeSize) + touching;
        if (!(radius > Sight.SHORT && size < Sight.LONG)) {
            sight.setUnknown();
            return;
        }
        if (cone.beyond(cone.along(x, y, z), cone.across(x, y, z)) > radius + margin) {
            sight.cover = Cover.NONE;
            return;
        }
        double from = Math.max(0, (1 - Sight.ROUNDING) * (Vector.length(x, y, z) - radius - margin));
        testEdges(triangle, size, margin, from, sight);
    }

    private void testEdges(Triangle triangle, double size, double margin, double from, Sight sight) {
        double ax = triangle.ax() - cone.eyeX;
        double ay = triangle.ay() - cone.eyeY;
        double az = triangle.az() - cone.eyeZ;
        double bx = triangle.bx() - cone.eyeX;
        double by = triangle.by() - cone.eyeY;
        double bz = triangle.bz() - cone.eyeZ;
        double cx = triangle.cx() - cone.eyeX;
        double cy = triangle.cy() - cone.eyeY;
        double cz = triangle.cz() - cone.eyeZ;
        double gap = Determinant.rounded(ax, ay, az, bx, by, bz, cx, cy, cz);
        double gapError = 32 * margin * size * size;
        double error = 8 * margin * size;
        if (!(Math.abs(gap) > gapError)) {
            sight.set(Cover.SOME, from, Double.POSITIVE_INFINITY);
            return;
        }
        double sign = gap > 0 ? 1 : -1;
        least = Double.POSITIVE_INFINITY;
        most = Double.POSITIVE_INFINITY;
        addEdge(ax, ay, az, bx, by, bz, sign);
        addEdge(bx, by, bz, cx, cy, cz, sign);
        addEdge(cx, cy, cz, ax, ay, az, sign);
        if (most < -error) {
            sight.cover = Cover.NONE;
            return;
        }
        setPlane(triangle, Math.abs(gap), gapError, sign, least > error ? Cover.ALL : Cover.SOME, from, sight);
    }

    /** Lowers the least and the most to those of the cone's directions with the normal of the plane through eye and edge. */
    private void addEdge(double ax, double ay, double az, double bx, double by, double bz, double sign) {
        double x = sign * (ay * bz - az * by);
        double y = sign * (az * bx - ax * bz);
        double z = sign * (ax * by - ay * bx);
        double along = cone.along(x, y, z);
        double across = cone.across(x, y, z);
        least = Math.min(least, cone.leastProduct(along, across));
        most = Math.min(most, cone.mostProduct(along, across, Vector.length(x, y, z)));
    }

    /** Rays meet the plane at gap over the product with the normal. */
    private void setPlane(Triangle triangle, double gap, double gapError, double sign, Cover cover, double from, Sight sight) {
        double ux = triangle.bx() - triangle.ax();
        double uy = triangle.by() - triangle.ay();
        double uz = triangle.bz() - triangle.az();
        double vx = triangle.cx() - triangle.ax();
        double vy = triangle.cy() - triangle.ay();
        double vz = triangle.cz() - triangle.az();
        double x = sign * (uy * vz - uz * vy);
        double y = sign * (uz * vx - ux * vz);
        double z = sign * (ux * vy - uy * vx);
        double along = cone.along(x, y, z);
        double across = cone.across(x, y, z);
        double error = 8 * Sight.ROUNDING * Vector.largestPart(ux, uy, uz) * Vector.largestPart(vx, vy, vz);
        double leastProduct = cone.leastProduct(along, across) - error;
        double mostProduct = cone.mostProduct(along, across, Vector.length(x, y, z)) + error;
        double nearest = mostProduct > 0 ? Math.max(from, (1 - Sight.ROUNDING) * (gap - gapError) / mostProduct) : from;
        sight.set(cover, nearest,
            leastProduct > 0 ? (1 + Sight.ROUNDING) * (gap + gapError) / leastProduct : Double.POSITIVE_INFINITY);
        double doubt = gapError / gap;
        if (doubt < CERTAIN) {
            double per = 1 / gap;
            double length = Vector.length(x, y, z);
            sight.setFlat(x * per, y * per, z * per, per * (2 * doubt * length + 2 * error + Sight.ROUNDING * length));
        }
    }
}
