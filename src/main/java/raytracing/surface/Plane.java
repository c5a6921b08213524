package raytracing.surface;

import java.util.Optional;
import raytracing.math.CompensatedSum;
import raytracing.math.Fused;
import raytracing.math.Surd;
import raytracing.math.UnitVector;
import raytracing.math.Vector;

/**
 * The scene line {@code pln}: the points P with P . normal = offset, endless and with two sides. The normal is kept
 * as the scene wrote it, for making it a unit vector would move the plane by a rounding.
 *
 * <p>A ray o + t d meets the plane N . P = c at t = (c - N . o) / (N . d): its gap over its approach. A bound on their
 * errors, known beforehand, tells whether plain doubles decide and are accurate; if they are not, compensated sums may
 * be; what these leave open is undecided, and {@link ExactPlane} decides. So no decision is wrong, whatever finite
 * numbers come, and a crossing's error is at most 16 ulp (both proved below). In these proofs u = 2^-53.
 *
 * @param normal perpendicular to the plane; any length but 0
 * @param offset the dot product that its points share: distance from the world's origin times |normal|
 * @param material number of its material, from 0
 */
public record Plane(Vector normal, double offset, int material) implements Surface {
    /**
     * Fused multiply-adds round gap and approach three times each, by at most u times what they have just summed up.
     * So with S and T, the sizes of the first two of these sums, the crossing's error is at most u (S / |gap| + T /
     * |approach| + 3): at most 15.9 u if S + T |t| is below this times |gap|. The signs are beyond doubt then.
     */
    private static final double CLEAR = 12.875;

    /**
     * 8 u: the error of a gap or of an approach is at most 4 u times the sum of its terms' sizes (proved: a rounding
     * for each product and each sum). Beyond it, a compensated sum, whose error is 2^-102 times that and a rounding,
     * is off by 2 u.
     */
    private static final double ERROR = 0x1p-50;

    /** Above the error of a compensated sum but for its last rounding, 2^-102 times the sum of its terms' sizes. */
    private static final double COMPENSATED_ERROR = 0x1p-100;

    /** Sums of products above this carry no trace of subnormal products. */
    private static final double SMALL = 0x1p-1010;

    /** Nor does their quotient. */
    private static final double SMALLEST = Double.MIN_NORMAL;

    @Override
    public double firstCrossing(Ray ray, double latest) {
        RayOrigin o = ray.origin;
        double nx = normal.x();
        double ny = normal.y();
        double nz = normal.z();
        double gapZ = Fused.multiplyAdd(-nz, o.z, offset);
        double gapYz = Fused.multiplyAdd(-ny, o.y, gapZ);
        double gap = Fused.multiplyAdd(-nx, o.x, gapYz);
        double approachZ = nz * ray.dz;
        double approachYz = Fused.multiplyAdd(ny, ray.dy, approachZ);
        double approach = Fused.multiplyAdd(nx, ray.dx, approachYz);
        double t = gap / approach;
        double onPlane = o.error * size(nx, ny, nz);
        double rounded = Math.abs(gapZ) + Math.abs(gapYz) + (16 * onPlane + SMALL);
        double approachRounded = Math.abs(approachZ) + Math.abs(approachYz) + SMALL;
        if (rounded + approachRounded * Math.abs(t) < CLEAR * Math.abs(gap) && Math.abs(t) > SMALLEST) {
            return t > 0 ? t : MISS;
        }
        return compensatedCrossing(ray, onPlane);
    }

    /** For a ray nearly along the plane, or an origin close to it. */
    private double compensatedCrossing(Ray ray, double onPlane) {
        RayOrigin o = ray.origin;
        double nx = normal.x();
        double ny = normal.y();
        double nz = normal.z();
        double gap = CompensatedSum.ofProducts(offset, -nx, -ny, -nz, o.x, o.y, o.z);
        double approach = CompensatedSum.ofProducts(0, nx, ny, nz, ray.dx, ray.dy, ray.dz);
        double gapError = ERROR * (size(nx * o.x, ny * o.y, nz * o.z) + Math.abs(offset)) + (2 * onPlane + SMALL);
        double approachError = ERROR * size(nx * ray.dx, ny * ray.dy, nz * ray.dz) + SMALL;
        if (Math.abs(gap) > gapError && Math.abs(approach) > approachError) {
            double t = gap / approach;
            return t > SMALLEST && t < MISS ? t : t < 0 ? MISS : UNDECIDED;
        }
        return UNDECIDED;
    }

