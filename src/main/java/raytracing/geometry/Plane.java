package raytracing.geometry;

import raytracing.math.AxisOrder;
import raytracing.math.Vector;

/**
 * The scene line {@code pln}: the points P with P . normal = offset, endless and with two sides. The normal is kept
 * as the scene wrote it, for making it a unit vector would move the plane by a rounding.
 *
 * @param normal perpendicular to the plane; any length but 0
 * @param offset the dot product that its points share: distance from the world's origin times |normal|
 * @param material number of its material, from 0
 */
public record Plane(Vector normal, double offset, int material) implements Surface {
    @Override
    public double firstCrossing(Ray ray, Departure departure) {
        if (departure != Departure.ELSEWHERE) {
            return MISS;                     // a straight line leaves a plane once
        }
        AxisOrder order = AxisOrder.of(ray.direction().x(), ray.direction().y(), ray.direction().z());
        Vector o = order.sorted(ray.origin());
        Vector d = order.sorted(ray.direction());
        Vector n = order.sorted(normal);
        return PlaneKernel.firstCrossing(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), ray.originError(),
            n.x(), n.y(), n.z(), offset);
    }

    @Override
    public boolean crosses(Segment segment, Departure departure) {
        if (departure != Departure.ELSEWHERE) {
            return false;
        }
        Vector p = segment.start();
        Vector q = segment.end();
        return PlaneKernel.crossesBetween(p.x(), p.y(), p.z(), segment.startError(),
            q.x(), q.y(), q.z(), segment.endError(), normal.x(), normal.y(), normal.z(), offset);
    }

    @Override
    public Vector outwardNormal(Ray ray, double distance) {
        return normal.unit();
    }

    /** The point along the ray, dropped onto the plane: from far away, rounding leaves it beside. */
    @Override
    public Vector point(Ray ray, double distance, Vector outwardNormal) {
        Vector beside = ray.origin().plus(distance, ray.direction());
        double gap = (offset - normal.dot(beside)) / normal.length();
        return Math.abs(gap) < MISS ? beside.plus(gap, outwardNormal) : beside;
    }

    @Override
    public void presentTo(Receiver receiver) {
        receiver.plane(this);
    }
}
