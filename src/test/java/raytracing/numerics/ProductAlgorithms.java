package raytracing.numerics;

import raytracing.geometry.Box;
import raytracing.geometry.BoxKernel;
import raytracing.geometry.Departure;
import raytracing.geometry.OutwardNormal;
import raytracing.geometry.Plane;
import raytracing.geometry.PlaneKernel;
import raytracing.geometry.Ray;
import raytracing.geometry.Sphere;
import raytracing.geometry.SphereKernel;
import raytracing.geometry.Surface;
import raytracing.math.AxisOrder;
import raytracing.math.Vector;

/** Every question that these tests ask the product about crossings goes through here. */
final class ProductAlgorithms {
    static final Formula SPHERE = (InTheRaysOrder) ProductAlgorithms::sphere;
    static final Formula PLANE = (InTheRaysOrder) ProductAlgorithms::plane;
    static final Formula BOX = ProductAlgorithms::box;

    private ProductAlgorithms() {
    }

    /** As the product's loops ask: on axes sorted by the ray, its main axis last. */
    private interface InTheRaysOrder extends Formula {
        @Override
        default AxisOrder order(double dx, double dy, double dz) {
            return AxisOrder.of(dx, dy, dz);
        }
    }

    /** As the product's loop over spheres asks: the quick question first. */
    private static double sphere(double ox, double oy, double oz, double dx, double dy, double dz,
                                 double cx, double cy, double cz, double r) {
        return SphereKernel.isPlainlyMissed(ox, oy, oz, dx, dy, dz, cx, cy, cz, r)
            ? Formula.MISS
            : SphereKernel.firstCrossing(ox, oy, oz, dx, dy, dz, 0, cx, cy, cz, r);
    }

    private static double plane(double ox, double oy, double oz, double dx, double dy, double dz,
                                double nx, double ny, double nz, double c) {
        return PlaneKernel.firstCrossing(ox, oy, oz, dx, dy, dz, 0, nx, ny, nz, c);
    }

    private static double box(double ox, double oy, double oz, double dx, double dy, double dz,
                              double cx, double cy, double cz, double edge) {
        double half = edge / 2;
        return BoxKernel.isPlainlyMissed(ox, oy, oz, dx, dy, dz, Formula.MISS, 0, cx, cy, cz, half)
            ? Formula.MISS
            : BoxKernel.firstCrossing(ox, oy, oz, dx, dy, dz, 0, cx, cy, cz, half);
    }

    static Surface sphere(Query query) {
        return new Sphere(query.vector(), query.scalar(), 0);
    }

    static Surface plane(Query query) {
        return new Plane(query.vector(), query.scalar(), 0);
    }

    static Surface box(Query query) {
        return new Box(query.vector(), query.scalar(), 0);
    }

    /**
     * The second crossing of a query, or {@link Formula#MISS}: of a sphere, the first one of a ray that starts between
     * the two; of a box, where a ray leaves it that is known to be inside.
     *
     * @param between where on the ray to start, behind the first crossing
     */
    static double secondCrossing(Shape shape, Query query, double between) {
        return switch (shape) {
            case SPHERE -> between + shape.ours().formula().firstCrossing(query.startingAt(between));
            case PLANE -> Formula.MISS;
            case BOX -> box(query).firstCrossing(ray(query), Departure.INWARD);
        };
    }

    static Vector hitPoint(Surface surface, Query query, double t) {
        return surface.hit(ray(query), t, 0).point();
    }

    static Vector outwardNormal(Surface surface, Query query, double t) {
        return OutwardNormal.of(surface, ray(query), t);
    }

    /** One whose origin is exactly where it says. */
    private static Ray ray(Query query) {
        return new Ray(query.origin(), 0, query.direction(), Ray.NO_SURFACE, Departure.ELSEWHERE);
    }
}
