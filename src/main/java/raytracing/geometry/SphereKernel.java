package raytracing.geometry;

import raytracing.math.DoubleDouble;
import raytracing.math.Vector;

/**
 * Ray-sphere arithmetic on bare doubles, world axes. {@link Sphere} and the compiled scene both call it.
 *
 * <p>With f = o - c, the ray's squared half chord times d . d is the discriminant r r (d . d) - |f x d|^2. It is taken in
 * this form because the terms of b b - a c cancel when a sphere is small and far (the two are equal by Lagrange's
 * identity; Haines, Guenther, Akenine-Moeller, Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems,
 * 2019, chapter 7, make the same point). With q = b + sign(b) sqrt(discriminant) the crossings are power/q and q/a, so
 * none comes from a difference of nearly equal numbers (Press et al., Numerical Recipes, section 5.6).
 *
 * <p>Doubles answer where a bound on their errors, known beforehand, leaves no doubt of any decision and cancellation
 * has cost but a few bits; {@link CarefulSphere} answers the rest. No decision is wrong (proved below, measured in
 * {@code NumericsRowsTest}); a crossing's error is at most 16 ulp (measured in {@code HardRaysTest}).
 */
public final class SphereKernel {
    /**
     * (64 u)^2 with u = 2^-53. With A = (d . d)(f . f) and R = (d . d) r r, the discriminant's error is at most
     * 17 u sqrt(R A) + 8 u R + 36 u^2 A where R exceeds its size, and at most 17 u sqrt(A |discriminant|) + 36 u^2 A
     * beyond that (proved: 3 u for every part of f x d, 3 u for the sum of their squares). Either is below the square
     * root of S A (R + S A) with this S.
     */
    private static final double SQUARED_ERROR = 0x1p-94;

    /** 32 u: the error of b b - a power is at most 20 u times a (f . f + r r) (proved: 4 u for b, 8 u for power). */
    private static final double QUICK_ERROR = 0x1p-48;

    /** How much of the power's larger term must be left: cancellation then costs at most 2 bits. */
    private static final double CLEAR_POWER = 0x1p-2;

    /** Above this, a compensated power's error, at most 2^-101 times the squares it adds up, is far below rounding. */
    private static final double COMPENSATED_POWER_ERROR = 0x1p-46;

    /** Beyond this, the numbers that make q, compensated and so off by 2^-97 of its largest size, are as good as exact. */
    private static final double COMPENSATED_SQUARE_ERROR = 0x1p-80;

    /** How much of R must be left in the discriminant, that is, how far from grazing doubles are trusted. */
    private static final double CLEAR_DISCRIMINANT = 0x1p-9;

    /** (16 u)^2: the power's error is at most 8 u times its larger term (proved). */
    private static final double SQUARED_POWER_ERROR = 0x1p-98;

    /** The same for rays that start close to the sphere, where an error of the discriminant weighs more. */
    private static final double CLEAR_BESIDE = 0x1p-4;

    /** Squares and their products above this carry no trace of subnormal numbers. */
    private static final double SMALL_SQUARE = 0x1p-600;

    private SphereKernel() {
    }

    /**
     * Whether a line plainly passes a sphere, for loops to ask first: most lines pass most spheres so far off that the
     * textbook's discriminant, b b - a power, will do to see it, even with its whole error against it.
     *
     * @param ox a point of the line, x part
     * @param oy y part
     * @param oz z part
     * @param dx direction, x part
     * @param dy y part
     * @param dz z part
     * @param cx centre, x part
     * @param cy y part
     * @param cz z part
     * @param r radius, above 0
     * @return true only if o + t d is outside the sphere for all t
     */
    public static boolean isPlainlyMissed(double ox, double oy, double oz, double dx, double dy, double dz,
                                          double cx, double cy, double cz, double r) {
        double fx = ox - cx;
        double fy = oy - cy;
        double fz = oz - cz;
        double b = fx * dx + fy * dy + fz * dz;
        double a = dx * dx + dy * dy + dz * dz;
        double power = (1 - QUICK_ERROR) * (fx * fx + fy * fy + fz * fz) - (1 + QUICK_ERROR) * (r * r);
        return b * b < a * power - SMALL_SQUARE;
    }

