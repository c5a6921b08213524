package raytracing.geometry;

import raytracing.math.DoubleDouble;
import raytracing.math.Vector;

/**
 * Ray-box arithmetic on bare doubles, world axes, by slabs: the ray is inside the cube while it is between all three
 * pairs of faces (Kay, Kajiya, Ray Tracing Complex Scenes, SIGGRAPH 1986, section 4). {@link Box} and the compiled scene
 * both call it.
 *
 * <p>The faces lie at the real numbers c - h and c + h, which need not be doubles: a box stored as two rounded corners
 * would be another box. Doubles decide where the times at which the ray passes the faces are further apart than their
 * errors; {@link CarefulBox} decides the rest. Then the way to the one face that counts is summed with a single
 * rounding and divided by the direction. No decision is wrong, so no ray slips between two boxes that share a face
 * (proved below, measured in {@code NumericsRowsTest}); a crossing's error is at most 2 ulp (proved: a rounding for the
 * sum and one for the quotient).
 */
public final class BoxKernel {
    /**
     * 8 u, with u = 2^-53. A time at which a ray passes a face's plane is (m -+ h) / |d|, with m the way to the middle. Its
     * error is at most 4 u times |m| + h over |d| (proved: a rounding each for m, the sum, the reciprocal and the product),
     * and |m| + h is at most the time itself plus twice h / |d|.
     */
    private static final double ERROR = 0x1p-50;

    private BoxKernel() {
    }

    /**
     * Whether a line plainly passes a cube, for loops to ask first: the times at which it passes the
     * faces differ by more than their errors.
     *
     * @param ox a point of the line, x part
     * @param oy y part
     * @param oz z part
     * @param dx direction, x part; not all three 0
     * @param dy y part
     * @param dz z part
     * @param latest the last t that matters, above 0
     * @param error how far each part of the points at t = 0 and at {@code latest} may be off
     * @param cx centre, x part
     * @param cy y part
     * @param cz z part
     * @param h half the edge, above 0
     * @return true only if o + t d is outside the cube for all t from 0 to {@code latest}, both included
     */
    public static boolean isPlainlyMissed(double ox, double oy, double oz, double dx, double dy, double dz,
                                          double latest, double error, double cx, double cy, double cz, double h) {
        double mx = Math.copySign(1, dx) * (cx - ox);
        double my = Math.copySign(1, dy) * (cy - oy);
        double mz = Math.copySign(1, dz) * (cz - oz);
        double grown = h + margin(h, error);
        double ix = 1 / Math.abs(dx);
        double iy = 1 / Math.abs(dy);
        double iz = 1 / Math.abs(dz);
        double entry = greatest((mx - grown) * ix, (my - grown) * iy, (mz - grown) * iz);
        double exit = least((mx + grown) * ix, (my + grown) * iy, (mz + grown) * iz);
        double slack = slack(exit, h, error, largestFinite(ix, iy, iz));
        return entry > exit + slack || exit < -slack || entry > latest + slack;
    }

    /**
     * First crossing of the ray o + t d with a cube.
     *
     * @param ox origin, x part
     * @param oy y part
     * @param oz z part
     * @param dx direction, x part; not all three 0
     * @param dy y part
     * @param dz z part
     * @param originError how far each part of the origin may be off; within that of a face's plane, it lies on it
     * @param cx centre, x part
     * @param cy y part
     * @param cz z part
     * @param h half the edge, above 0
     * @return smallest crossing above 0, or {@link Surface#MISS}; never NaN; a touching ray hits
     */
    public static double firstCrossing(double ox, double oy, double oz, double dx, double dy, double dz,
                                       double originError, double cx, double cy, double cz, double h) {
        // Ways to the middle, counted along the ray: to the near face it is h less, to the far face h more.
        double mx = Math.copySign(1, dx) * (cx - ox);
        double my = Math.copySign(1, dy) * (cy - oy);
        double mz = Math.copySign(1, dz) * (cz - oz);
        double inner = h - margin(h, originError);
        double ix = 1 / Math.abs(dx);
        double iy = 1 / Math.abs(dy);
        double iz = 1 / Math.abs(dz);
        double enterX = (mx - inner) * ix;
        double enterY = (my - inner) * iy;
        double enterZ = (mz - inner) * iz;
        double entry = greatest(enterX, enterY, enterZ);
        double exit = least((mx + inner) * ix, (my + inner) * iy, (mz + inner) * iz);
        double slack = slack(exit, h, originError, largestFinite(ix, iy, iz));
        if (entry > slack && entry < exit - slack) {
            // Certainly met from outside: at the face that is passed last, if that is beyond doubt.
            double before = entry - slack;
            if (enterY < before && enterZ < before) {
                return crossing(ox, dx, cx, -h);
            }
            if (enterX < before && enterZ < before) {
                return crossing(oy, dy, cy, -h);
            }
            if (enterX < before && enterY < before) {
                return crossing(oz, dz, cz, -h);
            }
        }
        return firstCrossingOfOther(ox, oy, oz, dx, dy, dz, originError, cx, cy, cz, h);
    }

