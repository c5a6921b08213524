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
    public double farWall(double ox, double oy, double oz, double dx, double dy, double dz) {
        return MISS;
    }

    @Override
    public boolean isLeftBefore(double qx, double qy, double qz, double endError) {
        return false;
    }

    @Override
    public boolean isApartFrom(double x, double y, double z, double r) {
        return false;
    }

    /** The point along the ray, dropped onto the plane: from far away, rounding leaves it beside. */
    @Override
    public void describe(double ox, double oy, double oz, double dx, double dy, double dz, double distance,
                         HitPoint found) {
        double x = ox + distance * dx;
        double y = oy + distance * dy;
        double z = oz + distance * dz;
        double scale = Vector.safeScale(normal.x(), normal.y(), normal.z());
        double factor = Vector.unitFactor(scale * normal.x(), scale * normal.y(), scale * normal.z());
        double nx = scale * normal.x() * factor;
        double ny = scale * normal.y() * factor;
        double nz = scale * normal.z() * factor;
        double gap = (offset - (normal.x() * x + normal.y() * y + normal.z() * z)) / normal.length();
        double drop = Math.abs(gap) < MISS ? gap : 0;
        double error = PointError.ofCrossing(Vector.largestPart(ox, oy, oz) + distance * Vector.largestPart(dx, dy, dz));
        found.place(x + drop * nx, y + drop * ny, z + drop * nz, error);
        found.turn(nx, ny, nz, dx, dy, dz);
    }

    @Override
    public void presentTo(Receiver receiver) {
        receiver.plane(this);
    }
}
