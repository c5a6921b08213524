package raytracing.numerics;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Optional;
import raytracing.math.ExactVector;

/** Ray against sphere in exact arithmetic: the discriminant and the signs of both roots are exact. */
final class ExactSphere {
    private static final MathContext MORE_DIGITS = new MathContext(ExactChord.DIGITS.getPrecision() + 5);
    private static final BigDecimal HALF = new BigDecimal("0.5");

    private ExactSphere() {
    }

    /** Inside the closed ball, or nothing where the line misses it. A touching line has a chord of one point. */
    static Optional<ExactChord> chord(Query query) {
        ExactVector o = ExactVector.of(query.origin()).minus(ExactVector.of(query.vector()));
        ExactVector d = ExactVector.of(query.direction());
        BigDecimal a = d.dot(d);
        BigDecimal b = o.dot(d).negate();
        BigDecimal c = o.dot(o).subtract(new BigDecimal(query.scalar()).pow(2));
        BigDecimal discriminant = b.multiply(b).subtract(a.multiply(c));
        return discriminant.signum() < 0 ? Optional.empty() : Optional.of(roots(a, b, c, discriminant));
    }

    /** Roots c / q and q / a: nothing cancels in q, so both have all their digits and the right sign. */
    private static ExactChord roots(BigDecimal a, BigDecimal b, BigDecimal c, BigDecimal discriminant) {
        BigDecimal root = squareRoot(discriminant);
        BigDecimal q = b.signum() >= 0 ? b.add(root) : b.subtract(root);
        if (q.signum() == 0) {
            return new ExactChord(BigDecimal.ZERO, BigDecimal.ZERO);
        }
        return ExactChord.between(c.divide(q, ExactChord.DIGITS), q.divide(a, ExactChord.DIGITS));
    }

    /**
     * To 60 digits at least: each of Newton's steps doubles the 16 that a double's root has. Ten times as fast as the
     * library's root, and it is what a test of many rays spends its time on.
     */
    private static BigDecimal squareRoot(BigDecimal exactSquare) {
        if (exactSquare.signum() == 0) {
            return BigDecimal.ZERO;
        }
        int tens = (exactSquare.precision() - exactSquare.scale()) / 2;
        return rootOfOrdinary(exactSquare.scaleByPowerOfTen(-2 * tens).round(MORE_DIGITS)).scaleByPowerOfTen(tens);
    }

    /** Of a number that is a double's size. */
    private static BigDecimal rootOfOrdinary(BigDecimal square) {
        BigDecimal root = new BigDecimal(Math.sqrt(square.doubleValue()));
        for (int step = 0; step < 2; step++) {
            root = root.add(square.divide(root, MORE_DIGITS)).multiply(HALF, MORE_DIGITS);
        }
        return root;
    }

    /** How far a point is from the sphere, inside or outside. */
    static BigDecimal distance(ExactVector point, ExactVector centre, BigDecimal radius) {
        return point.minus(centre).length().subtract(radius).abs();
    }
}
