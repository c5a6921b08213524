package raytracing.geometry;

import raytracing.math.CompensatedSum;
import raytracing.math.Vector;

/**
 * Ray-sphere arithmetic on bare doubles, world axes. {@link Sphere} and the compiled scene both call it.
 *
 * <p>With f = o - c, the ray's squared half chord times d . d is the discriminant r r (d . d) - |f x d|^2. It is taken
 * in this form because the terms of b b - a c cancel when a sphere is small and far (the two are equal by Lagrange's
 * identity; Haines, Guenther, Akenine-Moeller, Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems,
 * 2019, chapter 7, make the same point). With q = b + sign(b) sqrt(discriminant) the crossings are power/q and q/a, so
 * none comes from a difference of nearly equal numbers (Press et al., Numerical Recipes, section 5.6).
 *
 * <p>A bound on the errors, known beforehand, tells whether plain doubles decide and are accurate; if they are not,
 * the same formulas are worked out with compensated sums; what these leave open is {@link Surface#UNDECIDED}, and
 * {@link ExactSphere} answers. So no decision is wrong, whatever finite numbers come (proved below). A crossing's error
 * is at most 19.5 u (proved below); searches found at most 10 ulp, and 16 are claimed. In these proofs u = 2^-53,
 * A = (d . d)(f . f) and R = (d . d) r r.
 */
public final class SphereKernel {
    /**
     * Half of f . f: how much of it must be left in the power. The power's own roundings then cost at most 8 u of it
     * (proved: 3 u for f . f, u for r r, u for the difference).
     */
    private static final double CLEAR_POWER = 0x1p-1;

    /**
     * A crossing from outside is power / (b + root). With R at most A / 2 and a discriminant above R (R / A + 1 / 16),
     * its error is at most 19.5 u in all; climbing found 10 ulp at most. Let s be the ray's distance from the centre
     * in radii, k the cosine of its angle with the normal where it hits, k k = 1 - s s, and lengths in units of |f|,
     * so that R / A = r r and q = sqrt(1 - s s r r) + r k. The roundings of f move the sphere by at most u, and the
     * crossing by at most u / (k (q - 2 r k)) of itself; those of the power cost (3 + r r) / (1 - r r) + 1, of b 3 /
     * q, of the discriminant (2.31 s + r (6 + 4 s s)) / (2 k q), of its root r k / q, of q and of the quotient 1 each.
     * The sum is largest where R is A / 2 or nearly 0.
     */
    private static final double CLEAR_DISCRIMINANT = 0x1p-4;

    /**
     * Of R, how much root q must be for rays from inside the sphere or close to it, whose power is compensated. The crossing
     * is off by at most 19 u then: 4 sqrt(A) / q for b, 13 R / (2 root q) for the discriminant, 3 for a, and 3.5 for the
     * power, the root, q and the quotient.
     */
    private static final double CLEAR_BESIDE = 0.75;

    /** Of a radius this small, squared and beside the distance, the roundings of f are less than 2^-12. */
    private static final double FAR = 0x1p-80;

    /**
     * (64 u)^2. The discriminant's error is at most 17 u sqrt(R A) + 8 u R + 36 u^2 A where R exceeds its size, and at
     * most 17 u sqrt(A |discriminant|) + 36 u^2 A beyond that (proved: 3 u for every part of f x d, 3 u for the sum of
     * their squares). Either is below the square root of S A (R + S A) with this S.
     */
    private static final double SQUARED_ERROR = 0x1p-94;

    /**
     * The same when it is compensated. Its error is then at most 24 u^2 sqrt(R A) and a rounding (proved: 6 u^2 for
     * every part of f x d); beyond this S, that is less than 2 u of it, and its root is off by less than 2 u too.
     */
    private static final double COMPENSATED_SQUARED_ERROR = 0x1p-96;

    /** Above this, a compensated power's error, at most 2^-101 times the squares it adds up, is far below rounding. */
    private static final double COMPENSATED_POWER_ERROR = 0x1p-46;

    /** That error itself, with something to spare. */
    private static final double COMPENSATED_POWER_ROUNDING = 0x1p-99;

