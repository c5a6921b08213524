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
import raytracing.geometry.Standpoint;
import raytracing.geometry.Surface;
import raytracing.geometry.SurfaceQuestions;
import raytracing.math.Vector;

/** Every question that these tests ask the product about crossings goes through here. */
final class ProductAlgorithms {
    static final Formula SPHERE = ProductAlgorithms::sphere;
    static final Formula PLANE = ProductAlgorithms::plane;
    static final Formula BOX = ProductAlgorithms::box;

    private ProductAlgorithms() {
    }

    /** As the product's loop over spheres asks: the quick question first, and exact numbers last. */
    private static double sphere(double ox, double oy, double oz, double dx, double dy, double dz,
                                 double cx, double cy, double cz, double r) {
        if (SphereKernel.isPlainlyMissed(ox, oy, oz, dx, dy, dz, 0, cx, cy, cz, r)) {
            return Formula.MISS;
        }
        double quick = SphereKernel.firstCrossing(ox, oy, oz, dx, dy, dz, 0, cx, cy, cz, r);
        return Double.isNaN(quick) ? exact(new Sphere(new Vector(cx, cy, cz), r, 0), ox, oy, oz, dx, dy, dz) : quick;
    }

    private static double plane(double ox, double oy, double oz, double dx, double dy, double dz,
                                double nx, double ny, double nz, double c) {
        double quick = PlaneKernel.firstCrossing(ox, oy, oz, dx, dy, dz, 0, nx, ny, nz, c);
        return Double.isNaN(quick) ? exact(new Plane(new Vector(nx, ny, nz), c, 0), ox, oy, oz, dx, dy, dz) : quick;
    }

    private static double box(double ox, double oy, double oz, double dx, double dy, double dz,
                              double cx, double cy, double cz, double edge) {
        double half = edge / 2;
        if (BoxKernel.isPlainlyMissed(ox, oy, oz, dx, dy, dz, Formula.MISS, 0, cx, cy, cz, half)) {
            return Formula.MISS;
        }
        double quick = BoxKernel.firstCrossing(ox, oy, oz, dx, dy, dz, 0, cx, cy, cz, half);
        return Double.isNaN(quick) ? exact(new Box(new Vector(cx, cy, cz), edge, 0), ox, oy, oz, dx, dy, dz) : quick;
    }

    private static double exact(Surface surface, double ox, double oy, double oz, double dx, double dy, double dz) {
        Standpoint origin = new Standpoint();
        origin.start(ox, oy, oz, 0, Ray.NO_SURFACE, Departure.ELSEWHERE);
        return Surface.distance(surface.crossing(origin, 0, new Vector(dx, dy, dz)));
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
            case BOX -> SurfaceQuestions.firstCrossing(box(query), ray(query), Departure.INWARD);
        };
    }

    static Vector hitPoint(Surface surface, Query query, double t) {
        return surface.hit(rayTo(surface, query, t), t, 0).point();
    }

    static Vector outwardNormal(Surface surface, Query query, double t) {
        return OutwardNormal.of(surface, rayTo(surface, query, t), t);
    }

    /** A ray that meets a surface at t; behind its first crossing, one that is known to be inside. */
    private static Ray rayTo(Surface surface, Query query, double t) {
        Ray ray = ray(query);
        return SurfaceQuestions.firstCrossing(surface, ray, Departure.ELSEWHERE) < t
            ? new Ray(ray.origin(), 0, ray.direction(), 0, Departure.INWARD) : ray;
    }

    /** One whose origin is exactly where it says. */
    private static Ray ray(Query query) {
        return new Ray(query.origin(), 0, query.direction(), Ray.NO_SURFACE, Departure.ELSEWHERE);
    }
}
