package raytracing.surface;

import java.util.Optional;
import raytracing.hierarchy.Bounds;
import raytracing.math.CompensatedSum;
import raytracing.math.Fused;
import raytracing.math.Surd;
import raytracing.math.UnitVector;
import raytracing.math.Vector;

/**
 * The scene line {@code sph}: all points at one distance from a centre.
 *
 * <p>With o the ray's origin, d its direction and f = o - centre, the ray's squared half chord times d . d is the discriminant
 * r r (d . d) - |f x d|^2. It is taken in this form because the terms of b b - a c cancel when a sphere is small and far (the
 * two are equal by Lagrange's identity; Haines, Guenther, Akenine-Moeller, Precision Improvements for Ray/Sphere Intersection,
 * Ray Tracing Gems, 2019, chapter 7, make the same point). With q = b + sign(b) sqrt(discriminant) the crossings are power/q
 * and q/a, so none comes from a difference of nearly equal numbers (Press et al., Numerical Recipes, section 5.6).
 *
 * <p>A bound on the errors, known beforehand, tells whether plain doubles decide and are accurate; if they are not, the same
 * formulas are worked out with compensated sums; what these leave open is {@link Surface#UNDECIDED}, and {@link ExactSphere}
 * decides. So no decision is wrong, whatever finite numbers come (proved below). A crossing's error is at most 19.5 u (proved
 * below); searches found at most 10 ulp, and 16 are claimed. In these proofs u = 2^-53, A = (d . d)(f . f) and
 * R = (d . d) r r.
 *
 * @param centre its middle, world axes
 * @param radius above 0, finite
 * @param material number of its material, from 0
 */
public record Sphere(Vector centre, double radius, int material) implements Body {
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

    /** A point with a power above this share of the larger term is off the sphere if its error is below a 32nd of its root. */
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

    /** Far above the 4 ulp of a distance. */
    private static final double ROUNDING = 0x1p-48;

    /** Three numbers that are doubles add up to one at this fraction of their size. */
    private static final double FRACTION = 0x1p-4;

    /**
     * Whether a line plainly passes a sphere. Most lines pass most spheres so far off that the textbook's discriminant,
     * b b - a power, decides, even with its whole error against it. Takes plain numbers, which loops over many spheres keep
     * in registers.
     *
     * @param packed of the sphere, from {@code at} on
     * @param error how far each coordinate of the line's ends may be off; a sphere within this of an end is not passed
     * @return true only if o + t d is outside the sphere for all t
     */
    public static boolean isPlainlyMissed(double[] packed, int at, double ox, double oy, double oz,
                                          double dx, double dy, double dz, double error) {
        return isPlainlyMissed(ox - packed[at], oy - packed[at + 1], oz - packed[at + 2], packed[at + 3], dx, dy, dz, error);
    }

    /** The same, given the way to the origin from the centre of a sphere. */
    private static boolean isPlainlyMissed(double fx, double fy, double fz, double radius, double dx, double dy, double dz,
                                           double error) {
        double b = fx * dx + fy * dy + fz * dz;
        double a = dx * dx + dy * dy + dz * dz;
        double grown = radius + 4 * error;   // an end within its error of the sphere is within sqrt(12) of it
        double power = (1 - QUICK_ERROR) * (fx * fx + fy * fy + fz * fz) - (1 + QUICK_ERROR) * (grown * grown)
            - SMALL_SQUARE;
        double most = a * power;
        return b * b < most && most < MISS && isOrdinary(a);
    }

