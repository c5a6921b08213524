package raytracing.outline;

import raytracing.math.Vector;
import raytracing.outline.Sight.Cover;
import raytracing.surface.Plane;
import raytracing.surface.RayOrigin;

/**
 * The planes of a scene as they are seen from the eye, each against a cone. A ray meets a plane if it goes to its side,
 * which is exactly decided once for the eye; it does so at the eye's gap over the dot product with the unit normal. That
 * product is least and greatest on the mantle of the cone, unless the normal is inside. Not thread-safe.
 */
final class PlaneSight {
    /** 32 u, with u = 2^-53: of the terms of a gap, how much it may be off (proved: 6 roundings, and 4 u for the length of the normal). */
    private static final double GAP_ROUNDING = 0x1p-48;

    /** With a gap that is less certain than this, a plane has no useful flatness. */
    private static final double CERTAIN = 0x1p-10;

    private final SquareCone cone;

    /** For each plane, the unit normal towards the side where the eye is not; 0 for a plane that holds the eye. */
    private final double[] normals;

    /** Between which bounds the eye's distance from each plane is. */
    private final double[] leastGaps;
    private final double[] mostGaps;

    PlaneSight(SquareCone cone, Plane[] planes, int[] numbers, RayOrigin eye) {
        this.cone = cone;
        normals = new double[3 * planes.length];
        leastGaps = new double[planes.length];
        mostGaps = new double[planes.length];
        for (int i = 0; i < planes.length; i++) {
            Vector normal = planes[i].normal();
            Vector unit = normal.unit();
            int side = planes[i].side(eye, numbers[i]);
            normals[3 * i] = -side * unit.x();
            normals[3 * i + 1] = -side * unit.y();
            normals[3 * i + 2] = -side * unit.z();
            double x = normal.x() * eye.x();
            double y = normal.y() * eye.y();
            double z = normal.z() * eye.z();
            double length = normal.length();
            double gap = Math.abs(planes[i].offset() - (x + y + z)) / length;
            double error = (GAP_ROUNDING * (Math.abs(x) + Math.abs(y) + Math.abs(z) + Math.abs(planes[i].offset()))
                + Double.MIN_NORMAL) / length + GAP_ROUNDING * gap;
            boolean isKnown = error < Double.POSITIVE_INFINITY && gap < Double.POSITIVE_INFINITY;
            leastGaps[i] = isKnown ? Math.max(0, gap - error) : 0;
            mostGaps[i] = isKnown ? gap + error : Double.POSITIVE_INFINITY;
        }
    }

    void test(int plane, Sight sight) {
        double x = normals[3 * plane];
        double y = normals[3 * plane + 1];
        double z = normals[3 * plane + 2];
        double along = cone.along(x, y, z);
        double across = cone.across(x, y, z);
        double mostProduct = cone.mostProduct(along, across, 1);
        if (mostProduct < -Sight.ROUNDING || x == 0 && y == 0 && z == 0) {
            sight.cover = Cover.NONE;
            return;
        }
        double least = cone.leastProduct(along, across) - Sight.ROUNDING;
        double most = mostProduct + Sight.ROUNDING;
        double near = leastGaps[plane];
        double far = mostGaps[plane];
        double from = (1 - Sight.ROUNDING) * near / most;
        if (least > 0) {
            sight.set(Cover.ALL, from, (1 + Sight.ROUNDING) * far / least);
        } else {
            sight.set(Cover.SOME, from, Double.POSITIVE_INFINITY);
        }
        double doubt = (far - near) / near;
        if (doubt < CERTAIN) {
            double per = 1 / near;
            sight.setFlat(x * per, y * per, z * per, per * (doubt + Sight.ROUNDING));
        }
    }
}
