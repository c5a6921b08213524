package raytracing.geometry;

import raytracing.math.CompensatedSum;

/**
 * Ray-plane arithmetic on bare doubles, world axes. {@link Plane} and the compiled scene both call it.
 *
 * <p>A ray o + t d meets the plane N . P = c at t = (c - N . o) / (N . d): its gap over its approach. A bound on their
 * errors, known beforehand, tells whether plain doubles decide and are accurate; if they are not, compensated sums may
 * be; what these leave open is undecided, and {@link ExactPlane} answers. So no decision is wrong, whatever finite
 * numbers come, and a crossing's error is at most 16 ulp (both proved below). In these proofs u = 2^-53.
 */
public final class PlaneKernel {
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
     *        the ray starts, the answer is left open
     * @param nx normal as the scene wrote it, x part; not all three 0
     * @param ny y part
     * @param nz z part
     * @param c offset
     * @return the crossing if it is above 0, {@link Surface#MISS} if it is below, or {@link Surface#UNDECIDED}
     */
    public static double firstCrossing(double ox, double oy, double oz, double dx, double dy, double dz,
                                       double originError, double nx, double ny, double nz, double c) {
        double gapZ = Math.fma(-nz, oz, c);
        double gapYz = Math.fma(-ny, oy, gapZ);
        double gap = Math.fma(-nx, ox, gapYz);
        double approachZ = nz * dz;
        double approachYz = Math.fma(ny, dy, approachZ);
        double approach = Math.fma(nx, dx, approachYz);
        double t = gap / approach;
        double onPlane = originError * size(nx, ny, nz);
        double rounded = Math.abs(gapZ) + Math.abs(gapYz) + (16 * onPlane + SMALL);
        double approachRounded = Math.abs(approachZ) + Math.abs(approachYz) + SMALL;
        if (rounded + approachRounded * Math.abs(t) < CLEAR * Math.abs(gap) && Math.abs(t) > SMALLEST) {
            return t > 0 ? t : Surface.MISS;
        }
        return compensatedCrossing(ox, oy, oz, dx, dy, dz, onPlane, nx, ny, nz, c);
    }

    /** For a ray nearly along the plane, or an origin close to it. */
    private static double compensatedCrossing(double ox, double oy, double oz, double dx, double dy, double dz,
                                              double onPlane, double nx, double ny, double nz, double c) {
        double gap = CompensatedSum.ofProducts(c, -nx, -ny, -nz, ox, oy, oz);
        double approach = CompensatedSum.ofProducts(0, nx, ny, nz, dx, dy, dz);
        double gapError = ERROR * (size(nx * ox, ny * oy, nz * oz) + Math.abs(c)) + (2 * onPlane + SMALL);
        double approachError = ERROR * size(nx * dx, ny * dy, nz * dz) + SMALL;
        if (Math.abs(gap) > gapError && Math.abs(approach) > approachError) {
            double t = gap / approach;
            return t > SMALLEST && t < Surface.MISS ? t : t < 0 ? Surface.MISS : Surface.UNDECIDED;
        }
        return Surface.UNDECIDED;
    }

    /**
     * Whether the open line between two points crosses a plane. The answer is the same from either end.
     *
     * @param px one end, x part
     * @param py y part
     * @param pz z part
     * @param pointError how far each part of it may be off; within that of the plane, the answer is left open
     * @param qx other end, x part
     * @param qy y part
     * @param qz z part
     * @param endError the same for the other end
     * @param nx normal, x part; not all three 0
     * @param ny y part
     * @param nz z part
     * @param c offset
     * @return whether the ends lie on different sides, if neither of them may lie on the plane
     */
    public static Answer crossesBetween(double px, double py, double pz, double pointError,
                                         double qx, double qy, double qz, double endError,
                                         double nx, double ny, double nz, double c) {
        int side = side(nx * px, ny * py, nz * pz, pointError, nx, ny, nz, c);
        int endSide = side(nx * qx, ny * qy, nz * qz, endError, nx, ny, nz, c);
        return side == 0 || endSide == 0 ? Answer.UNDECIDED : side == endSide ? Answer.NO : Answer.YES;
    }

    /**
     * 1 where the normal points, -1 on the other side, 0 if doubles cannot tell or the point's own error leaves it
     * open.
     */
    private static int side(double ax, double ay, double az, double pointError,
                            double nx, double ny, double nz, double c) {
        double gap = c - (ax + ay + az);
        double error = ERROR * (size(ax, ay, az) + Math.abs(c)) + (2 * pointError * size(nx, ny, nz) + SMALL);
        return !(Math.abs(gap) > error) ? 0 : gap < 0 ? 1 : -1;
    }

    /**
     * Whether a point is certainly on a plane, within its error.
     *
     * @param px point, x part
     * @param py y part
     * @param pz z part
     * @param pointError how far each part of it may be off
     * @param nx normal, x part; not all three 0
     * @param ny y part
     * @param nz z part
     * @param c offset
     * @return false also if doubles cannot tell
     */
    static boolean isOn(double px, double py, double pz, double pointError, double nx, double ny, double nz, double c) {
        double gap = CompensatedSum.ofProducts(c, -nx, -ny, -nz, px, py, pz);
        double error = COMPENSATED_ERROR * (size(nx * px, ny * py, nz * pz) + Math.abs(c)) + SMALL;
        return Math.abs(gap) + error <= (1 - ERROR) * (pointError * size(nx, ny, nz));
    }

    private static double size(double x, double y, double z) {
        return Math.abs(x) + Math.abs(y) + Math.abs(z);
    }
}