    /**
     * First crossing of the ray o + t d with a sphere.
     *
     * @param ox origin, x part
     * @param oy y part
     * @param oz z part
     * @param dx direction, x part; not all three 0
     * @param dy y part
     * @param dz z part
     * @param originError how far each part of the origin may be off; if that leaves open on which side of the sphere
     *        the ray starts, it starts on it
     * @param cx centre, x part
     * @param cy y part
     * @param cz z part
     * @param r radius, above 0
     * @return smallest crossing above 0, or {@link Surface#MISS}; never NaN; a touching ray hits
     */
    public static double firstCrossing(double ox, double oy, double oz, double dx, double dy, double dz,
                                       double originError, double cx, double cy, double cz, double r) {
        double fx = ox - cx;
        double fy = oy - cy;
        double fz = oz - cz;
        double squaredDistance = fx * fx + fy * fy + fz * fz;
        double squaredRadius = r * r;
        double power = squaredDistance - squaredRadius;
        double a = dx * dx + dy * dy + dz * dz;
        double b = -(fx * dx + fy * dy + fz * dz);
        boolean isPlainlyMet = b * b - a * power > quickError(a, squaredDistance + squaredRadius);
        if (isPlainlyMet && power > CLEAR_POWER * squaredDistance) {
            if (b <= 0) {
                return Surface.MISS;         // even if rounding made b so: level with its centre, all lines outside pass it
            }
            double discriminant = discriminant(fx, fy, fz, dx, dy, dz, a * squaredRadius);
            if (discriminant > CLEAR_DISCRIMINANT * a * squaredRadius) {
                return power / (b + Math.sqrt(discriminant));
            }
        }
        return firstCrossingOfOther(ox, oy, oz, dx, dy, dz, originError, cx, cy, cz, r);
    }

    /** For a sphere that is grazed, or small and far, or around the ray's origin or close to it. */
    private static double firstCrossingOfOther(double ox, double oy, double oz, double dx, double dy, double dz,
                                               double originError, double cx, double cy, double cz, double r) {
        double fx = ox - cx;
        double fy = oy - cy;
        double fz = oz - cz;
        double squares = fx * fx + fy * fy + fz * fz + r * r;
        double a = dx * dx + dy * dy + dz * dz;
        double discriminant = discriminant(fx, fy, fz, dx, dy, dz, a * (r * r));
        if (a > SMALL_SQUARE && squares > SMALL_SQUARE && isCertain(discriminant, a * squares, a * (r * r))) {
            if (discriminant < 0) {
                return Surface.MISS;
            }
            double power = compensatedPower(ox, oy, oz, cx, cy, cz, r);
            double onSphere = 2 * originError * (Math.abs(fx) + Math.abs(fy) + Math.abs(fz));
            double b = -(fx * dx + fy * dy + fz * dz);
            double root = Math.sqrt(discriminant);
            double q = Math.abs(b) + root;
            if (discriminant < CLEAR_BESIDE * a * (r * r) || q * q < CLEAR_POWER * a * squares) {
                b = compensatedApproach(ox, oy, oz, dx, dy, dz, cx, cy, cz);
                root = Math.sqrt(compensatedDiscriminant(ox, oy, oz, dx, dy, dz, cx, cy, cz, r));
                q = Math.abs(b) + root;
            }
            if (Math.abs(power) > COMPENSATED_POWER_ERROR * squares + onSphere
                    && a * (r * r) > SMALL_SQUARE && q * q > COMPENSATED_SQUARE_ERROR * a * squares) {
                if (b > 0) {
                    return power > 0 ? power / q : q / a;
                }
                return power > 0 ? Surface.MISS : -power / q;
            }
        }
        return CarefulSphere.firstCrossing(ox, oy, oz, dx, dy, dz, originError, cx, cy, cz, r);
    }

