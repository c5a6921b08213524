package raytracing.geometry;

import raytracing.math.CompensatedSum;

/**
 * Ray-box arithmetic on bare doubles, world axes, by slabs: the ray is inside the cube while it is between all three
 * pairs of faces (Kay, Kajiya, Ray Tracing Complex Scenes, SIGGRAPH 1986, section 4). {@link Box} and the compiled
 * scene both call it.
 *
 * <p>The faces lie at the real numbers c - h and c + h, which need not be doubles: a box stored as two rounded corners
 * would be another box. Doubles decide where the times at which the ray passes the faces are further apart than their
 * errors; what they leave open is undecided, and {@link ExactBox} answers. Then the way to the one face that counts is
 * summed with a single rounding and divided by the direction. No decision is wrong, whatever finite numbers come, so
 * no ray slips between two boxes that share a face (proved below, measured in {@code NumericsRowsTest}); a crossing's
 * error is at most 2 ulp (proved: a rounding for the sum and one for the quotient).
 */
public final class BoxKernel {
    /**
     * 8 u, with u = 2^-53. A time at which a ray passes a face's plane is (m -+ h) / |d|, with m the way to the
     * middle. Its error is at most 4 u times |m| + h over |d| (proved: a rounding each for m, the sum, the reciprocal
     * and the product), and |m| + h is at most the time itself plus twice h / |d|.
     */
    private static final double ERROR = 0x1p-50;

    /**
     * Squares of directions lie in this range, and times that are told apart below {@link #LARGE}. Where sums of
     * lengths leave the range of doubles, or the reciprocal of a tiny part does, true times are above 2^600; so they
     * are rightly infinite.
     */
    private static final double LEAST_DIRECTION = 0x1p-400;
    private static final double MOST_DIRECTION = 0x1p400;
    private static final double LARGE = 0x1p500;

    /**
     * The square of how much smaller than the whole direction a part may be to count as one along which the ray goes.
     * Of a smaller one, times are larger than all others where its way to a face is above the margin, and of the same
     * sign.
     */
    private static final double SMALLEST_PART = 0x1p400;

    /** Times this far apart are so despite all that is lost below the normal numbers. */
    private static final double SMALL = 0x1p-600;

    /** Of a longer way to a face, the time is above 2^600 if the part of the direction has no reciprocal. */
    private static final double SHORTEST_WAY = 0x1p-350;

