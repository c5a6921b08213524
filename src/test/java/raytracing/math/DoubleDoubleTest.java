package raytracing.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.SplittableRandom;
import java.util.function.BinaryOperator;
import org.junit.jupiter.api.Test;

/** Every bound that {@link DoubleDouble} promises, against exact decimals. */
class DoubleDoubleTest {
    private static final int CASES = 20_000;
    private static final double U = 0x1p-53;

    private static BigDecimal exact(DoubleDouble number) {
        return new BigDecimal(number.high()).add(new BigDecimal(number.low()));
    }

    /** Of any sign, from 2^-60 to 2^60 in size, some with few bits and some with a low part far below the high one. */
    private static DoubleDouble random(SplittableRandom random) {
        double high = Math.scalb(random.nextDouble(-1, 1), random.nextInt(-60, 60));
        if (random.nextInt(4) == 0) {
            high = (float) high;
        }
        return DoubleDouble.sum(high, Math.ulp(high) * Math.scalb(random.nextDouble(-0.5, 0.5), -random.nextInt(60)));
    }

    /** Every fourth pair nearly cancels. */
    private static DoubleDouble partner(DoubleDouble number, SplittableRandom random) {
        return random.nextInt(4) > 0 ? random(random)
            : DoubleDouble.sum(-number.high() * (1 + random.nextInt(-3, 4) * 0x1p-52), number.low() / 3);
    }

    private static void assertBound(double bound, BinaryOperator<DoubleDouble> operation,
                                    BinaryOperator<BigDecimal> oracle) {
        SplittableRandom random = new SplittableRandom(11);
        for (int i = 0; i < CASES; i++) {
            DoubleDouble a = random(random);
            DoubleDouble b = partner(a, random);
            BigDecimal wanted = oracle.apply(exact(a), exact(b));
            DoubleDouble found = operation.apply(a, b);
            BigDecimal error = exact(found).subtract(wanted).abs();
            assertTrue(error.compareTo(wanted.abs().multiply(new BigDecimal(bound))) <= 0, a + " and " + b);
            assertEquals(found.high(), found.high() + found.low(), "the high part is the rounded number");
        }
    }

    @Test
    void sumsAndDifferencesKeepTheirBound() {
        assertBound(3.01 * U * U, DoubleDouble::plus, BigDecimal::add);
        assertBound(3.01 * U * U, DoubleDouble::minus, BigDecimal::subtract);
    }

    @Test
    void productsKeepTheirBound() {
        assertBound(4 * U * U, DoubleDouble::times, BigDecimal::multiply);
        assertBound(2 * U * U, (a, b) -> a.times(b.high()), (a, b) -> a.multiply(new BigDecimal(b.doubleValue())));
    }

    private static DoubleDouble nearest(BigDecimal exact) {
        double high = exact.doubleValue();
        return new DoubleDouble(high, exact.subtract(new BigDecimal(high)).doubleValue());
    }

    /** Pairs are kept as they are; a third double that neither of the two has room for is rounded away. */
    @Test
    void thePairNearestToAnExactNumberIsOffByLessThanItsOwnRounding() {
        SplittableRandom random = new SplittableRandom(12);
        for (int i = 0; i < CASES; i++) {
            DoubleDouble a = random(random);
            double rest = random.nextDouble(-1, 1) * U * U * a.high();
            Dyadic exact = Dyadic.of(a.high()).plus(Dyadic.of(a.low())).plus(Dyadic.of(rest));
            assertEquals(nearest(exact(a).add(new BigDecimal(rest))), DoubleDouble.nearest(exact));
        }
    }

    @Test
    void squareRootsKeepTheirBound() {
        MathContext digits = new MathContext(60);
        assertBound(25.0 / 8 * U * U, (a, b) -> a.times(a).squareRoot(),
            (a, b) -> exact(nearest(a).times(nearest(a))).sqrt(digits));
        assertEquals(DoubleDouble.ZERO, DoubleDouble.ZERO.squareRoot());
    }

    @Test
    void quotientsAreDoublesWithOneRounding() {
        MathContext digits = new MathContext(60);
        assertBound(U * (1 + 0x1p-40), (a, b) -> new DoubleDouble(a.over(b), 0), (a, b) -> a.divide(b, digits));
    }

    @Test
    void sumsDifferencesAndProductsOfDoublesAreExact() {
        SplittableRandom random = new SplittableRandom(12);
        for (int i = 0; i < CASES; i++) {
            double a = random(random).high();
            double b = random(random).high();
            assertEquals(0, exact(DoubleDouble.sum(a, b)).compareTo(new BigDecimal(a).add(new BigDecimal(b))));
            assertEquals(0, exact(DoubleDouble.difference(a, b))
                .compareTo(new BigDecimal(a).subtract(new BigDecimal(b))));
            assertEquals(0, exact(DoubleDouble.product(a, b))
                .compareTo(new BigDecimal(a).multiply(new BigDecimal(b))));
        }
    }

    @Test
    void theSignIsThatOfTheNumber() {
        assertEquals(-1, new DoubleDouble(-1, 0x1p-60).sign());
        assertEquals(0, DoubleDouble.difference(3, 3).sign());
        assertEquals(1, DoubleDouble.difference(0x1.0000000000001p0, 1).sign());
    }
}