    @Override
    public Optional<Surd> exactCrossing(Ray ray, int number) {
        return ray.origin.surface == number ? Optional.empty() : ExactPlane.of(this).firstCrossing(ray, number);
    }

    @Override
    public boolean isCrossed(Segment segment, int number) {
        RayOrigin start = segment.start;
        int side = side(start.x, start.y, start.z, start.error);
        int endSide = side(segment.endX, segment.endY, segment.endZ, segment.endError);
        return side == 0 || endSide == 0 ? isCrossedExactly(segment, number) : side != endSide;
    }

    /** 1 where the normal points, -1 on the other side, 0 if doubles cannot tell or the point's own error leaves it open. */
    private int side(double px, double py, double pz, double pointError) {
        double nx = normal.x();
        double ny = normal.y();
        double nz = normal.z();
        double ax = nx * px;
        double ay = ny * py;
        double az = nz * pz;
        double gap = offset - (ax + ay + az);
        double error = ERROR * (size(ax, ay, az) + Math.abs(offset)) + (2 * pointError * size(nx, ny, nz) + SMALL);
        return !(Math.abs(gap) > error) ? 0 : gap < 0 ? 1 : -1;
    }

    private boolean isCrossedExactly(Segment segment, int number) {
        if (isOnPlane(segment.endX, segment.endY, segment.endZ, segment.endError)) {
            return false;                    // a lamp on a wall, which many segments lead to
        }
        ExactPlane exact = ExactPlane.of(this);
        return exact.side(segment.start, number) * exact.side(segment.end(), segment.endError) < 0;
    }

    /** Whether a point is certainly on the plane within its error; false also if doubles cannot tell. */
    private boolean isOnPlane(double px, double py, double pz, double pointError) {
        double nx = normal.x();
        double ny = normal.y();
        double nz = normal.z();
        double gap = CompensatedSum.ofProducts(offset, -nx, -ny, -nz, px, py, pz);
        double error = COMPENSATED_ERROR * (size(nx * px, ny * py, nz * pz) + Math.abs(offset)) + SMALL;
        double spread = pointError * size(nx, ny, nz);
        return spread < MISS && Math.abs(gap) + error <= (1 - ERROR) * spread;
    }

    private static double size(double x, double y, double z) {
        return Math.abs(x) + Math.abs(y) + Math.abs(z);
    }

    @Override
    public int side(RayOrigin point, int number) {
        return ExactPlane.of(this).side(point, number);
    }

    @Override
    public boolean isInPlaceOf(Surface other) {
        return other instanceof Plane plane && offset == plane.offset && normal.isSameAs(plane.normal);
    }

    /** The point along the ray is dropped onto the plane: from far away, rounding leaves it beside. */
    @Override
    public void describe(Ray ray, int number, double distance, Hit hit) {
        UnitVector n = hit.normal;
        n.set(normal.x(), normal.y(), normal.z());
        if (distance > 0) {
            double x = ray.origin.x + distance * ray.dx;
            double y = ray.origin.y + distance * ray.dy;
            double z = ray.origin.z + distance * ray.dz;
            double gap = (offset - (normal.x() * x + normal.y() * y + normal.z() * z)) / normal.length();
            double drop = Math.abs(gap) < MISS ? gap : 0;
            hit.placeAlong(ray, distance * Vector.largestPart(ray.dx, ray.dy, ray.dz),
                x + drop * n.x(), y + drop * n.y(), z + drop * n.z());
        } else {
            hit.placeAtOrigin(ray);
        }
        double along = n.dot(ray.dx, ray.dy, ray.dz);
        boolean isSeenFromBelow = distance > 0 && Hit.isClear(along, ray) ? along > 0 : side(ray.origin, number) < 0;
        hit.reach(ray, number, isSeenFromBelow ? Departure.INWARD : Departure.OUTWARD);
    }

    @Override
    public <R> R accept(Visitor<R> visitor) {
        return visitor.visit(this);
    }
}