    /** By plain doubles, if the ray comes from outside and hits this sphere well. */
    @Override
    public double firstCrossing(Ray ray, double latest) {
        double fx = ray.origin.x - centre.x();
        double fy = ray.origin.y - centre.y();
        double fz = ray.origin.z - centre.z();
        double dx = ray.dx;
        double dy = ray.dy;
        double dz = ray.dz;
        double squaredDistance = fx * fx + fy * fy + fz * fz;
        double squaredRadius = radius * radius;
        double power = squaredDistance - squaredRadius;
        double a = dx * dx + dy * dy + dz * dz;
        if (power > CLEAR_POWER * squaredDistance && squaredRadius > doubt(squaredDistance, ray.origin.error)
                && isOrdinary(a)) {
            double b = -(fx * dx + fy * dy + fz * dz);
            if (b <= 0) {
                return MISS;                 // even if rounding made b so: level with its centre, lines outside pass it
            }
            double r2a = a * squaredRadius;
            double discriminant = discriminant(fx, fy, fz, dx, dy, dz, r2a);
            if (discriminant * squaredDistance > r2a * (squaredRadius + CLEAR_DISCRIMINANT * squaredDistance)) {
                return power / (b + Math.sqrt(discriminant));
            }
        }
        return compensatedCrossing(ray);
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
    private double compensatedCrossing(Ray ray) {
        RayOrigin o = ray.origin;
        double fx = o.x - centre.x();
        double fy = o.y - centre.y();
        double fz = o.z - centre.z();
        double dx = ray.dx;
        double dy = ray.dy;
        double dz = ray.dz;
        double squaredDistance = fx * fx + fy * fy + fz * fz;
        double squaredRadius = radius * radius;
        double squares = squaredDistance + squaredRadius;
        double a = dx * dx + dy * dy + dz * dz;
        double power = compensatedPower(o.x, o.y, o.z);
        double onSphere = 2 * o.error * (Math.abs(fx) + Math.abs(fy) + Math.abs(fz));
        boolean isOffSphere = Math.abs(power) > COMPENSATED_POWER_ERROR * squares + onSphere;
        if (!(isOffSphere && squaredRadius > SMALL_SQUARE && squares < MISS && isOrdinary(a))) {
            return UNDECIDED;
        }
        double r2a = a * squaredRadius;
        double discriminant = discriminant(fx, fy, fz, dx, dy, dz, r2a);
        if (discriminant < 0 && isCertain(discriminant, SQUARED_ERROR * a * squaredDistance, r2a)) {
            return MISS;
        }
        double b = -(fx * dx + fy * dy + fz * dz);
        double root = Math.sqrt(discriminant);
        if (!(squaredDistance < 4 * squaredRadius && root * (Math.abs(b) + root) > CLEAR_BESIDE * r2a)) {
            discriminant = compensatedDiscriminant(ray);
            if (!isCertain(discriminant, COMPENSATED_SQUARED_ERROR * a * squaredDistance, r2a)) {
                return UNDECIDED;
            }
            b = compensatedApproach(ray);
            root = Math.sqrt(discriminant);
        }
        if (discriminant < 0 || power > 0 && b <= 0) {
            return MISS;
        }
        double q = Math.abs(b) + root;
        return power < 0 && b > 0 ? q / a : Math.abs(power) / q;
    }

    /** |p - c|^2 - r r, from exact differences and products, with one rounding. */
    private double compensatedPower(double px, double py, double pz) {
        double fx = px - centre.x();
        double fy = py - centre.y();
        double fz = pz - centre.z();
        double xy = fx * fx + fy * fy;
        double xyz = xy + fz * fz;
        double power = xyz - radius * radius;
        double errorX = errorOfSquare(fx, CompensatedSum.errorOfSum(px, -centre.x(), fx));
        double errorY = errorOfSquare(fy, CompensatedSum.errorOfSum(py, -centre.y(), fy));
        double errorZ = errorOfSquare(fz, CompensatedSum.errorOfSum(pz, -centre.z(), fz));
        double sumErrors = CompensatedSum.errorOfSum(fx * fx, fy * fy, xy) + CompensatedSum.errorOfSum(xy, fz * fz, xyz)
            + CompensatedSum.errorOfSum(xyz, -(radius * radius), power);
        return power + (sumErrors + ((errorX + errorY) + errorZ - errorOfSquare(radius, 0)));
    }

    /**
     * r r (d . d) - |f x d|^2 in pairs of doubles, of which one is returned: error at most 24 u^2 sqrt(R A) + 4 u^2 R
     * and one rounding where it is not far below 0.
     */
    private double compensatedDiscriminant(Ray ray) {
        RayOrigin o = ray.origin;
        double dx = ray.dx;
        double dy = ray.dy;
        double dz = ray.dz;
        double fx = o.x - centre.x();
        double fy = o.y - centre.y();
        double fz = o.z - centre.z();
        double restX = CompensatedSum.errorOfSum(o.x, -centre.x(), fx);
        double restY = CompensatedSum.errorOfSum(o.y, -centre.y(), fy);
        double restZ = CompensatedSum.errorOfSum(o.z, -centre.z(), fz);
        double gx = fy * dz - fz * dy;
        double gy = fz * dx - fx * dz;
        double gz = fx * dy - fy * dx;
        double lowX = errorOfDifference(fy, dz, fz, dy, gx) + (restY * dz - restZ * dy);
        double lowY = errorOfDifference(fz, dx, fx, dz, gy) + (restZ * dx - restX * dz);
        double lowZ = errorOfDifference(fx, dy, fy, dx, gz) + (restX * dy - restY * dx);
        double squaredRadius = radius * radius;
        double aXy = dx * dx + dy * dy;
        double a = aXy + dz * dz;
        double lowA = errorOfSquare(dx, 0) + errorOfSquare(dy, 0) + errorOfSquare(dz, 0)
            + CompensatedSum.errorOfSum(dx * dx, dy * dy, aXy) + CompensatedSum.errorOfSum(aXy, dz * dz, a);
        double high = a * squaredRadius;
        double low = Fused.errorOfProduct(a, squaredRadius, high) + (lowA * squaredRadius + a * errorOfSquare(radius, 0));
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
    private double compensatedApproach(Ray ray) {
        RayOrigin o = ray.origin;
        double dx = ray.dx;
        double dy = ray.dy;
        double dz = ray.dz;
        double fx = o.x - centre.x();
        double fy = o.y - centre.y();
        double fz = o.z - centre.z();
        double x = fx * dx;
        double y = fy * dy;
        double z = fz * dz;
        double xy = x + y;
        double xyz = xy + z;
        double rests = CompensatedSum.errorOfSum(o.x, -centre.x(), fx) * dx
            + CompensatedSum.errorOfSum(o.y, -centre.y(), fy) * dy + CompensatedSum.errorOfSum(o.z, -centre.z(), fz) * dz;
        double errors = Fused.errorOfProduct(fx, dx, x) + Fused.errorOfProduct(fy, dy, y) + Fused.errorOfProduct(fz, dz, z)
            + CompensatedSum.errorOfSum(x, y, xy) + CompensatedSum.errorOfSum(xy, z, xyz);
        return -(xyz + (errors + rests));
    }

    /** What the double nearest to p q - v w, rounded thrice, leaves out of it. */
    private static double errorOfDifference(double p, double q, double v, double w, double difference) {
        double pq = p * q;
        double vw = v * w;
        return Fused.errorOfProduct(p, q, pq) - Fused.errorOfProduct(v, w, vw) + CompensatedSum.errorOfSum(pq, -vw, difference);
    }

    /** What v v leaves out of the square of v + error. */
    private static double errorOfSquare(double v, double error) {
        return Fused.errorOfProduct(v, v, v * v) + 2 * v * error;
    }

    /**
     * As the origin lies on the sphere, its power is 0 and the equation loses a root: what remains, twice the way to the
     * closest approach, is exact where the coordinates are not. Undecided if the ray stays close to the wall.
     */
    @Override
    public double farWall(Ray ray) {
        double fx = ray.origin.x - centre.x();
        double fy = ray.origin.y - centre.y();
        double fz = ray.origin.z - centre.z();
        double dx = ray.dx;
        double dy = ray.dy;
        double dz = ray.dz;
        double b = -(fx * dx + fy * dy + fz * dz);
        double a = dx * dx + dy * dy + dz * dz;
        double squaredDistance = fx * fx + fy * fy + fz * fz;
        double square = a * squaredDistance;
        if (!(squaredDistance > SMALL_SQUARE && square < MISS && isOrdinary(a))) {
            return UNDECIDED;
        }
        if (b > 0 && b * b > CLEAR_ACROSS * square) {
            return 2 * b / a;                // 4 u sqrt(A) for b, 3 u for a, and a rounding: at most 15.4 u
        }
        double exact = compensatedApproach(ray);
        return exact > 0 && exact * exact > COMPENSATED_ACROSS * square ? 2 * exact / a : UNDECIDED;
    }

    @Override
    public Optional<Surd> exactCrossing(Ray ray, int number) {
        return ray.leavesOutward(number) ? Optional.empty() : ExactSphere.of(this).firstCrossing(ray, number);
    }

    @Override
    public boolean isCrossed(Segment segment, int number) {
        RayOrigin o = segment.start;
        return !isPlainlyMissed(o.x - centre.x(), o.y - centre.y(), o.z - centre.z(), radius,
                segment.dx, segment.dy, segment.dz, segment.error)
            && isCrossedClosely(segment, number);
    }

    /** The same as {@link #isCrossed(Segment, int)} for a sphere that is not plainly missed. */
    public boolean isCrossedClosely(Segment segment, int number) {
        Answer quick = isCrossed(segment);
        return quick == Answer.UNDECIDED ? isCrossedExactly(segment, number) : quick == Answer.YES;
    }

    /** By doubles alone; the result is the same from either end. */
    private Answer isCrossed(Segment segment) {
        RayOrigin start = segment.start;
        int side = side(start.x, start.y, start.z, start.error);
        int endSide = side(segment.endX, segment.endY, segment.endZ, segment.endError);
        if (side == 0 || endSide == 0) {
            return Answer.UNDECIDED;
        }
        return side > 0 && endSide > 0 ? isCrossedFromOutside(segment) : Answer.of(side != endSide);
    }

    /** The same if both ends are outside: then the closest approach lies inside, between the ends. */
    private Answer isCrossedFromOutside(Segment segment) {
        double fx = segment.start.x - centre.x();
        double fy = segment.start.y - centre.y();
        double fz = segment.start.z - centre.z();
        double scale = ordinaryScale(segment.dx, segment.dy, segment.dz);
        double dx = scale * segment.dx;
        double dy = scale * segment.dy;
        double dz = scale * segment.dz;
        double a = dx * dx + dy * dy + dz * dz;
        double r2a = a * (radius * radius);
        double discriminant = discriminant(fx, fy, fz, dx, dy, dz, r2a);
        if (!(isOrdinary(a) && isCertain(discriminant, SQUARED_ERROR * a * (fx * fx + fy * fy + fz * fz), r2a))) {
            return Answer.UNDECIDED;
        }
        return Answer.of(discriminant > 0 && fx * dx + fy * dy + fz * dz < 0 && (segment.endX - centre.x()) * dx
            + (segment.endY - centre.y()) * dy + (segment.endZ - centre.z()) * dz > 0);
    }

    private boolean isCrossedExactly(Segment segment, int number) {
        Answer toWall = isCrossedToWall(segment);
        return toWall == Answer.UNDECIDED ? ExactSphere.of(this).isCrossed(segment, number) : toWall == Answer.YES;
    }

    /** For a lamp on the wall, which many segments lead to: from inside none crosses it,
        from outside those through the ball do. */
    private Answer isCrossedToWall(Segment segment) {
        RayOrigin start = segment.start;
        Answer startsOutside = isOutside(start.x, start.y, start.z, start.error);
        if (startsOutside == Answer.UNDECIDED
                || !isOn(segment.endX, segment.endY, segment.endZ, segment.endError)) {
            return Answer.UNDECIDED;
        }
        Vector fromCentre = segment.end().minus(centre);
        Vector line = segment.end().minus(start.point());
        double outwards = fromCentre.dot(line);
        double doubt = ROUNDING * fromCentre.length() * line.length();
        boolean isClear = Math.abs(outwards) > doubt && doubt > Double.MIN_NORMAL;
        return startsOutside == Answer.NO || isClear && outwards < 0 ? Answer.NO : isClear ? Answer.YES : Answer.UNDECIDED;
    }

    /** A power of two that brings a direction near 1; 1 for ordinary ones. */
    private static double ordinaryScale(double dx, double dy, double dz) {
        return isOrdinary(dx * dx + dy * dy + dz * dz) ? 1
            : Math.scalb(1.0, -Math.getExponent(Vector.largestPart(dx, dy, dz)));
    }

    @Override
    public boolean isLeft(Segment segment) {
        Answer quick = isOutside(segment.endX, segment.endY, segment.endZ, segment.endError);
        return quick == Answer.UNDECIDED ? ExactSphere.of(this).side(segment.end(), segment.endError) > 0
            : quick == Answer.YES;
    }

    /** Whether a point is strictly outside; undecided within its error of the wall. */
    private Answer isOutside(double px, double py, double pz, double pointError) {
        int side = side(px, py, pz, pointError);
        return side == 0 ? Answer.UNDECIDED : Answer.of(side > 0);
    }

    /** Whether a point is certainly on the wall within its error; false also if doubles cannot tell. */
    private boolean isOn(double px, double py, double pz, double pointError) {
        double fx = px - centre.x();
        double fy = py - centre.y();
        double fz = pz - centre.z();
        double squares = fx * fx + fy * fy + fz * fz + radius * radius;
        double power = compensatedPower(px, py, pz);
        double spread = 2 * pointError * (Math.abs(fx) + Math.abs(fy) + Math.abs(fz));
        return squares > SMALL_SQUARE && squares < MISS
            && Math.abs(power) + COMPENSATED_POWER_ROUNDING * squares <= (1 - QUICK_ERROR) * spread;
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

    /** Whether a discriminant is beyond its error, given S A and R; false for NaN. */
    private static boolean isCertain(double discriminant, double error, double squaredRadiusTimesA) {
        return discriminant * discriminant > error * (squaredRadiusTimesA + error);
    }

    /** 1 outside, -1 inside, 0 if doubles cannot tell or the point's own error leaves it open. */
    private int side(double px, double py, double pz, double pointError) {
        double fx = px - centre.x();
        double fy = py - centre.y();
        double fz = pz - centre.z();
        double squaredDistance = fx * fx + fy * fy + fz * fz;
        double squaredRadius = radius * radius;
        double power = squaredDistance - squaredRadius;
        double larger = Math.max(squaredDistance, squaredRadius);
        if (Math.abs(power) > CLEAR_SIDE * larger && larger > FAR_FROM_ERROR * pointError * pointError
                && larger > SMALL_SQUARE && larger < MISS) {
            return power > 0 ? 1 : -1;       // twice as much as the doubt below, and nothing is squared again
        }
        // the power of a point within its error of the sphere is at most sqrt(12) of it times its distance, and rounded
        double squaredDoubt = (16 * pointError * pointError + SQUARED_POWER_ERROR * larger) * larger
            + SMALL_SQUARE * SMALL_SQUARE;
        return !(power * power > squaredDoubt) ? 0 : power > 0 ? 1 : -1;
    }

    @Override
    public int side(RayOrigin point, int number) {
        return ExactSphere.of(this).side(point, number);
    }

    @Override
    public void pack(double[] numbers, int at) {
        numbers[at] = centre.x();
        numbers[at + 1] = centre.y();
        numbers[at + 2] = centre.z();
        numbers[at + 3] = radius;
    }

    @Override
    public void bound(Bounds bounds, int i) {
        bounds.setAround(i, centre.x(), centre.y(), centre.z(), radius);
    }

    @Override
    public boolean isApartFrom(double x, double y, double z, double r) {
        return Vector.length(x - centre.x(), y - centre.y(), z - centre.z()) > (1 + ROUNDING) * (radius + r);
    }

    @Override
    public double depth(Vector point) {
        return radius - point.minus(centre).length();
    }

    @Override
    public boolean isInPlaceOf(Surface other) {
        return other instanceof Sphere sphere && radius == sphere.radius && centre.isSameAs(sphere.centre);
    }

    /**
     * The normal is taken from (origin - centre) + t direction, which keeps its digits when both lie far from the world's
     * origin. Of a ball so small and far that nothing is left of this sum, the point nearest to the ray's origin is
     * seen. The point is reached from the ray's origin or from the centre, whichever is nearer to the world's origin: so
     * less is rounded.
     */
    @Override
    public void describe(Ray ray, int number, double distance, Hit hit) {
        double fx = ray.origin.x - centre.x() + distance * ray.dx;
        double fy = ray.origin.y - centre.y() + distance * ray.dy;
        double fz = ray.origin.z - centre.z() + distance * ray.dz;
        if (!(Math.abs(fx) + Math.abs(fy) + Math.abs(fz) < MISS)) {
            describeAtAFraction(ray, number, distance, hit);
            return;
        }
        boolean isNearest = fx == 0 && fy == 0 && fz == 0;
        hit.normal.set(isNearest ? -ray.dx : fx, isNearest ? -ray.dy : fy, isNearest ? -ray.dz : fz);
        placeAlong(ray, distance, hit);
        double along = hit.normal.dot(ray.dx, ray.dy, ray.dz);
        boolean isSeenFromInside = distance > 0 && Hit.isClear(along, ray) ? along > 0 : side(ray.origin, number) <= 0;
        hit.reach(ray, number, isSeenFromInside ? Departure.INWARD : Departure.OUTWARD);
    }

    private void placeAlong(Ray ray, double distance, Hit hit) {
        UnitVector n = hit.normal;
        RayOrigin o = ray.origin;
        double way = distance * Vector.largestPart(ray.dx, ray.dy, ray.dz);
        if (distance == 0) {
            hit.placeAtOrigin(ray);
        } else if (centre.largestPart() + radius < Vector.largestPart(o.x, o.y, o.z) + way) {
            hit.placeAlong(ray, way, centre.x() + radius * n.x(), centre.y() + radius * n.y(), centre.z() + radius * n.z());
        } else {
            hit.placeAlong(ray, way, o.x + distance * ray.dx, o.y + distance * ray.dy, o.z + distance * ray.dz);
        }
    }

    /** The same for sums beyond all doubles, which are within them in a world a sixteenth as large. */
    private void describeAtAFraction(Ray ray, int number, double distance, Hit hit) {
        new Sphere(centre.times(FRACTION), FRACTION * radius, material)
            .describe(ray.scaled(FRACTION), number, FRACTION * distance, hit);
        hit.enlarge(1 / FRACTION, ray);
    }

    @Override
    public <R> R accept(Visitor<R> visitor) {
        return visitor.visit(this);
    }
}
