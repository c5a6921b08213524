package raytracing.numerics;

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

    /** The first crossing of a query. */
    default double firstCrossing(Query query) {
        Vector o = query.origin();
        Vector d = query.direction();
        Vector v = query.vector();
        return firstCrossing(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), v.x(), v.y(), v.z(), query.scalar());
    }
}
