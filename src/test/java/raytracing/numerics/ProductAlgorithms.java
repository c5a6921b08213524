package raytracing.numerics;

import raytracing.math.Vector;
import raytracing.surface.Box;
import raytracing.surface.Departure;
import raytracing.surface.HitRecord;
import raytracing.surface.OutwardNormal;
import raytracing.surface.Plane;
import raytracing.surface.RayOrigin;
import raytracing.surface.RayRecord;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;
import raytracing.surface.SurfaceQuestions;

/** Every question that these tests ask the product about crossings goes through here. */
final class ProductAlgorithms {
    static final Formula SPHERE = ProductAlgorithms::sphere;
    static final Formula PLANE = ProductAlgorithms::plane;
    static final Formula BOX = ProductAlgorithms::box;

    private ProductAlgorithms() {
    }

    private static double sphere(double ox, double oy, double oz, double dx, double dy, double dz,
                                 double cx, double cy, double cz, double r) {
        return firstCrossing(new Sphere(new Vector(cx, cy, cz), r, 0), ox, oy, oz, dx, dy, dz);
    }

    private static double plane(double ox, double oy, double oz, double dx, double dy, double dz,
                                double nx, double ny, double nz, double c) {
        return firstCrossing(new Plane(new Vector(nx, ny, nz), c, 0), ox, oy, oz, dx, dy, dz);
    }

    private static double box(double ox, double oy, double oz, double dx, double dy, double dz,
                              double cx, double cy, double cz, double edge) {
        return firstCrossing(new Box(new Vector(cx, cy, cz), edge, 0), ox, oy, oz, dx, dy, dz);
    }

    private static double firstCrossing(Surface surface, double ox, double oy, double oz, double dx, double dy, double dz) {
        RayRecord ray = new RayRecord(new Vector(ox, oy, oz), 0, new Vector(dx, dy, dz), RayOrigin.NO_SURFACE,
            Departure.ELSEWHERE);
        return SurfaceQuestions.firstCrossing(surface, ray, Departure.ELSEWHERE);
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
        return HitRecord.at(surface, rayTo(surface, query, t), t, 0).point();
    }

    static Vector outwardNormal(Surface surface, Query query, double t) {
        return OutwardNormal.of(surface, rayTo(surface, query, t), t);
    }

    /** A ray that meets a surface at t; behind its first crossing, one that is known to be inside. */
    private static RayRecord rayTo(Surface surface, Query query, double t) {
        RayRecord ray = ray(query);
        return SurfaceQuestions.firstCrossing(surface, ray, Departure.ELSEWHERE) < t
            ? new RayRecord(ray.origin(), 0, ray.direction(), 0, Departure.INWARD) : ray;
    }

    /** One whose origin is exactly where it says. */
    private static RayRecord ray(Query query) {
        return new RayRecord(query.origin(), 0, query.direction(), RayOrigin.NO_SURFACE, Departure.ELSEWHERE);
    }
}