    /** Longer by more than the errors of a time, which are 5 u of it. */
    private static final double LENGTHENED = 1 + 0x1p-48;

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
        double mx = ahead(ox, dx, cx);
        double my = ahead(oy, dy, cy);
        double mz = ahead(oz, dz, cz);
        double grown = h + margin(h, error);
        double ix = 1 / Math.abs(dx);
        double iy = 1 / Math.abs(dy);
        double iz = 1 / Math.abs(dz);
        double entry = greatest((mx - grown) * ix, (my - grown) * iy, (mz - grown) * iz);
        double exit = least((mx + grown) * ix, (my + grown) * iy, (mz + grown) * iz);
        boolean isMissed = exit < -SMALL || entry > exit * LENGTHENED + SMALL && exit < LARGE
            || entry > latest * LENGTHENED + SMALL && latest < LARGE;
        return isMissed && isOrdinary(square(dx, dy, dz));
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
     * @return smallest crossing above 0, or {@link Surface#UNDECIDED}, also for a ray that misses
     */
    public static double firstCrossing(double ox, double oy, double oz, double dx, double dy, double dz,
                                       double originError, double cx, double cy, double cz, double h) {
        // Ways to the middle, counted along the ray: to the near face it is h less, to the far face h more.
        double mx = ahead(ox, dx, cx);
        double my = ahead(oy, dy, cy);
        double mz = ahead(oz, dz, cz);
        double grown = h + margin(h, originError);
        double ix = 1 / Math.abs(dx);
        double iy = 1 / Math.abs(dy);
        double iz = 1 / Math.abs(dz);
        double enterX = (mx - grown) * ix;
        double enterY = (my - grown) * iy;
        double enterZ = (mz - grown) * iz;
        double entry = greatest(enterX, enterY, enterZ);
        double exit = least((mx + grown) * ix, (my + grown) * iy, (mz + grown) * iz);
        double slack = slack(exit, h, originError, greatest(ix, iy, iz));
        if (entry > slack && entry < exit - slack && exit < LARGE && isOrdinary(square(dx, dy, dz))) {
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

    /**
     * For a cube around the ray's origin, and for rays along an axis or a face. Of the latest entry or the first exit,
     * the error is no larger than that of all three.
     */
    private static double firstCrossingOfOther(double ox, double oy, double oz, double dx, double dy, double dz,
                                               double originError, double cx, double cy, double cz, double h) {
        double mx = ahead(ox, dx, cx);
        double my = ahead(oy, dy, cy);
        double mz = ahead(oz, dz, cz);
        double square = square(dx, dy, dz);
        double inner = h - margin(h, originError);
        double ix = 1 / Math.abs(dx);
        double iy = 1 / Math.abs(dy);
        double iz = 1 / Math.abs(dz);
        double entry = greatest((mx - inner) * ix, (my - inner) * iy, (mz - inner) * iz);
        double exit = least((mx + inner) * ix, (my + inner) * iy, (mz + inner) * iz);
        double slack = slack(exit, h, originError, largest(ix, iy, iz, square));
        if (exit < LARGE && isOrdinary(square)) {
            if (entry > slack && entry < exit - slack) {
                return greatest(entry(ox, dx, cx, h), entry(oy, dy, cy, h), entry(oz, dz, cz, h));
            }
            if (entry < -slack && exit > slack) {
                return least(exit(ox, dx, cx, h), exit(oy, dy, cy, h), exit(oz, dz, cz, h));
            }
        }
        return Surface.UNDECIDED;
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
     * @param originError how far each part of the origin may be off
     * @param cx centre, x part
     * @param cy y part
     * @param cz z part
     * @param h half the edge, above 0
     * @return where the ray leaves the cube, or {@link Surface#UNDECIDED}
     */
    public static double acrossFromInnerWall(double ox, double oy, double oz, double dx, double dy, double dz,
                                             double originError, double cx, double cy, double cz, double h) {
        double shortest = least(wayOut(ox, dx, cx, h), wayOut(oy, dy, cy, h), wayOut(oz, dz, cz, h));
        double exit = least(exit(ox, dx, cx, h), exit(oy, dy, cy, h), exit(oz, dz, cz, h));
        // within the origin's error of a second wall, doubles cannot tell whether that one is met at once
        boolean isClear = shortest > margin(h, 2 * originError) && exit < Surface.MISS;
        return isClear && isOrdinary(square(dx, dy, dz)) ? exit : Surface.UNDECIDED;
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
     * @return whether the line enters or leaves the cube strictly between its ends; of one that passes it, undecided
     */
    public static Answer crossesBetween(double px, double py, double pz, double pointError,
                                         double qx, double qy, double qz, double endError,
                                         double cx, double cy, double cz, double h) {
        double dx = qx - px;
        double dy = qy - py;
        double dz = qz - pz;
        double mx = ahead(px, dx, cx);
        double my = ahead(py, dy, cy);
        double mz = ahead(pz, dz, cz);
        double error = Math.max(pointError, endError);
        double square = square(dx, dy, dz);
        double inner = h - margin(h, error);
        double ix = 1 / Math.abs(dx);
        double iy = 1 / Math.abs(dy);
        double iz = 1 / Math.abs(dz);
        double entry = greatest((mx - inner) * ix, (my - inner) * iy, (mz - inner) * iz);
        double exit = least((mx + inner) * ix, (my + inner) * iy, (mz + inner) * iz);
        double slack = slack(exit, h, error, largest(ix, iy, iz, square));
        if (entry < exit - slack && exit < LARGE && isOrdinary(square)) {
            if (entry > slack && entry < 1 - slack) {
                return Answer.YES;           // comes in
            }
            if (entry < -slack && exit > slack && Math.abs(exit - 1) > slack) {
                return exit < 1 ? Answer.YES : Answer.NO;    // starts inside: goes out, or not
            }
        }
        return Answer.UNDECIDED;
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
     * @return whether it is neither inside nor on the cube
     */
    public static Answer isOutside(double px, double py, double pz, double pointError,
                                    double cx, double cy, double cz, double h) {
        double furthest = greatest(Math.abs(px - cx), Math.abs(py - cy), Math.abs(pz - cz));
        double slack = ERROR * (furthest + h) + pointError;
        if (Math.abs(furthest - h) > slack) {
            return furthest > h ? Answer.YES : Answer.NO;
        }
        return Answer.UNDECIDED;
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
        double left = CompensatedSum.errorOfSum(sign * c, -sign * o, middle)
            + CompensatedSum.errorOfSum(middle, towards, way);
        return (way + left) / Math.abs(d);
    }

    /**
     * How far a point is outside a face's plane, on the side away from the middle.
     *
     * @param p the point on the face's axis
     * @param sign 1 for the face at c + h, -1 for that at c - h
     * @param c centre of the cube on that axis
     * @param h half the edge
     * @return sign (p - c) - h, rounded once
     */
    static double outside(double p, double sign, double c, double h) {
        double fromMiddle = sign * (p - c);
        double way = fromMiddle - h;
        return way + (CompensatedSum.errorOfSum(sign * p, -sign * c, fromMiddle)
            + CompensatedSum.errorOfSum(fromMiddle, -h, way));
    }

    /**
     * When the ray passes the near face of an axis, or the far one; of the latest or earliest, the errors are no
     * larger.
     */
    private static double entry(double o, double d, double c, double h) {
        return d == 0 ? -Surface.MISS : crossing(o, d, c, -h);
    }

    private static double exit(double o, double d, double c, double h) {
        return d == 0 ? Surface.MISS : crossing(o, d, c, h);
    }

    /** The way to the far face of an axis, rounded. */
    private static double wayOut(double o, double d, double c, double h) {
        return d == 0 ? Surface.MISS : ahead(o, d, c) + h;
    }

    /** By how much a face may be off, seen from a point beside it: what decides for a ray that runs along it. */
    private static double margin(double h, double error) {
        return 4 * ERROR * h + (error + SHORTEST_WAY);
    }

    /**
     * A bound on the error of entry and exit, sum of the two, where they decide anything: an entry much later than the
     * exit needs no bound. The starting point's own error counts on every axis.
     */
    private static double slack(double exit, double h, double error, double largestReciprocal) {
        return 4 * ERROR * Math.max(exit, 0) + 4 * margin(h, error) * largestReciprocal;
    }

    /** Of the reciprocals of a ray's direction; on an axis along which it does not go, no time is off. */
    private static double largest(double ix, double iy, double iz, double square) {
        return greatest(counted(ix, square), counted(iy, square), counted(iz, square));
    }

    private static double counted(double reciprocal, double square) {
        return reciprocal * reciprocal * square < SMALLEST_PART ? reciprocal : 0;
    }

    private static double square(double dx, double dy, double dz) {
        return dx * dx + dy * dy + dz * dz;
    }

    private static boolean isOrdinary(double square) {
        return square > LEAST_DIRECTION && square < MOST_DIRECTION;
    }

    /** The way to the middle on one axis, counted along the ray. */
    private static double ahead(double o, double d, double c) {
        return Math.copySign(1, d) * (c - o);
    }

    private static double least(double x, double y, double z) {
        return Math.min(x, Math.min(y, z));
    }

    private static double greatest(double x, double y, double z) {
        return Math.max(x, Math.max(y, z));
    }
}
