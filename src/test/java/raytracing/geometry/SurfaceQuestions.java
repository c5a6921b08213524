package raytracing.geometry;

import raytracing.math.Vector;

/**
 * What the loops over a scene's surfaces ask, put to a single one: doubles first, and exact numbers where these leave the
 * answer open.
 */
public final class SurfaceQuestions {
    private SurfaceQuestions() {
    }

    /**
     * Where a ray first meets a surface. A ray that starts inside a body meets its wall from inside.
     *
     * @param departure how the ray's origin lies to the surface
     */
    public static double firstCrossing(Surface surface, Ray ray, Departure departure) {
        double quick = quickCrossing(surface, ray, departure);
        if (!Double.isNaN(quick)) {
            return quick;
        }
        int number = departure == Departure.ELSEWHERE ? ray.surfaceLeft() + 1 : ray.surfaceLeft();
        Standpoint origin = new Standpoint();
        Vector o = ray.origin();
        origin.start(o.x(), o.y(), o.z(), ray.originError(), ray.surfaceLeft(), departure);
        return Surface.distance(surface.crossing(origin, number, ray.direction()));
    }

    /** The same in doubles alone. */
    static double quickCrossing(Surface surface, Ray ray, Departure departure) {
        Vector o = ray.origin();
        Vector d = ray.direction();
        if (departure == Departure.OUTWARD) {
            return Surface.MISS;
        }
        if (departure == Departure.INWARD) {
            Standpoint origin = new Standpoint();
            origin.start(o.x(), o.y(), o.z(), ray.originError(), ray.surfaceLeft(), departure);
            return surface.farWall(origin, d.x(), d.y(), d.z());
        }
        if (surface instanceof Sphere sphere) {
            Vector c = sphere.centre();
            return SphereKernel.firstCrossing(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), ray.originError(),
                c.x(), c.y(), c.z(), sphere.radius());
        }
        if (surface instanceof Box box) {
            Vector c = box.centre();
            return BoxKernel.firstCrossing(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), ray.originError(),
                c.x(), c.y(), c.z(), box.edge() / 2);
        }
        Plane plane = (Plane) surface;
        Vector n = plane.normal();
        return PlaneKernel.firstCrossing(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), ray.originError(),
            n.x(), n.y(), n.z(), plane.offset());
    }

    /**
     * Whether a surface lies in the way between two points.
     *
     * @param departure how the line's start lies to the surface
     */
    public static boolean crosses(Surface surface, Segment segment, Departure departure) {
        Vector p = segment.start();
        Vector q = segment.end();
        if (departure != Departure.ELSEWHERE) {
            return departure == Departure.INWARD && surface.isLeftBefore(q.x(), q.y(), q.z(), segment.endError());
        }
        Answer quick = quicklyCrosses(surface, segment);
        if (quick != Answer.UNDECIDED) {
            return quick == Answer.YES;
        }
        Standpoint start = new Standpoint();
        start.start(p.x(), p.y(), p.z(), segment.startError(), Ray.NO_SURFACE, Departure.ELSEWHERE);
        return surface.isCrossedBetween(start, 0, q, segment.endError());
    }

    /** The same in doubles alone, for a line that does not leave the surface. */
    static Answer quicklyCrosses(Surface surface, Segment segment) {
        Vector p = segment.start();
        Vector q = segment.end();
        double error = segment.startError();
        double endError = segment.endError();
        if (surface instanceof Sphere sphere) {
            Vector c = sphere.centre();
            return SphereKernel.crossesBetween(p.x(), p.y(), p.z(), error, q.x(), q.y(), q.z(), endError,
                c.x(), c.y(), c.z(), sphere.radius());
        }
        if (surface instanceof Box box) {
            Vector c = box.centre();
            return BoxKernel.crossesBetween(p.x(), p.y(), p.z(), error, q.x(), q.y(), q.z(), endError,
                c.x(), c.y(), c.z(), box.edge() / 2);
        }
        Plane plane = (Plane) surface;
        Vector n = plane.normal();
        return PlaneKernel.crossesBetween(p.x(), p.y(), p.z(), error, q.x(), q.y(), q.z(), endError,
            n.x(), n.y(), n.z(), plane.offset());
    }
}
