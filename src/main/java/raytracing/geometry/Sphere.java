package raytracing.geometry;

import raytracing.math.AxisOrder;
import raytracing.math.Vector;

/**
 * The scene line {@code sph}: all points at one distance from a centre.
 *
 * @param centre its middle, world axes
 * @param radius above 0, finite
 * @param material number of its material, from 0
 */
public record Sphere(Vector centre, double radius, int material) implements Surface {
    @Override
    public double firstCrossing(Ray ray, Departure departure) {
        return switch (departure) {
            case ELSEWHERE -> firstCrossing(ray);
            case INWARD -> acrossFromInnerWall(ray.origin(), ray.direction());
            case OUTWARD -> MISS;
        };
    }

    private double acrossFromInnerWall(Vector o, Vector d) {
        return SphereKernel.acrossFromInnerWall(
            o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), centre.x(), centre.y(), centre.z());
    }

    private double firstCrossing(Ray ray) {
        AxisOrder order = AxisOrder.of(ray.direction().x(), ray.direction().y(), ray.direction().z());
        Vector o = order.sorted(ray.origin());
        Vector d = order.sorted(ray.direction());
        Vector c = order.sorted(centre);
        return SphereKernel.firstCrossing(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), ray.originError(),
            c.x(), c.y(), c.z(), radius);
    }

    @Override
    public boolean crosses(Segment segment, Departure departure) {
        Vector p = segment.start();
        Vector q = segment.end();
        return switch (departure) {
            case ELSEWHERE -> SphereKernel.crossesBetween(p.x(), p.y(), p.z(), segment.startError(),
                q.x(), q.y(), q.z(), segment.endError(), centre.x(), centre.y(), centre.z(), radius);
            case INWARD -> SphereKernel.isOutside(q.x(), q.y(), q.z(), segment.endError(),
                centre.x(), centre.y(), centre.z(), radius);
            case OUTWARD -> false;
        };
    }

    /**
     * Taken from (origin - centre) + t direction, which keeps its digits when both lie far from the world's origin. Of
     * a ball so small and far that nothing is left of this sum, the point nearest to the ray's origin is seen.
     */
    @Override
    public Vector outwardNormal(Ray ray, double distance) {
        Vector fromCentre = ray.origin().minus(centre).plus(distance, ray.direction());
        return fromCentre.isZero() ? ray.direction().negated().unit() : fromCentre.unit();
    }

    /** Reached from the ray's origin, or from the centre, whichever is nearer to the world's origin: so less is rounded. */
    @Override
    public Vector point(Ray ray, double distance, Vector outwardNormal) {
        double fromCentre = centre.largestPart() + radius;
        double alongRay = ray.origin().largestPart() + distance * ray.direction().largestPart();
        return fromCentre < alongRay
            ? centre.plus(radius, outwardNormal)
            : ray.origin().plus(distance, ray.direction());
    }

    @Override
    public void presentTo(Receiver receiver) {
        receiver.sphere(this);
    }
}