    /** 32 u: the error of b b - a power is at most 20 u times a (f . f + r r) (proved: 4 u for b, 8 u for power). */
    private static final double QUICK_ERROR = 0x1p-48;

    /** (16 u)^2: the power's error is at most 8 u times its larger term (proved). */
    private static final double SQUARED_POWER_ERROR = 0x1p-98;

    /** A point whose power is above this share of the larger term is off the sphere if its error is below a 32nd of its root. */
    private static final double CLEAR_SIDE = 0x1p-2;
    private static final double FAR_FROM_ERROR = 0x1p10;

    /** Of the squared way to the centre, how much must lie along a ray across: b's error is then at most 12 u of it. */
    private static final double CLEAR_ACROSS = 0x1p-3;

    /** The same for a compensated b, which is off by 2^-101 of the way. */
    private static final double COMPENSATED_ACROSS = 0x1p-80;

    /** Squares above this, and their products with an ordinary square, carry no trace of subnormal numbers. */
    private static final double SMALL_SQUARE = 0x1p-400;

    /**
     * Squares of directions in this range neither make products of lengths overflow nor bring them below normal ones.
     */
    private static final double LEAST_DIRECTION = 0x1p-500;
    private static final double MOST_DIRECTION = 0x1p500;

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
     * @param error how far each part of the line's ends may be off; a sphere within this of an end is not passed
     * @param cx centre, x part
     * @param cy y part
     * @param cz z part
     * @param r radius, above 0
     * @return true only if o + t d is outside the sphere for all t
     */
    public static boolean isPlainlyMissed(double ox, double oy, double oz, double dx, double dy, double dz,
                                          double error, double cx, double cy, double cz, double r) {
        double fx = ox - cx;
        double fy = oy - cy;
        double fz = oz - cz;
        double b = fx * dx + fy * dy + fz * dz;
        double a = dx * dx + dy * dy + dz * dz;
        double grown = r + 4 * error;        // an end within its error of the sphere is within sqrt(12) of it
        double power = (1 - QUICK_ERROR) * (fx * fx + fy * fy + fz * fz) - (1 + QUICK_ERROR) * (grown * grown)
            - SMALL_SQUARE;
        double most = a * power;
        return b * b < most && most < Surface.MISS && isOrdinary(a);
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
     *        the ray starts, the answer is left open
     * @param cx centre, x part
     * @param cy y part
     * @param cz z part
     * @param r radius, above 0
     * @return smallest crossing above 0, {@link Surface#MISS}, or {@link Surface#UNDECIDED}
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
        if (power > CLEAR_POWER * squaredDistance && squaredRadius > doubt(squaredDistance, originError)
                && isOrdinary(a)) {
            double b = -(fx * dx + fy * dy + fz * dz);
            if (b <= 0) {
                return Surface.MISS;         // even if rounding made b so: level with its centre, lines outside pass it
            }
            double r2a = a * squaredRadius;
            double discriminant = discriminant(fx, fy, fz, dx, dy, dz, r2a);
            if (discriminant * squaredDistance > r2a * (squaredRadius + CLEAR_DISCRIMINANT * squaredDistance)) {
                return power / (b + Math.sqrt(discriminant));
            }
        }
        return compensatedCrossing(ox, oy, oz, dx, dy, dz, originError, cx, cy, cz, r);
    }

    /**
     * What a squared radius must exceed. The roundings of f must not hide the sphere. And half of the squared
     * distance, which the power exceeds, must be more than the 2 sqrt(3) |f| times the error that is the power of a
     * point within its error.
     */
    private static double doubt(double squaredDistance, double originError) {
        return FAR * squaredDistance + (64 * originError * originError + SMALL_SQUARE);
    }

    /** For a sphere that is grazed or passed by little, or around the ray's origin or close to it. */
    private static double compensatedCrossing(double ox, double oy, double oz, double dx, double dy, double dz,
                                              double originError, double cx, double cy, double cz, double r) {
        double fx = ox - cx;
        double fy = oy - cy;
        double fz = oz - cz;
        double squaredDistance = fx * fx + fy * fy + fz * fz;
        double squaredRadius = r * r;
        double squares = squaredDistance + squaredRadius;
        double a = dx * dx + dy * dy + dz * dz;
        double power = compensatedPower(ox, oy, oz, cx, cy, cz, r);
        double onSphere = 2 * originError * (Math.abs(fx) + Math.abs(fy) + Math.abs(fz));
        boolean isOffSphere = Math.abs(power) > COMPENSATED_POWER_ERROR * squares + onSphere;
        if (!(isOffSphere && squaredRadius > SMALL_SQUARE && squares < Surface.MISS && isOrdinary(a))) {
            return Surface.UNDECIDED;
        }
        double r2a = a * squaredRadius;
        double discriminant = discriminant(fx, fy, fz, dx, dy, dz, r2a);
        if (discriminant < 0 && isCertain(discriminant, SQUARED_ERROR * a * squaredDistance, r2a)) {
            return Surface.MISS;
        }
        double b = -(fx * dx + fy * dy + fz * dz);
        double root = Math.sqrt(discriminant);
        if (!(squaredDistance < 4 * squaredRadius && root * (Math.abs(b) + root) > CLEAR_BESIDE * r2a)) {
            discriminant = compensatedDiscriminant(ox, oy, oz, dx, dy, dz, cx, cy, cz, r);
            if (!isCertain(discriminant, COMPENSATED_SQUARED_ERROR * a * squaredDistance, r2a)) {
                return Surface.UNDECIDED;
            }
            b = compensatedApproach(ox, oy, oz, dx, dy, dz, cx, cy, cz);
            root = Math.sqrt(discriminant);
        }
        if (discriminant < 0 || power > 0 && b <= 0) {
            return Surface.MISS;
        }
        double q = Math.abs(b) + root;
        return power < 0 && b > 0 ? q / a : Math.abs(power) / q;
    }

    /** |o - c|^2 - r r, from exact differences and products, with one rounding. */
    private static double compensatedPower(double ox, double oy, double oz, double cx, double cy, double cz, double r) {
        double fx = ox - cx;
        double fy = oy - cy;
        double fz = oz - cz;
        double xy = fx * fx + fy * fy;
        double xyz = xy + fz * fz;
        double power = xyz - r * r;
        double errorX = errorOfSquare(fx, CompensatedSum.errorOfSum(ox, -cx, fx));
        double errorY = errorOfSquare(fy, CompensatedSum.errorOfSum(oy, -cy, fy));
        double errorZ = errorOfSquare(fz, CompensatedSum.errorOfSum(oz, -cz, fz));
        double sumErrors = CompensatedSum.errorOfSum(fx * fx, fy * fy, xy) + CompensatedSum.errorOfSum(xy, fz * fz, xyz)
            + CompensatedSum.errorOfSum(xyz, -(r * r), power);
        return power + (sumErrors + ((errorX + errorY) + errorZ - errorOfSquare(r, 0)));
    }

    /**
     * r r (d . d) - |f x d|^2 in pairs of doubles, of which one is returned: error at most 24 u^2 sqrt(R A) + 4 u^2 R
     * and one rounding where it is not far below 0.
     */
    private static double compensatedDiscriminant(double ox, double oy, double oz, double dx, double dy, double dz,
                                                  double cx, double cy, double cz, double r) {
        double fx = ox - cx;
        double fy = oy - cy;
        double fz = oz - cz;
        double restX = CompensatedSum.errorOfSum(ox, -cx, fx);
        double restY = CompensatedSum.errorOfSum(oy, -cy, fy);
        double restZ = CompensatedSum.errorOfSum(oz, -cz, fz);
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
            + CompensatedSum.errorOfSum(dx * dx, dy * dy, aXy) + CompensatedSum.errorOfSum(aXy, dz * dz, a);
        double high = a * squaredRadius;
        double low = Math.fma(a, squaredRadius, -high) + (lowA * squaredRadius + a * errorOfSquare(r, 0));
        double withoutX = high - gx * gx;
        double withoutXy = withoutX - gy * gy;
        double discriminant = withoutXy - gz * gz;
        double errors = CompensatedSum.errorOfSum(high, -(gx * gx), withoutX)
            + CompensatedSum.errorOfSum(withoutX, -(gy * gy), withoutXy)
            + CompensatedSum.errorOfSum(withoutXy, -(gz * gz), discriminant);
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
        double rests = CompensatedSum.errorOfSum(ox, -cx, fx) * dx + CompensatedSum.errorOfSum(oy, -cy, fy) * dy
            + CompensatedSum.errorOfSum(oz, -cz, fz) * dz;
        double errors = Math.fma(fx, dx, -x) + Math.fma(fy, dy, -y) + Math.fma(fz, dz, -z)
            + CompensatedSum.errorOfSum(x, y, xy) + CompensatedSum.errorOfSum(xy, z, xyz);
        return -(xyz + (errors + rests));
    }

    /** What the double nearest to p q - v w, rounded thrice, leaves out of it. */
    private static double errorOfDifference(double p, double q, double v, double w, double difference) {
        double pq = p * q;
        double vw = v * w;
        return Math.fma(p, q, -pq) - Math.fma(v, w, -vw) + CompensatedSum.errorOfSum(pq, -vw, difference);
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
     * @return twice the way to the closest approach, or {@link Surface#UNDECIDED} if the ray stays close to the wall
     */
    public static double acrossFromInnerWall(double ox, double oy, double oz, double dx, double dy, double dz,
                                             double cx, double cy, double cz) {
        double fx = ox - cx;
        double fy = oy - cy;
        double fz = oz - cz;
        double b = -(fx * dx + fy * dy + fz * dz);
        double a = dx * dx + dy * dy + dz * dz;
        double squaredDistance = fx * fx + fy * fy + fz * fz;
        double square = a * squaredDistance;
        if (!(squaredDistance > SMALL_SQUARE && square < Surface.MISS && isOrdinary(a))) {
            return Surface.UNDECIDED;
        }
        if (b > 0 && b * b > CLEAR_ACROSS * square) {
            return 2 * b / a;                // 4 u sqrt(A) for b, 3 u for a, and a rounding: at most 15.4 u
        }
        double exact = compensatedApproach(ox, oy, oz, dx, dy, dz, cx, cy, cz);
        return exact > 0 && exact * exact > COMPENSATED_ACROSS * square ? 2 * exact / a : Surface.UNDECIDED;
    }

    /**
     * Whether the open line between two points crosses a sphere. The answer is the same from either end.
     *
     * @param px one end, x part
     * @param py y part
     * @param pz z part
     * @param pointError how far each part of it may be off; within that of the sphere, the answer is left open
     * @param qx other end, x part
     * @param qy y part
     * @param qz z part
     * @param endError the same for the other end
     * @param cx centre, x part
     * @param cy y part
     * @param cz z part
     * @param r radius, above 0
     * @return whether the line enters or leaves the sphere strictly between its ends
     */
    public static Answer crossesBetween(double px, double py, double pz, double pointError,
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
        int side = side(squaredDistance, squaredRadius, pointError);
        int endSide = side(gx * gx + gy * gy + gz * gz, squaredRadius, endError);
        if (side == 0 || endSide == 0) {
            return Answer.UNDECIDED;
        }
        if (side < 0 || endSide < 0) {
            return answer(side != endSide);
        }
        double scale = ordinaryScale(qx - px, qy - py, qz - pz);
        double dx = scale * (qx - px);
        double dy = scale * (qy - py);
        double dz = scale * (qz - pz);
        double a = dx * dx + dy * dy + dz * dz;
        double r2a = a * squaredRadius;
        double discriminant = discriminant(fx, fy, fz, dx, dy, dz, r2a);
        if (isOrdinary(a) && isCertain(discriminant, SQUARED_ERROR * a * squaredDistance, r2a)) {
            // the closest approach lies inside, between the ends
            return answer(discriminant > 0 && fx * dx + fy * dy + fz * dz < 0 && gx * dx + gy * dy + gz * dz > 0);
        }
        return Answer.UNDECIDED;
    }

    /** A power of two that brings a direction near 1; 1 for ordinary ones. */
    private static double ordinaryScale(double dx, double dy, double dz) {
        return isOrdinary(dx * dx + dy * dy + dz * dz) ? 1
            : Math.scalb(1.0, -Math.getExponent(Vector.largestPart(dx, dy, dz)));
    }

    /**
     * Whether a point is strictly outside a sphere.
     *
     * @param px point, x part
     * @param py y part
     * @param pz z part
     * @param pointError how far each part of it may be off; within that of the sphere, the answer is left open
     * @param cx centre, x part
     * @param cy y part
     * @param cz z part
     * @param r radius, above 0
     * @return whether it is neither inside nor on the sphere
     */
    public static Answer isOutside(double px, double py, double pz, double pointError,
                                    double cx, double cy, double cz, double r) {
        double fx = px - cx;
        double fy = py - cy;
        double fz = pz - cz;
        int side = side(fx * fx + fy * fy + fz * fz, r * r, pointError);
        return side == 0 ? Answer.UNDECIDED : answer(side > 0);
    }

    /**
     * Whether a point is certainly on a sphere, within its error.
     *
     * @param px point, x part
     * @param py y part
     * @param pz z part
     * @param pointError how far each part of it may be off
     * @param cx centre, x part
     * @param cy y part
     * @param cz z part
     * @param r radius, above 0
     * @return false also if doubles cannot tell
     */
    static boolean isOn(double px, double py, double pz, double pointError, double cx, double cy, double cz, double r) {
        double fx = px - cx;
        double fy = py - cy;
        double fz = pz - cz;
        double squares = fx * fx + fy * fy + fz * fz + r * r;
        double power = compensatedPower(px, py, pz, cx, cy, cz, r);
        double spread = 2 * pointError * (Math.abs(fx) + Math.abs(fy) + Math.abs(fz));
        return squares > SMALL_SQUARE && squares < Surface.MISS
            && Math.abs(power) + COMPENSATED_POWER_ROUNDING * squares <= (1 - QUICK_ERROR) * spread;
    }

    private static Answer answer(boolean isYes) {
        return isYes ? Answer.YES : Answer.NO;
    }

    private static boolean isOrdinary(double squaredDirection) {
        return squaredDirection > LEAST_DIRECTION && squaredDirection < MOST_DIRECTION;
    }

    private static double discriminant(double fx, double fy, double fz, double dx, double dy, double dz,
                                       double squaredRadiusTimesA) {
        double gx = fy * dz - fz * dy;
        double gy = fz * dx - fx * dz;
        double gz = fx * dy - fy * dx;
        return squaredRadiusTimesA - (gx * gx + gy * gy + gz * gz);
    }

    /** Whether a discriminant is beyond its error, given S A and R; false for one that is no number. */
    private static boolean isCertain(double discriminant, double error, double squaredRadiusTimesA) {
        return discriminant * discriminant > error * (squaredRadiusTimesA + error);
    }

    /** 1 outside, -1 inside, 0 if doubles cannot tell or the point's own error leaves it open. */
    private static int side(double squaredDistance, double squaredRadius, double pointError) {
        double power = squaredDistance - squaredRadius;
        double larger = Math.max(squaredDistance, squaredRadius);
        if (Math.abs(power) > CLEAR_SIDE * larger && larger > FAR_FROM_ERROR * pointError * pointError
                && larger > SMALL_SQUARE && larger < Surface.MISS) {
            return power > 0 ? 1 : -1;       // twice as much as the doubt below, and nothing is squared again
        }
        // the power of a point within its error of the sphere is at most sqrt(12) of it times its distance, and rounded
        double squaredDoubt = (16 * pointError * pointError + SQUARED_POWER_ERROR * larger) * larger
            + SMALL_SQUARE * SMALL_SQUARE;
        return !(power * power > squaredDoubt) ? 0 : power > 0 ? 1 : -1;
    }
}
