package raytracing.numerics;

import java.math.BigDecimal;
import java.util.Optional;
import raytracing.math.ExactVector;
import raytracing.math.Vector;

/** Ray against box in exact arithmetic: crossings of the faces' planes stay fractions until the last one is known. */
final class ExactBox {
    private static final BigDecimal TWO = BigDecimal.valueOf(2);

    private ExactBox() {
    }

    /** Inside the closed box, or nothing where the line misses it. */
    static Optional<ExactChord> chord(Query query) {
        ExactVector toCentre = ExactVector.of(query.vector()).minus(ExactVector.of(query.origin()));
        Vector direction = query.direction();
        BigDecimal half = half(query.scalar());
        return Slab.EVERYWHERE
            .cutBy(toCentre.x(), direction.x(), half)
            .flatMap(slab -> slab.cutBy(toCentre.y(), direction.y(), half))
            .flatMap(slab -> slab.cutBy(toCentre.z(), direction.z(), half))
            .map(slab -> new ExactChord(slab.enter.value(), slab.exit.value()));
    }

    static BigDecimal half(double edge) {
        return new BigDecimal(edge).divide(TWO);
    }

    /** How far a point is from one face of the box: from its plane, or sideways from its rim if that is more. */
    static BigDecimal distanceToFace(ExactVector fromCentre, Vector face, BigDecimal half) {
        return distanceOnAxis(fromCentre.x(), face.x(), half)
            .max(distanceOnAxis(fromCentre.y(), face.y(), half))
            .max(distanceOnAxis(fromCentre.z(), face.z(), half));
    }

    /** On the face's own axis, the way to its plane; on another, the way back between its rims. */
    private static BigDecimal distanceOnAxis(BigDecimal fromCentre, double outward, BigDecimal half) {
        return outward == 0
            ? fromCentre.abs().subtract(half).max(BigDecimal.ZERO)
            : fromCentre.subtract(half.multiply(new BigDecimal(outward))).abs();
    }

    /** A stretch of the line, its ends not divided yet. The whole line reaches further than doubles can tell. */
    private record Slab(Fraction enter, Fraction exit) {
        private static final Fraction FAR_AWAY = new Fraction(BigDecimal.ONE.scaleByPowerOfTen(1000), BigDecimal.ONE);
        static final Slab EVERYWHERE = new Slab(FAR_AWAY.negated(), FAR_AWAY);

        /** What is left of it between a pair of faces, or nothing. */
        Optional<Slab> cutBy(BigDecimal toCentre, double direction, BigDecimal half) {
            if (direction == 0) {
                return Optional.of(this).filter(slab -> toCentre.abs().compareTo(half) <= 0);
            }
            BigDecimal speed = new BigDecimal(direction).abs();
            BigDecimal ahead = direction > 0 ? toCentre : toCentre.negate();
            Slab cut = new Slab(enter.later(new Fraction(ahead.subtract(half), speed)),
                exit.earlier(new Fraction(ahead.add(half), speed)));
            return Optional.of(cut).filter(slab -> slab.enter.compareTo(slab.exit) <= 0);
        }
    }

    /** A quotient that is compared exactly. The denominator is above 0. */
    private record Fraction(BigDecimal numerator, BigDecimal denominator) implements Comparable<Fraction> {
        @Override
        public int compareTo(Fraction other) {
            return numerator.multiply(other.denominator).compareTo(other.numerator.multiply(denominator));
        }

        Fraction later(Fraction other) {
            return compareTo(other) >= 0 ? this : other;
        }

        Fraction earlier(Fraction other) {
            return compareTo(other) <= 0 ? this : other;
        }

        Fraction negated() {
            return new Fraction(numerator.negate(), denominator);
        }

        BigDecimal value() {
            return numerator.divide(denominator, ExactChord.DIGITS);
        }
    }
}
