package raytracing.numerics;

import java.math.BigDecimal;
import java.util.Optional;
import raytracing.math.Vector;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;

/**
 * The first crossing of a ray with a surface, as the real number that it is: (p + s sqrt(D)) / q. So any two are
 * compared without an error.
 *
 * @param p the part without a root
 * @param s sign of the root: 1 or -1, and 0 where there is none
 * @param square D, at least 0
 * @param q above 0
 */
record ExactCrossing(ExactNumber p, int s, ExactNumber square, ExactNumber q) implements Comparable<ExactCrossing> {
    /** The first crossing above 0, or nothing; touching counts, for a body is closed. */
    static Optional<ExactCrossing> first(Surface surface, Vector origin, Vector direction) {
        if (surface instanceof Plane plane) {
            return ofPlane(plane, origin, direction);
        }
        if (surface instanceof Triangle triangle) {
            return ExactTriangle.of(triangle).firstCrossing(origin, direction);
        }
        return surface instanceof Sphere sphere ? ofSphere(sphere, origin, direction)
            : ofBox((Box) surface, origin, direction);
    }

    static ExactNumber dot(Vector v, Vector w) {
        return product(v.x(), w.x()).plus(product(v.y(), w.y())).plus(product(v.z(), w.z()));
    }

    private static ExactNumber product(double a, double b) {
        return ExactNumber.of(a).times(ExactNumber.of(b));
    }

    /** c - N . P. */
    static ExactNumber gap(Plane plane, Vector point) {
        return ExactNumber.of(plane.offset()).minus(dot(plane.normal(), point));
    }

    private static Optional<ExactCrossing> ofPlane(Plane plane, Vector origin, Vector direction) {
        ExactNumber approach = dot(plane.normal(), direction);
        return approach.signum() == 0 ? Optional.empty() : rational(gap(plane, origin), approach).ifAboveZero();
    }

    /** A double, unchanged. */
    static ExactCrossing of(double t) {
        return rational(ExactNumber.of(t), ExactNumber.of(1));
    }

    /** The quotient of two numbers, the second of which is not 0. */
    static ExactCrossing rational(ExactNumber numerator, ExactNumber denominator) {
        return denominator.signum() > 0 ? new ExactCrossing(numerator, 0, ExactNumber.ZERO, denominator)
            : new ExactCrossing(numerator.negated(), 0, ExactNumber.ZERO, denominator.negated());
    }

    Optional<ExactCrossing> ifAboveZero() {
        return Optional.of(this).filter(crossing -> crossing.signum() > 0);
    }

    private static Optional<ExactCrossing> ofSphere(Sphere sphere, Vector origin, Vector direction) {
        ExactNumber a = dot(direction, direction);
        ExactNumber b = ExactNumber.ZERO;
        ExactNumber power = ExactNumber.of(sphere.radius()).squared().negated();
        for (int axis = 0; axis < 3; axis++) {
            ExactNumber f = ExactNumber.of(Axes.part(origin, axis)).minus(ExactNumber.of(Axes.part(sphere.centre(), axis)));
            b = b.minus(f.times(ExactNumber.of(Axes.part(direction, axis))));
            power = power.plus(f.squared());
        }
        ExactNumber discriminant = b.squared().minus(a.times(power));
        if (discriminant.signum() < 0) {
            return Optional.empty();
        }
        Optional<ExactCrossing> near = new ExactCrossing(b, -1, discriminant, a).ifAboveZero();
        return near.isPresent() ? near : new ExactCrossing(b, 1, discriminant, a).ifAboveZero();
    }

    private static Optional<ExactCrossing> ofBox(Box box, Vector origin, Vector direction) {
        ExactChordOfBox chord = ExactChordOfBox.of(box, origin, direction);
        if (chord.isMissed()) {
            return Optional.empty();
        }
        Optional<ExactCrossing> near = chord.enter().flatMap(ExactCrossing::ifAboveZero);
        return near.isPresent() ? near : chord.exit().flatMap(ExactCrossing::ifAboveZero);
    }

    /** Where a line enters a box and leaves it. Nothing for a line that runs in no direction of a box for ever. */
    private record ExactChordOfBox(Optional<ExactCrossing> enter, Optional<ExactCrossing> exit, boolean isBeside) {
        static ExactChordOfBox of(Box box, Vector origin, Vector direction) {
            ExactChordOfBox chord = new ExactChordOfBox(Optional.empty(), Optional.empty(), false);
            for (int axis = 0; axis < 3; axis++) {
                ExactNumber way = ExactNumber.of(Axes.part(box.centre(), axis))
                    .minus(ExactNumber.of(Axes.part(origin, axis)));
                chord = chord.cutBy(way, ExactNumber.of(Axes.part(direction, axis)),
                    ExactNumber.of(box.edge()).timesTwoTo(-1));
            }
            return chord;
        }

        private ExactChordOfBox cutBy(ExactNumber way, ExactNumber speed, ExactNumber half) {
            if (speed.signum() == 0) {
                return new ExactChordOfBox(enter, exit, isBeside || way.absolute().compareTo(half) > 0);
            }
            ExactNumber ahead = speed.signum() > 0 ? way : way.negated();
            ExactCrossing in = rational(ahead.minus(half), speed.absolute());
            ExactCrossing out = rational(ahead.plus(half), speed.absolute());
            return new ExactChordOfBox(Optional.of(enter.filter(other -> other.compareTo(in) > 0).orElse(in)),
                Optional.of(exit.filter(other -> other.compareTo(out) < 0).orElse(out)), isBeside);
        }

        boolean isMissed() {
            return isBeside || enter.orElseThrow().compareTo(exit.orElseThrow()) > 0;
        }
    }

    /** Sign of the crossing. */
    int signum() {
        return signOfSum(p, s, square);
    }

    /** Sign of u + s sqrt(v), for v at least 0. */
    private static int signOfSum(ExactNumber u, int s, ExactNumber v) {
        int rootSign = s * v.signum();
        if (rootSign == 0 || u.signum() == rootSign) {
            return u.signum() == 0 ? rootSign : u.signum();
        }
        return u.signum() == 0 ? rootSign : u.squared().compareTo(v) > 0 ? u.signum()
            : u.squared().compareTo(v) < 0 ? rootSign : 0;
    }

    /** The sign of this - other times both denominators: of A + B - C with two roots B and C. */
    @Override
    public int compareTo(ExactCrossing other) {
        ExactNumber rest = p.times(other.q).minus(other.p.times(q));
        ExactNumber squaredB = other.q.squared().times(square);
        ExactNumber squaredC = q.squared().times(other.square);
        if (squaredC.signum() == 0) {
            return signOfSum(rest, s, squaredB);
        }
        int left = signOfSum(rest, s, squaredB);
        int right = other.s;
        if (left != right) {
            return Integer.compare(left, right);
        }
        return left * signOfSum(rest.squared().plus(squaredB).minus(squaredC),
            s * rest.signum(), rest.squared().times(squaredB).timesTwoTo(2));
    }

    /** To 60 digits. */
    BigDecimal value() {
        BigDecimal root = square.signum() == 0 ? BigDecimal.ZERO
            : square.toDecimal().sqrt(ExactChord.DIGITS).multiply(BigDecimal.valueOf(s));
        return p.toDecimal().add(root).divide(q.toDecimal(), ExactChord.DIGITS);
    }
}