    /** For a cube around the ray's origin, and where times are too close. */
    private static double firstCrossingOfOther(double ox, double oy, double oz, double dx, double dy, double dz,
                                               double originError, double cx, double cy, double cz, double h) {
        double mx = Math.copySign(1, dx) * (cx - ox);
        double my = Math.copySign(1, dy) * (cy - oy);
        double mz = Math.copySign(1, dz) * (cz - oz);
        double inner = h - margin(h, originError);
        double ix = 1 / Math.abs(dx);
        double iy = 1 / Math.abs(dy);
        double iz = 1 / Math.abs(dz);
        double entry = greatest((mx - inner) * ix, (my - inner) * iy, (mz - inner) * iz);
        double leaveX = (mx + inner) * ix;
        double leaveY = (my + inner) * iy;
        double leaveZ = (mz + inner) * iz;
        double exit = least(leaveX, leaveY, leaveZ);
        double slack = slack(exit, h, originError, largestFinite(ix, iy, iz));
        if (entry < -slack && exit > slack) {
            // Certainly inside: the ray leaves through the face that it passes first, if that is beyond doubt.
            double after = exit + slack;
            if (leaveY > after && leaveZ > after) {
                return crossing(ox, dx, cx, h);
            }
            if (leaveX > after && leaveZ > after) {
                return crossing(oy, dy, cy, h);
            }
            if (leaveX > after && leaveY > after) {
                return crossing(oz, dz, cz, h);
            }
        }
        return CarefulBox.firstCrossing(ox, oy, oz, dx, dy, dz, originError, cx, cy, cz, h);
    }

    /**
     * The crossing on the far side, for a ray that starts on the inner wall and goes inwards. Nothing asks whether
     * the rounded origin is inside: it is, by what is known of it.
     *
     * @param ox origin, x part
     * @param oy y part
     * @param oz z part
     * @param dx direction, x part; not all three 0
     * @param dy y part
     * @param dz z part
     * @param cx centre, x part
     * @param cy y part
     * @param cz z part
     * @param h half the edge, above 0
     * @return where the ray leaves the cube, or {@link Surface#MISS} if that is not ahead
     */
    public static double acrossFromInnerWall(double ox, double oy, double oz, double dx, double dy, double dz,
                                             double cx, double cy, double cz, double h) {
        double exit = least(exit(ox, dx, cx, h), exit(oy, dy, cy, h), exit(oz, dz, cz, h));
        return exit > 0 ? exit : Surface.MISS;
    }

