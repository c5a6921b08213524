package raytracing.geometry;

import java.util.Optional;
import raytracing.math.Surd;
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
    public Optional<Surd> crossing(Standpoint origin, int number, Vector direction) {
        return origin.surface() == number && origin.side() == Departure.OUTWARD ? Optional.empty()
            : ExactSphere.of(this).firstCrossing(origin, number, direction);
    }

    @Override
    public boolean isInPlaceOf(Surface other) {
        return other instanceof Sphere sphere && radius == sphere.radius && centre.equals(sphere.centre);
    }

    @Override
    public boolean isCrossedBetween(Standpoint start, int number, Vector end, double endError) {
        Answer quick = isCrossedToWall(start, end, endError);
        return quick == Answer.UNDECIDED ? ExactSphere.of(this).isCrossedBetween(start, number, end, endError)
            : quick == Answer.YES;
    }

    /** For a lamp on the wall, which many lines lead to: from inside no line crosses it, from outside those through the ball do. */
    private Answer isCrossedToWall(Standpoint start, Vector end, double endError) {
        Answer startsOutside = SphereKernel.isOutside(start.x(), start.y(), start.z(), start.error(),
            centre.x(), centre.y(), centre.z(), radius);
        if (startsOutside == Answer.UNDECIDED || !SphereKernel.isOn(end.x(), end.y(), end.z(), endError,
                centre.x(), centre.y(), centre.z(), radius)) {
            return Answer.UNDECIDED;
        }
        Vector fromCentre = end.minus(centre);
        Vector line = end.minus(start.point());
        double outwards = fromCentre.dot(line);
        double doubt = ROUNDING * fromCentre.length() * line.length();
        boolean isClear = Math.abs(outwards) > doubt && doubt > Double.MIN_NORMAL;
        return startsOutside == Answer.NO || isClear && outwards < 0 ? Answer.NO : isClear ? Answer.YES : Answer.UNDECIDED;
    }

    @Override
    public int side(Standpoint point, int number) {
        return ExactSphere.of(this).side(point, number);
    }

    @Override
    public double farWall(Standpoint origin, double dx, double dy, double dz) {
        return SphereKernel.acrossFromInnerWall(origin.x(), origin.y(), origin.z(), dx, dy, dz,
            centre.x(), centre.y(), centre.z());
    }

    @Override
    public boolean isLeftBefore(double qx, double qy, double qz, double endError) {
        Answer quick = SphereKernel.isOutside(qx, qy, qz, endError, centre.x(), centre.y(), centre.z(), radius);
        return quick == Answer.UNDECIDED ? ExactSphere.of(this).side(new Vector(qx, qy, qz), endError) > 0
            : quick == Answer.YES;
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
    public void describe(Standpoint origin, int number, double dx, double dy, double dz, double distance,
                         HitPoint found) {
        double fx = origin.x() - centre.x() + distance * dx;
        double fy = origin.y() - centre.y() + distance * dy;
        double fz = origin.z() - centre.z() + distance * dz;
        if (!(Math.abs(fx) + Math.abs(fy) + Math.abs(fz) < MISS)) {
            describeAtAFraction(origin, number, dx, dy, dz, distance, found);
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
        placeAlong(origin, dx, dy, dz, distance, nx, ny, nz, found);
        double along = nx * dx + ny * dy + nz * dz;
        boolean isSeenFromInside = distance > 0 && HitPoint.isClear(along, dx, dy, dz) ? along > 0
            : side(origin, number) <= 0;
        found.reach(nx, ny, nz, isSeenFromInside ? Departure.INWARD : Departure.OUTWARD, number, origin);
    }

    private void placeAlong(Standpoint origin, double dx, double dy, double dz, double distance,
                            double nx, double ny, double nz, HitPoint found) {
        double way = distance * Vector.largestPart(dx, dy, dz);
        if (distance == 0) {
            found.placeAt(origin);
        } else if (centre.largestPart() + radius < Vector.largestPart(origin.x(), origin.y(), origin.z()) + way) {
            found.placeAlong(origin, way, centre.x() + radius * nx, centre.y() + radius * ny, centre.z() + radius * nz);
        } else {
            found.placeAlong(origin, way, origin.x() + distance * dx, origin.y() + distance * dy, origin.z() + distance * dz);
        }
    }

    /** The same for sums beyond all doubles, which are within them in a world a sixteenth as large. */
    private void describeAtAFraction(Standpoint origin, int number, double dx, double dy, double dz, double distance,
                                     HitPoint found) {
        Standpoint nearer = new Standpoint();
        nearer.start(FRACTION * origin.x(), FRACTION * origin.y(), FRACTION * origin.z(), FRACTION * origin.error(),
            origin.surface(), origin.side());
        new Sphere(centre.times(FRACTION), FRACTION * radius, material).describe(nearer, number, dx, dy, dz,
            FRACTION * distance, found);
        found.enlarge(1 / FRACTION, origin);
    }

    @Override
    public void presentTo(Receiver receiver) {
        receiver.sphere(this);
    }
}