    /** |o - c|^2 - r r, from exact differences and products, with one rounding. */
    private static double compensatedPower(double ox, double oy, double oz, double cx, double cy, double cz, double r) {
        double fx = ox - cx;
        double fy = oy - cy;
        double fz = oz - cz;
        double xy = fx * fx + fy * fy;
        double xyz = xy + fz * fz;
        double power = xyz - r * r;
        double errorX = errorOfSquare(fx, DoubleDouble.errorOfSum(ox, -cx, fx));
        double errorY = errorOfSquare(fy, DoubleDouble.errorOfSum(oy, -cy, fy));
        double errorZ = errorOfSquare(fz, DoubleDouble.errorOfSum(oz, -cz, fz));
        double sumErrors = DoubleDouble.errorOfSum(fx * fx, fy * fy, xy) + DoubleDouble.errorOfSum(xy, fz * fz, xyz)
            + DoubleDouble.errorOfSum(xyz, -(r * r), power);
        return power + (sumErrors + ((errorX + errorY) + errorZ - errorOfSquare(r, 0)));
    }

    /**
     * r r (d . d) - |f x d|^2 in pairs of doubles, of which one is returned: error at most 2^-98 (R + |f x d|^2) and one
     * rounding (proved: each pair is off by at most 3 u^2 of the sizes that went into it).
     */
    private static double compensatedDiscriminant(double ox, double oy, double oz, double dx, double dy, double dz,
                                                  double cx, double cy, double cz, double r) {
        double fx = ox - cx;
        double fy = oy - cy;
        double fz = oz - cz;
        double restX = DoubleDouble.errorOfSum(ox, -cx, fx);
        double restY = DoubleDouble.errorOfSum(oy, -cy, fy);
        double restZ = DoubleDouble.errorOfSum(oz, -cz, fz);
        double gx = fy * dz - fz * dy;
        double gy = fz * dx - fx * dz;
        double gz = fx * dy - fy * dx;
        double lowX = errorOfDifference(fy, dz, fz, dy, gx) + (restY * dz - restZ * dy);
        double lowY = errorOfDifference(fz, dx, fx, dz, gy) + (restZ * dx - restX * dz);
        double lowZ = errorOfDifference(fx, dy, fy, dx, gz) + (restX * dy - restY * dx);
        double squaredRadius = r * r;
        double aXy = dx * dx + dy * dy;
        double a = aXy + dz * dz;
        double lowA = errorOfSquare(dx, 0) + errorOfSquare(dy, 0) + errorOfSquare(dz, 0)
            + DoubleDouble.errorOfSum(dx * dx, dy * dy, aXy) + DoubleDouble.errorOfSum(aXy, dz * dz, a);
        double high = a * squaredRadius;
        double low = Math.fma(a, squaredRadius, -high) + (lowA * squaredRadius + a * errorOfSquare(r, 0));
        double withoutX = high - gx * gx;
        double withoutXy = withoutX - gy * gy;
        double discriminant = withoutXy - gz * gz;
        double errors = DoubleDouble.errorOfSum(high, -(gx * gx), withoutX)
            + DoubleDouble.errorOfSum(withoutX, -(gy * gy), withoutXy)
            + DoubleDouble.errorOfSum(withoutXy, -(gz * gz), discriminant);
        double squares = errorOfSquare(gx, lowX) + errorOfSquare(gy, lowY) + errorOfSquare(gz, lowZ);
        return discriminant + (errors + (low - squares));
    }

