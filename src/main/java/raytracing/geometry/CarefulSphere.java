package raytracing.geometry;

import raytracing.math.DoubleDouble;
import raytracing.math.DoubleDoubleVector;
import raytracing.math.Dyadic;
import raytracing.math.DyadicVector;
import raytracing.math.Vector;

/**
 * The questions about spheres that doubles leave open, in double-doubles: origins close to the wall, grazing rays, sizes
 * near the ends of the range. Where 106 bits leave a doubt too, exact numbers take over for that one number. So every
 * decision is that of real arithmetic on the doubles given, provided the sizes of lengths differ by less than 2^400.
 * The formulas are those of {@link SphereKernel}.
 */
final class CarefulSphere {
    /** The power's error, relative to the sum of its terms' sizes: below 2^-100 (proved), and then negligible above this. */
    private static final double CLEAR_POWER = 0x1p-46;

    /** Error of a discriminant relative to sqrt(A (R + |f x d|^2)), as in {@link SphereKernel}: below 2^-98 (proved). */
    private static final double DISCRIMINANT_ERROR = 0x1p-98;

    private final Vector origin;
    private final Vector centre;
    private final double radius;
    private final DoubleDoubleVector f;

    /** With lengths that need no scaling. */
    private CarefulSphere(Vector origin, Vector centre, double radius) {
        this.origin = origin;
        this.centre = centre;
        this.radius = radius;
        f = DoubleDoubleVector.between(this.centre, this.origin);
    }

    /**
     * {@link SphereKernel#firstCrossing}, for the rays that it leaves open. Where sizes near the ends of the range are the
     * reason, it is asked again about the same in an ordinary size, where doubles answer most.
     */
    static double firstCrossing(double ox, double oy, double oz, double dx, double dy, double dz,
                                double originError, double cx, double cy, double cz, double radius) {
        Vector origin = new Vector(ox, oy, oz);
        Vector direction = new Vector(dx, dy, dz);
        Vector centre = new Vector(cx, cy, cz);
        int length = Scaling.exponent(radius, origin, centre);
        int step = Scaling.exponent(0, direction);
        if (length == 0 && step == 0) {
            return new CarefulSphere(origin, centre, radius).firstCrossing(direction, originError);
        }
        Vector o = Scaling.down(origin, length);
        Vector d = Scaling.down(direction, step);
        Vector c = Scaling.down(centre, length);
        return Scaling.upPositive(SphereKernel.firstCrossing(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(),
            Scaling.down(originError, length), c.x(), c.y(), c.z(), Scaling.down(radius, length)), length - step);
    }

    private double firstCrossing(Vector direction, double originError) {
        DoubleDoubleVector d = DoubleDoubleVector.of(direction);
        DoubleDouble a = d.dot(d);
        DoubleDouble b = f.dot(d).negated();
        DoubleDouble power = power(f, origin, originError);
        int side = power.sign();
        if (side == 0) {
            return b.sign() > 0 ? b.times(2).over(a) : Surface.MISS;
        }
        if (side > 0 && b.sign() <= 0) {
            return Surface.MISS;
        }
        DoubleDouble discriminant = discriminant(d, a);
        double half = Math.sqrt(Math.max(0, discriminant.high()));
        if (isDoubtful(discriminant, d, half * (Math.abs(b.high()) + half))) {
            Dyadic exact = exactDiscriminant(DyadicVector.of(direction));
            if (exact.signum() < 0) {
                return Surface.MISS;
            }
            discriminant = DoubleDouble.nearest(exact);
        }
        if (discriminant.sign() < 0) {
            return Surface.MISS;
        }
        DoubleDouble root = discriminant.squareRoot();
        if (b.sign() > 0) {
            DoubleDouble q = b.plus(root);
            return side > 0 ? power.over(q) : q.over(a);
        }
        return power.over(b.minus(root));
    }

    /** {@link SphereKernel#crossesBetween}, for the lines that it leaves open, and again for those in an ordinary size. */
    static boolean crossesBetween(double px, double py, double pz, double pointError,
                                  double qx, double qy, double qz, double endError,
                                  double cx, double cy, double cz, double radius) {
        Vector point = new Vector(px, py, pz);
        Vector end = new Vector(qx, qy, qz);
        Vector centre = new Vector(cx, cy, cz);
        int length = Scaling.exponent(radius, point, end, centre);
        if (length == 0) {
            return new CarefulSphere(point, centre, radius).crossesBefore(end, pointError, endError);
        }
        Vector p = Scaling.down(point, length);
        Vector q = Scaling.down(end, length);
        Vector c = Scaling.down(centre, length);
        return SphereKernel.crossesBetween(p.x(), p.y(), p.z(), Scaling.down(pointError, length), q.x(), q.y(), q.z(),
            Scaling.down(endError, length), c.x(), c.y(), c.z(), Scaling.down(radius, length));
    }