    /**
     * Whether the open line between two points crosses the walls of a cube. The answer is the same from either end.
     *
     * @param px one end, x part
     * @param py y part
     * @param pz z part
     * @param pointError how far each part of it may be off; within that of a face's plane, it lies on it
     * @param qx other end, x part
     * @param qy y part
     * @param qz z part
     * @param endError the same for the other end
     * @param cx centre, x part
     * @param cy y part
     * @param cz z part
     * @param h half the edge, above 0
     * @return true if the line enters or leaves the cube strictly between its ends, also along an edge or in a face
     */
    public static boolean crossesBetween(double px, double py, double pz, double pointError,
                                         double qx, double qy, double qz, double endError,
                                         double cx, double cy, double cz, double h) {
        double dx = qx - px;
        double dy = qy - py;
        double dz = qz - pz;
        double mx = Math.copySign(1, dx) * (cx - px);
        double my = Math.copySign(1, dy) * (cy - py);
        double mz = Math.copySign(1, dz) * (cz - pz);
        double inner = h - margin(h, Math.max(pointError, endError));
        double ix = 1 / Math.abs(dx);
        double iy = 1 / Math.abs(dy);
        double iz = 1 / Math.abs(dz);
        double entry = greatest((mx - inner) * ix, (my - inner) * iy, (mz - inner) * iz);
        double exit = least((mx + inner) * ix, (my + inner) * iy, (mz + inner) * iz);
        double slack = slack(exit, h, Math.max(pointError, endError), largestFinite(ix, iy, iz));
        if (entry < exit - slack) {
            if (entry > slack && entry < 1 - slack) {
                return true;                 // comes in
            }
            if (entry < -slack && exit > slack && Math.abs(exit - 1) > slack) {
                return exit < 1;             // starts inside: goes out, or not
            }
        }
        return CarefulBox.crossesBetween(px, py, pz, pointError, qx, qy, qz, endError, cx, cy, cz, h);
    }

    /**
     * Whether a point is strictly outside a cube.
     *
     * @param px point, x part
     * @param py y part
     * @param pz z part
     * @param pointError how far each part of it may be off; within that of a face's plane, it lies on it
     * @param cx centre, x part
     * @param cy y part
     * @param cz z part
     * @param h half the edge, above 0
     * @return true if it is neither inside nor on the cube
     */
    public static boolean isOutside(double px, double py, double pz, double pointError,
                                    double cx, double cy, double cz, double h) {
        double furthest = greatest(Math.abs(px - cx), Math.abs(py - cy), Math.abs(pz - cz));
        double slack = ERROR * (furthest + h) + pointError;
        if (Math.abs(furthest - h) > slack) {
            return furthest > h;
        }
        return CarefulBox.isOutside(new Vector(px, py, pz), pointError, new Vector(cx, cy, cz), h);
    }

    /**
     * The distance at which a ray passes a face's plane.
     *
     * @param o origin of the ray on the face's axis
     * @param d its direction on that axis, not 0
     * @param c centre of the cube on that axis
     * @param towards -h for the face that the ray passes first, h for the other
     * @return error at most 2 ulp (proved: the way is rounded once, and so is the quotient)
     */
    static double crossing(double o, double d, double c, double towards) {
        double sign = Math.copySign(1, d);
        double middle = sign * (c - o);
        double way = middle + towards;
        double left = DoubleDouble.errorOfSum(sign * c, -sign * o, middle)
            + DoubleDouble.errorOfSum(middle, towards, way);
        return (way + left) / Math.abs(d);
    }

    private static double exit(double o, double d, double c, double h) {
        return d == 0 ? Surface.MISS : crossing(o, d, c, h);
    }

    /** By how much a face may be off, seen from a point beside it: what decides for a ray that runs along it. */
    private static double margin(double h, double error) {
        return 4 * ERROR * h + error;
    }

    /**
     * A bound on the error of entry and exit, sum of the two, where they decide anything: an entry much later than the exit
     * needs no bound. The starting point's own error counts on every axis.
     */
    private static double slack(double exit, double h, double error, double largestReciprocal) {
        return 4 * ERROR * Math.abs(exit) + (16 * ERROR * h + 4 * error) * largestReciprocal;
    }

    /** Of the reciprocals of a ray's direction; on an axis along which it does not go, no time is off. */
    private static double largestFinite(double ix, double iy, double iz) {
        return greatest(finite(ix), finite(iy), finite(iz));
    }

    private static double finite(double reciprocal) {
        return reciprocal < Surface.MISS ? reciprocal : 0;
    }

    private static double least(double x, double y, double z) {
        return Math.min(x, Math.min(y, z));
    }

    private static double greatest(double x, double y, double z) {
        return Math.max(x, Math.max(y, z));
    }
}