    /** -(f . d) in pairs of doubles, of which one is returned: error at most 2^-101 |f| |d| and one rounding. */
    private static double compensatedApproach(double ox, double oy, double oz, double dx, double dy, double dz,
                                              double cx, double cy, double cz) {
        double fx = ox - cx;
        double fy = oy - cy;
        double fz = oz - cz;
        double x = fx * dx;
        double y = fy * dy;
        double z = fz * dz;
        double xy = x + y;
        double xyz = xy + z;
        double rests = DoubleDouble.errorOfSum(ox, -cx, fx) * dx + DoubleDouble.errorOfSum(oy, -cy, fy) * dy
            + DoubleDouble.errorOfSum(oz, -cz, fz) * dz;
        double errors = Math.fma(fx, dx, -x) + Math.fma(fy, dy, -y) + Math.fma(fz, dz, -z)
            + DoubleDouble.errorOfSum(x, y, xy) + DoubleDouble.errorOfSum(xy, z, xyz);
        return -(xyz + (errors + rests));
    }

    /** What the double nearest to p q - v w, rounded thrice, leaves out of it. */
    private static double errorOfDifference(double p, double q, double v, double w, double difference) {
        double pq = p * q;
        double vw = v * w;
        return Math.fma(p, q, -pq) - Math.fma(v, w, -vw) + DoubleDouble.errorOfSum(pq, -vw, difference);
    }

    /** What v v leaves out of the square of v + error. */
    private static double errorOfSquare(double v, double error) {
        return Math.fma(v, v, -(v * v)) + 2 * v * error;
    }

    /**
     * The crossing on the far side, for a ray that starts on the inner wall and goes inwards. As the origin lies on
     * the sphere, its power is 0 and the equation loses a root: what remains is exact where the coordinates are not.
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
     * @return twice the way to the closest approach, or {@link Surface#MISS} if that lies behind
     */
    public static double acrossFromInnerWall(double ox, double oy, double oz, double dx, double dy, double dz,
                                             double cx, double cy, double cz) {
        double b = -((ox - cx) * dx + (oy - cy) * dy + (oz - cz) * dz);
        double across = 2 * b / (dx * dx + dy * dy + dz * dz);
        return across > 0 ? across : Surface.MISS;
    }

    /**
     * Whether the open line between two points crosses a sphere. The answer is the same from either end.
     *
     * @param px one end, x part
     * @param py y part
     * @param pz z part
     * @param pointError how far each part of it may be off; within that of the sphere, it lies on it
     * @param qx other end, x part
     * @param qy y part
     * @param qz z part
     * @param endError the same for the other end
     * @param cx centre, x part
     * @param cy y part
     * @param cz z part
     * @param r radius, above 0
     * @return true if the line enters or leaves the sphere strictly between its ends
     */
    public static boolean crossesBetween(double px, double py, double pz, double pointError,
                                         double qx, double qy, double qz, double endError,
                                         double cx, double cy, double cz, double r) {
        double fx = px - cx;
        double fy = py - cy;
        double fz = pz - cz;
        double gx = qx - cx;
        double gy = qy - cy;
        double gz = qz - cz;
        double squaredRadius = r * r;
        double squaredDistance = fx * fx + fy * fy + fz * fz;
        double squaredEndDistance = gx * gx + gy * gy + gz * gz;
        double power = squaredDistance - squaredRadius;
        double endPower = squaredEndDistance - squaredRadius;
        if (power > CLEAR_POWER * squaredDistance) {
            if (endPower < -CLEAR_POWER * squaredRadius) {
                return true;                 // from outside to inside
            }
            double dx = qx - px;
            double dy = qy - py;
            double dz = qz - pz;
            double a = dx * dx + dy * dy + dz * dz;
            double b = -(fx * dx + fy * dy + fz * dz);
            if (endPower > CLEAR_POWER * squaredEndDistance
                    && b * b - a * power > quickError(a, squaredDistance + squaredRadius)) {
                return b > 0 && b < a;       // the closest approach lies between two ends outside
            }
        }
        return crossesCloseBetween(px, py, pz, pointError, qx, qy, qz, endError, cx, cy, cz, r);
    }