    private boolean crossesBefore(Vector end, double originError, double endError) {
        DoubleDoubleVector g = DoubleDoubleVector.between(centre, end);
        int originSide = power(f, origin, originError).sign();
        int endSide = power(g, end, endError).sign();
        if (originSide < 0 || endSide < 0) {
            return originSide * endSide < 0;
        }
        if (originSide == 0 && endSide == 0) {
            return false;                    // a chord from wall to wall, its ends not counted
        }
        DoubleDoubleVector d = DoubleDoubleVector.between(origin, end);
        boolean startsInwards = f.dot(d).sign() < 0;
        boolean endsOutwards = g.dot(d).sign() > 0;
        if (originSide == 0 || endSide == 0) {
            return originSide == 0 ? startsInwards : endsOutwards;
        }
        if (!(startsInwards && endsOutwards)) {
            return false;
        }
        // the same line from either end, and the less is rounded the nearer that is
        return g.dot(g).high() < f.dot(f).high() ? new CarefulSphere(end, centre, radius).meetsLine(d, origin)
            : meetsLine(d, end);
    }

    private boolean meetsLine(DoubleDoubleVector d, Vector end) {
        DoubleDouble discriminant = discriminant(d, d.dot(d));
        return isDoubtful(discriminant, d, 0)
            ? exactDiscriminant(DyadicVector.of(end).minus(DyadicVector.of(origin))).signum() >= 0
            : discriminant.sign() >= 0;
    }

    /** How a point lies to a sphere: 1 outside, 0 on it as far as the point is known, -1 inside. */
    static int side(Vector point, double pointError, Vector centre, double radius) {
        int length = Scaling.exponent(radius, point, centre);
        CarefulSphere sphere = new CarefulSphere(Scaling.down(point, length), Scaling.down(centre, length),
            Scaling.down(radius, length));
        return sphere.power(sphere.f, sphere.origin, Scaling.down(pointError, length)).sign();
    }

    /**
     * The power of a point: its squared distance from the centre minus the squared radius; 0 if the point is on the
     * sphere as far as it is known. The power's slope along an axis is twice the point's coordinate from the centre.
     */
    private DoubleDouble power(DoubleDoubleVector fromCentre, Vector point, double pointError) {
        DoubleDouble squaredDistance = fromCentre.dot(fromCentre);
        DoubleDouble squaredRadius = DoubleDouble.product(radius, radius);
        DoubleDouble power = squaredDistance.minus(squaredRadius);
        double spread = 2 * pointError * (Math.abs(fromCentre.x().high()) + Math.abs(fromCentre.y().high())
            + Math.abs(fromCentre.z().high()));
        double size = Math.abs(power.high());
        if (size > CLEAR_POWER * (squaredDistance.high() + squaredRadius.high())) {
            return size > spread ? power : DoubleDouble.ZERO;
        }
        return size < spread ? DoubleDouble.ZERO : DoubleDouble.nearest(exactPower(point));
    }

    private Dyadic exactPower(Vector point) {
        DyadicVector fromCentre = DyadicVector.of(point).minus(DyadicVector.of(centre));
        Dyadic exactRadius = Dyadic.of(radius);
        return fromCentre.dot(fromCentre).minus(exactRadius.times(exactRadius));
    }

    private DoubleDouble discriminant(DoubleDoubleVector d, DoubleDouble a) {
        DoubleDoubleVector cross = f.cross(d);
        return a.times(DoubleDouble.product(radius, radius)).minus(cross.dot(cross));
    }

    /**
     * Whether the error of a discriminant might change its sign or, by more than 2^-54, the number q of a crossing,
     * given as the product of q and the discriminant's root. The error of the root is that of the discriminant over
     * twice the root.
     */
    private boolean isDoubtful(DoubleDouble discriminant, DoubleDoubleVector d, double rootTimesQ) {
        double a = d.dot(d).high();
        double squaredRadiusTimesA = a * radius * radius;
        double squaredCross = squaredRadiusTimesA - discriminant.high();
        double error = DISCRIMINANT_ERROR * Math.sqrt(a * f.dot(f).high() * (squaredRadiusTimesA + squaredCross));
        if (discriminant.sign() >= 0 && rootTimesQ > 0) {
            return error > 0x1p-53 * rootTimesQ;
        }
        return !(Math.abs(discriminant.high()) > error);
    }

    private Dyadic exactDiscriminant(DyadicVector d) {
        DyadicVector fromCentre = DyadicVector.of(origin).minus(DyadicVector.of(centre));
        Dyadic b = fromCentre.dot(d);
        return b.times(b).minus(d.dot(d).times(exactPower(origin)));
    }
}
