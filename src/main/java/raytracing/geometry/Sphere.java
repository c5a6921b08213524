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
    /** Far above the 4 ulp of a distance. */
    private static final double ROUNDING = 0x1p-48;

    /** Three numbers that are doubles add up to one at this fraction of their size. */
    private static final double FRACTION = 0x1p-4;

    @Override
    public double firstCrossing(Ray ray, Departure departure) {
        return switch (departure) {
            case ELSEWHERE -> firstCrossing(ray);
            case INWARD -> farWall(ray.origin().x(), ray.origin().y(), ray.origin().z(),
                ray.direction().x(), ray.direction().y(), ray.direction().z());
            case OUTWARD -> MISS;
        };
    }

    @Override
    public double farWall(double ox, double oy, double oz, double dx, double dy, double dz) {
        return SphereKernel.acrossFromInnerWall(ox, oy, oz, dx, dy, dz, centre.x(), centre.y(), centre.z());
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
            case INWARD -> isLeftBefore(q.x(), q.y(), q.z(), segment.endError());
            case OUTWARD -> false;
        };
    }

    @Override
    public boolean isLeftBefore(double qx, double qy, double qz, double endError) {
        return SphereKernel.isOutside(qx, qy, qz, endError, centre.x(), centre.y(), centre.z(), radius);
    }

    @Override
    public boolean isApartFrom(double x, double y, double z, double r) {
        return Vector.length(x - centre.x(), y - centre.y(), z - centre.z()) > (1 + ROUNDING) * (radius + r);
    }

    /**
     * The normal is taken from (origin - centre) + t direction, which keeps its digits when both lie far from the world's
     * origin. Of a ball so small and far that nothing is left of this sum, the point nearest to the ray's origin is
     * seen. The point is reached from the ray's origin or from the centre, whichever is nearer to the world's origin: so
     * less is rounded.
     */
    @Override
    public void describe(double ox, double oy, double oz, double dx, double dy, double dz, double distance,
                         HitPoint found) {
        double fx = ox - centre.x() + distance * dx;
        double fy = oy - centre.y() + distance * dy;
        double fz = oz - centre.z() + distance * dz;
        if (!(Math.abs(fx) + Math.abs(fy) + Math.abs(fz) < MISS)) {
            describeAtAFraction(ox, oy, oz, dx, dy, dz, distance, found);
            return;
        }
        boolean isNearest = fx == 0 && fy == 0 && fz == 0;
        double gx = isNearest ? -dx : fx;
        double gy = isNearest ? -dy : fy;
        double gz = isNearest ? -dz : fz;
        double scale = Vector.safeScale(gx, gy, gz);
        double factor = Vector.unitFactor(scale * gx, scale * gy, scale * gz);
        double nx = scale * gx * factor;
        double ny = scale * gy * factor;
        double nz = scale * gz * factor;
        double fromCentre = centre.largestPart() + radius;
        double alongRay = Vector.largestPart(ox, oy, oz) + distance * Vector.largestPart(dx, dy, dz);
        double error = PointError.ofCrossing(alongRay);
        if (fromCentre < alongRay) {
            found.place(centre.x() + radius * nx, centre.y() + radius * ny, centre.z() + radius * nz, error);
        } else {
            found.place(ox + distance * dx, oy + distance * dy, oz + distance * dz, error);
        }
        found.turn(nx, ny, nz, dx, dy, dz);
    }

    /** The same for sums beyond all doubles, which are within them in a world a sixteenth as large. */
    private void describeAtAFraction(double ox, double oy, double oz, double dx, double dy, double dz, double distance,
                                     HitPoint found) {
        new Sphere(centre.times(FRACTION), FRACTION * radius, material).describe(
            FRACTION * ox, FRACTION * oy, FRACTION * oz, dx, dy, dz, FRACTION * distance, found);
        found.enlarge(1 / FRACTION);
    }

    @Override
    public void presentTo(Receiver receiver) {
        receiver.sphere(this);
    }
}