    /** For an end close to the sphere or inside, and for a line that grazes it. */
    private static boolean crossesCloseBetween(double px, double py, double pz, double pointError,
                                               double qx, double qy, double qz, double endError,
                                               double cx, double cy, double cz, double r) {
        double fx = px - cx;
        double fy = py - cy;
        double fz = pz - cz;
        double dx = qx - px;
        double dy = qy - py;
        double dz = qz - pz;
        double a = dx * dx + dy * dy + dz * dz;
        double squaredDistance = fx * fx + fy * fy + fz * fz;
        double squaredRadius = r * r;
        double discriminant = discriminant(fx, fy, fz, dx, dy, dz, a * squaredRadius);
        if (isCertain(discriminant, a * squaredDistance, a * squaredRadius)) {
            if (discriminant < 0) {
                return false;
            }
            int pointSide = side(squaredDistance, squaredRadius, pointError);
            double gx = qx - cx;
            double gy = qy - cy;
            double gz = qz - cz;
            int endSide = side(gx * gx + gy * gy + gz * gz, squaredRadius, endError);
            if (pointSide != 0 && endSide != 0) {
                double b = -(fx * dx + fy * dy + fz * dz);
                // Both outside, the line crosses if its closest approach lies between them.
                return pointSide > 0 && endSide > 0 ? b > 0 && b < a : pointSide != endSide;
            }
        }
        return CarefulSphere.crossesBetween(px, py, pz, pointError, qx, qy, qz, endError, cx, cy, cz, r);
    }

    /**
     * Whether a point is strictly outside a sphere.
     *
     * @param px point, x part
     * @param py y part
     * @param pz z part
     * @param pointError how far each part of it may be off; within that of the sphere, it lies on it
     * @param cx centre, x part
     * @param cy y part
     * @param cz z part
     * @param r radius, above 0
     * @return true if it is neither inside nor on the sphere
     */
    public static boolean isOutside(double px, double py, double pz, double pointError,
                                    double cx, double cy, double cz, double r) {
        double fx = px - cx;
        double fy = py - cy;
        double fz = pz - cz;
        int side = side(fx * fx + fy * fy + fz * fz, r * r, pointError);
        if (side != 0) {
            return side > 0;
        }
        return CarefulSphere.side(new Vector(px, py, pz), pointError, new Vector(cx, cy, cz), r) > 0;
    }

    /** A bound on the error of b b - a power, given f . f + r r. */
    private static double quickError(double a, double squares) {
        return QUICK_ERROR * a * squares + SMALL_SQUARE;
    }

    private static double discriminant(double fx, double fy, double fz, double dx, double dy, double dz,
                                       double squaredRadiusTimesA) {
        double gx = fy * dz - fz * dy;
        double gy = fz * dx - fx * dz;
        double gz = fx * dy - fy * dx;
        return squaredRadiusTimesA - (gx * gx + gy * gy + gz * gz);
    }

    /** Whether the sign of a discriminant is beyond its error; false for one that is no number. */
    private static boolean isCertain(double discriminant, double squaredDistanceTimesA, double squaredRadiusTimesA) {
        double error = SQUARED_ERROR * squaredDistanceTimesA;
        return discriminant * discriminant > error * (squaredRadiusTimesA + error);
    }

    /** 1 outside, -1 inside, 0 if doubles cannot tell or the point's own error leaves it open. */
    private static int side(double squaredDistance, double squaredRadius, double pointError) {
        double power = squaredDistance - squaredRadius;
        double larger = Math.max(squaredDistance, squaredRadius);
        // |power| is at least the distance from the sphere times the larger of distance and radius.
        if (power * power > (12 * pointError * pointError + SQUARED_POWER_ERROR * larger) * larger) {
            return power > 0 ? 1 : -1;
        }
        return 0;
    }
}
