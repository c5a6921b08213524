package raytracing.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;
import java.util.SplittableRandom;
import java.util.function.BinaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The oracle is the library's decimals, which hold every double and every sum and product of doubles. */
class DyadicTest {
    private static final int CASES = 20_000;
    private static final BigDecimal TWO = BigDecimal.valueOf(2);

    private static BigDecimal decimal(Dyadic number) {
        BigDecimal significand = new BigDecimal(number.significand());
        return number.exponent() >= 0 ? significand.multiply(TWO.pow(number.exponent()))
            : significand.divide(TWO.pow(-number.exponent()));
    }

    /** Of any size, at times close to or opposite of the one before. */
    private static double random(SplittableRandom random, double before) {
        return switch (random.nextInt(6)) {
            case 0 -> 0;
            case 1 -> Math.scalb(random.nextDouble(-1, 1), random.nextInt(-1073, 1000));
            case 2 -> -before;
            case 3 -> Math.nextUp(before);
            default -> Math.scalb(random.nextDouble(-1, 1), random.nextInt(-20, 20));
        };
    }

    private static void assertExact(BinaryOperator<Dyadic> operation, BinaryOperator<BigDecimal> oracle) {
        SplittableRandom random = new SplittableRandom(5);
        for (int i = 0; i < CASES; i++) {
            double a = random(random, 1);
            double b = random(random, a);
            BigDecimal expected = oracle.apply(new BigDecimal(a), new BigDecimal(b));
            Dyadic found = operation.apply(Dyadic.of(a), Dyadic.of(b));
            assertEquals(0, expected.compareTo(decimal(found)), a + " and " + b);
            assertEquals(expected.signum(), found.signum(), a + " and " + b);
        }
    }

    @Test
    void sumsAreExact() {
        assertExact(Dyadic::plus, BigDecimal::add);
        assertExact(Dyadic::minus, BigDecimal::subtract);
    }

    @Test
    void productsAreExact() {
        assertExact(Dyadic::times, BigDecimal::multiply);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -0.0, 1, -3, 0.1, Double.MIN_VALUE, -Double.MIN_VALUE, Double.MIN_NORMAL,
        Double.MAX_VALUE, -Double.MAX_VALUE})
    void aDoubleComesBackUnchanged(double value) {
        assertEquals(value + 0.0, Dyadic.of(value).doubleValue());
    }

    /** Sums of three doubles have any number of bits; a half of the last one more, exactly or nearly, is the hard case. */
    @Test
    void theDoubleOfANumberIsTheNearestOne() {
        SplittableRandom random = new SplittableRandom(6);
        for (int i = 0; i < CASES; i++) {
            double a = random.nextDouble(1, 2) * (random.nextBoolean() ? 1 : -1);
            double half = Math.ulp(a) / 2;
            double rest = random.nextInt(3) == 0 ? 0 : Math.scalb(random.nextDouble(-1, 1), random.nextInt(-200, -53));
            Dyadic number = Dyadic.of(a).plus(Dyadic.of(half)).plus(Dyadic.of(rest));
            assertEquals(new BigDecimal(a).add(new BigDecimal(half)).add(new BigDecimal(rest)).doubleValue(),
                number.doubleValue(), a + " and " + rest);
        }
    }

    @Test
    void beyondAllDoublesIsInfinity() {
        assertEquals(Double.POSITIVE_INFINITY, new Dyadic(BigInteger.ONE, 1024).doubleValue());
        assertEquals(Double.NEGATIVE_INFINITY, new Dyadic(BigInteger.ONE.negate(), 5000).doubleValue());
        assertEquals(0, new Dyadic(BigInteger.ONE, -5000).doubleValue());
    }

    /** Of numbers longer than doubles, and of any size. */
    private static Dyadic longNumber(SplittableRandom random) {
        Dyadic number = Dyadic.of(Math.scalb(random.nextDouble(0.5, 1), random.nextInt(-300, 300)));
        return random.nextInt(3) == 0 ? number
            : number.times(Dyadic.of(random.nextDouble(0.5, 1))).plus(number.times(Dyadic.of(0x1p-90)));
    }

    private static void assertClose(BigDecimal expected, Dyadic found) {
        BigDecimal error = expected.subtract(decimal(found)).abs();
        assertTrue(error.compareTo(expected.abs().multiply(new BigDecimal(0x1p-77))) <= 0, () -> expected + " and " + found);
    }

    @Test
    void quotientsAndRootsAreCutOffFarBehindTheDigitsOfADouble() {
        SplittableRandom random = new SplittableRandom(8);
        MathContext digits = new MathContext(60);
        for (int i = 0; i < CASES / 10; i++) {
            Dyadic a = longNumber(random);
            Dyadic b = longNumber(random);
            assertClose(decimal(a).divide(decimal(b), digits), a.over(b));
            assertClose(decimal(a).divide(decimal(b), digits).negate(), a.negated().over(b));
            assertClose(decimal(a).sqrt(digits), a.squareRoot());
        }
        assertEquals(0, Dyadic.ZERO.over(Dyadic.of(3)).signum());
        assertEquals(0, Dyadic.ZERO.squareRoot().signum());
    }
}
