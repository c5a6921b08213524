package raytracing.geometry;

import raytracing.math.CompensatedSum;

/**
 * Ray-plane arithmetic on bare doubles, world axes. {@link Plane} and the compiled scene both call it.
 *
 * <p>A ray o + t d meets the plane N . P = c at t = (c - N . o) / (N . d): its gap over its approach. Doubles answer where
 * a bound on their errors, known beforehand, leaves no doubt of the signs; where more than a few bits have cancelled, with
 * compensated sums. {@link CarefulPlane} answers the rest. No decision is wrong (proved below, measured in {@code NumericsRowsTest}); a
 * crossing's error is at most 16 ulp (measured in {@code HardRaysTest}).
 */
public final class PlaneKernel {
    /** A sum so many times its error has lost at most 5 bits to cancellation, as this bound counts them: fewer in fact. */
    private static final double CLEAR = 0x1p45;

    /** The same for a compensated sum: its error is that of rounding its result. */
    private static final double CLEAR_IF_COMPENSATED = 0x1p4;

    /**
     * 8 u, with u = 2^-53: the error of a gap or of an approach is at most 5 u times the sum of its terms' sizes
     * (proved: a rounding for each product and each sum).
     */
    private static final double ERROR = 0x1p-50;

    /** Sums of products above this carry no trace of subnormal products. */
    private static final double SMALL = 0x1p-900;

    private PlaneKernel() {
    }

    /**
     * Crossing of the ray o + t d with a plane.
     *
     * @param ox origin, x part
     * @param oy y part
     * @param oz z part
     * @param dx direction, x part; not all three 0
     * @param dy y part
     * @param dz z part
     * @param originError how far each part of the origin may be off; if that leaves open on which side of the plane
     *        the ray starts, it starts on it
     * @param nx normal as the scene wrote it, x part; not all three 0
     * @param ny y part
     * @param nz z part
     * @param c offset
     * @return the crossing if it is above 0, else {@link Surface#MISS}, also for a ray that lies in the plane; never
     *         NaN
     */
    public static double firstCrossing(double ox, double oy, double oz, double dx, double dy, double dz,
                                       double originError, double nx, double ny, double nz, double c) {
        double gap = c - (nx * ox + ny * oy + nz * oz);
        double approach = nx * dx + ny * dy + nz * dz;
        double normalSize = size(nx, ny, nz);
        double gapError = normalSize * (ERROR * size(ox, oy, oz) + originError) + (ERROR * Math.abs(c) + SMALL);
        double approachError = normalSize * (ERROR * size(dx, dy, dz)) + SMALL;
        double gapSize = Math.abs(gap);
        double approachSize = Math.abs(approach);
        if (gapSize > CLEAR * gapError && approachSize > CLEAR * approachError) {
            double t = gap / approach;
            return t > 0 ? t : Surface.MISS;
        }
        if (gapSize > CLEAR_IF_COMPENSATED * gapError && approachSize > CLEAR_IF_COMPENSATED * approachError) {
            return gap > 0 == approach > 0 ? compensated(ox, oy, oz, dx, dy, dz, nx, ny, nz, c) : Surface.MISS;
        }
        return CarefulPlane.firstCrossing(ox, oy, oz, dx, dy, dz, originError, nx, ny, nz, c);
    }

    private static double compensated(double ox, double oy, double oz, double dx, double dy, double dz,
                                      double nx, double ny, double nz, double c) {
        return CompensatedSum.ofProducts(c, -nx, -ny, -nz, ox, oy, oz)
            / CompensatedSum.ofProducts(0, nx, ny, nz, dx, dy, dz);
    }

    /**
     * Whether the open line between two points crosses a plane. The answer is the same from either end.
     *
     * @param px one end, x part
     * @param py y part
     * @param pz z part
     * @param pointError how far each part of it may be off; within that of the plane, it lies on it
     * @param qx other end, x part
     * @param qy y part
     * @param qz z part
     * @param endError the same for the other end
     * @param nx normal, x part; not all three 0
     * @param ny y part
     * @param nz z part
     * @param c offset
     * @return true if the ends lie on different sides, neither of them on the plane
     */
    public static boolean crossesBetween(double px, double py, double pz, double pointError,
                                         double qx, double qy, double qz, double endError,
                                         double nx, double ny, double nz, double c) {
        double pointGap = c - (nx * px + ny * py + nz * pz);
        double endGap = c - (nx * qx + ny * qy + nz * qz);
        double normalSize = size(nx, ny, nz);
        double offsetError = ERROR * Math.abs(c) + SMALL;
        if (Math.abs(pointGap) > normalSize * (ERROR * size(px, py, pz) + pointError) + offsetError
                && Math.abs(endGap) > normalSize * (ERROR * size(qx, qy, qz) + endError) + offsetError) {
            return pointGap > 0 != endGap > 0;
        }
        return CarefulPlane.crossesBetween(px, py, pz, pointError, qx, qy, qz, endError, nx, ny, nz, c);
    }

    /** A vector's size, from 1 to sqrt(3) times its length. Of a ray's vectors, a loop over planes takes it once. */
    private static double size(double x, double y, double z) {
        return Math.abs(x) + Math.abs(y) + Math.abs(z);
    }
}
