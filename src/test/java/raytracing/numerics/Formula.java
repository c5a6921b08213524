package raytracing.numerics;

import raytracing.math.AxisOrder;
import raytracing.math.Vector;

/**
 * A formula for the first crossing of the ray o + t d with a surface. Every surface is a vector and a scalar here, so
 * that one loop serves all shapes: centre and radius of a sphere, N and c of the plane N . P = c, centre and edge of a
 * box, which is a closed cube along the axes with its faces at centre -/+ edge / 2.
 */
@FunctionalInterface
public interface Formula {
    /** No crossing. */
    double MISS = Double.POSITIVE_INFINITY;

    /**
     * The smallest t above 0 with o + t d on the surface, or {@link #MISS}.
     *
     * @param x the surface's vector, x part
     * @param scalar the surface's radius, offset or edge
     */
    double firstCrossing(double ox, double oy, double oz, double dx, double dy, double dz,
                         double x, double y, double z, double scalar);

    /** In which order the formula wants the axes of a ray's queries. */
    default AxisOrder order(double dx, double dy, double dz) {
        return AxisOrder.Z_LAST;
    }

    /** The first crossing of a query, in the formula's order of axes. */
    default double firstCrossing(Query query) {
        Vector o = query.origin();
        Vector d = query.direction();
        Vector v = query.vector();
        double s = query.scalar();
        return switch (order(d.x(), d.y(), d.z())) {
            case X_LAST -> firstCrossing(o.y(), o.z(), o.x(), d.y(), d.z(), d.x(), v.y(), v.z(), v.x(), s);
            case Y_LAST -> firstCrossing(o.z(), o.x(), o.y(), d.z(), d.x(), d.y(), v.z(), v.x(), v.y(), s);
            case Z_LAST -> firstCrossing(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), v.x(), v.y(), v.z(), s);
        };
    }
}
