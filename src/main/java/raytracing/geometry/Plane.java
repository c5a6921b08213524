package raytracing.geometry;

import java.util.Optional;
import raytracing.math.Surd;
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
    public Optional<Surd> crossing(Standpoint origin, int number, Vector direction) {
        return origin.surface() == number ? Optional.empty()
            : ExactPlane.of(this).firstCrossing(origin, number, direction);
    }

    @Override
    public boolean isInPlaceOf(Surface other) {
        return other instanceof Plane plane && offset == plane.offset && normal.equals(plane.normal);
    }

    @Override
    public boolean isCrossedBetween(Standpoint start, int number, Vector end, double endError) {
        if (PlaneKernel.isOn(end.x(), end.y(), end.z(), endError, normal.x(), normal.y(), normal.z(), offset)) {
            return false;                    // a lamp on a wall, which many lines lead to
        }
        ExactPlane exact = ExactPlane.of(this);
        return exact.side(start, number) * exact.side(end, endError) < 0;
    }

    @Override
    public int side(Standpoint point, int number) {
        return ExactPlane.of(this).side(point, number);
    }

    @Override
    public double farWall(Standpoint origin, double dx, double dy, double dz) {
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
    public void describe(Standpoint origin, int number, double dx, double dy, double dz, double distance,
                         HitPoint found) {
        double scale = Vector.safeScale(normal.x(), normal.y(), normal.z());
        double factor = Vector.unitFactor(scale * normal.x(), scale * normal.y(), scale * normal.z());
        double nx = scale * normal.x() * factor;
        double ny = scale * normal.y() * factor;
        double nz = scale * normal.z() * factor;
        if (distance > 0) {
            double x = origin.x() + distance * dx;
            double y = origin.y() + distance * dy;
            double z = origin.z() + distance * dz;
            double gap = (offset - (normal.x() * x + normal.y() * y + normal.z() * z)) / normal.length();
            double drop = Math.abs(gap) < MISS ? gap : 0;
            found.placeAlong(origin, distance * Vector.largestPart(dx, dy, dz),
                x + drop * nx, y + drop * ny, z + drop * nz);
        } else {
            found.placeAt(origin);
        }
        double along = nx * dx + ny * dy + nz * dz;
        boolean isSeenFromBelow = distance > 0 && HitPoint.isClear(along, dx, dy, dz) ? along > 0 : side(origin, number) < 0;
        found.reach(nx, ny, nz, isSeenFromBelow ? Departure.INWARD : Departure.OUTWARD, number, origin);
    }

    @Override
    public void presentTo(Receiver receiver) {
        receiver.plane(this);
    }
}
