package raytracing.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Numbers with roots against decimals of 200 digits, and against equal numbers that are written otherwise. */
class SurdTest {
    private static final int CASES = 20_000;
    private static final MathContext DIGITS = new MathContext(200);

    /** Random numbers of few bits are often equal, or close. */
    private static Dyadic whole(SplittableRandom random, int bound) {
        return Dyadic.of(random.nextInt(-bound, bound + 1));
    }

    private static Surd random(SplittableRandom random, int bound) {
        return new Surd(whole(random, bound), whole(random, bound), Dyadic.of(random.nextInt(1, bound + 1)));
    }

    private static BigDecimal decimal(Surd surd) {
        BigDecimal square = new BigDecimal(surd.signedSquare().doubleValue());
        BigDecimal root = square.abs().sqrt(DIGITS);
        return new BigDecimal(surd.rational().doubleValue()).add(square.signum() < 0 ? root.negate() : root)
            .divide(new BigDecimal(surd.divisor().doubleValue()), DIGITS);
    }

    /** Roots of different whole numbers up to 30 differ by more than 100 digits can hide. */
    private static int sign(BigDecimal number) {
        return number.abs().compareTo(new BigDecimal("1e-100")) < 0 ? 0 : number.signum();
    }

    @Test
    void theOrderIsThatOfTheRealNumbers() {
        SplittableRandom random = new SplittableRandom(71);
        int equal = 0;
        for (int i = 0; i < CASES; i++) {
            Surd a = random(random, 30);
            Surd b = random(random, 30);
            int expected = sign(decimal(a).subtract(decimal(b)));
            assertEquals(expected, a.compareTo(b), () -> a + " and " + b);
            assertEquals(-expected, b.compareTo(a), () -> b + " and " + a);
            assertEquals(sign(decimal(a)), a.signum(), a::toString);
            equal += expected == 0 ? 1 : 0;
        }
        assertTrue(equal > 0, "no pair of equal numbers");
    }

    /** The number times f over f, where f is a sum of three doubles, and so longer than a double. */
    @Test
    void equalNumbersCompareAsEqualHoweverTheyAreWritten() {
        SplittableRandom random = new SplittableRandom(72);
        for (int i = 0; i < CASES; i++) {
            Surd surd = new Surd(Dyadic.of(random.nextDouble(-1, 1)), Dyadic.of(random.nextDouble(-1, 1)),
                Dyadic.of(random.nextDouble(0.5, 1)));
            Dyadic f = Dyadic.of(1).plus(Dyadic.of(random.nextDouble(0x1p-60))).plus(Dyadic.of(0x1p-300));
            Surd other = new Surd(surd.rational().times(f), surd.signedSquare().times(f).times(f), surd.divisor().times(f));
            assertEquals(0, surd.compareTo(other), surd::toString);
            Surd larger = new Surd(other.rational().plus(Dyadic.of(0x1p-1000)), other.signedSquare(), other.divisor());
            assertEquals(-1, surd.compareTo(larger), surd::toString);
        }
    }

    @ParameterizedTest
    @CsvSource({
        "3, 16, 7,  1", "3, -16, 7,  -0.14285714285714285", "0, 2, 1,  1.4142135623730951", "0, -2, 4,  -0.3535533905932738",
        "1, 0, 3,  0.3333333333333333", "-1, 1, 5,  0", "1e308, 1e308, 0.5, Infinity", "-1e200, 0, 1e-200, -Infinity",
    })
    void theDoubleIsTheNearestOne(double p, double square, double divisor, double expected) {
        assertEquals(expected, new Surd(Dyadic.of(p), Dyadic.of(square), Dyadic.of(divisor)).doubleValue() + 0.0);
    }

    /** p and the root of p p - q with a small q: what a ray's near crossing looks like that starts close to a sphere. */
    @Test
    void theDoubleKeepsItsDigitsWhereARootNearlyCancels() {
        SplittableRandom random = new SplittableRandom(73);
        for (int i = 0; i < CASES; i++) {
            double p = random.nextDouble(1, 2);
            double q = Math.scalb(random.nextDouble(1, 2), random.nextInt(-600, -1));
            Dyadic square = Dyadic.of(p).times(Dyadic.of(p)).minus(Dyadic.of(q));
            double found = new Surd(Dyadic.of(p), square.negated(), Dyadic.of(1)).doubleValue();
            BigDecimal b = new BigDecimal(p);
            BigDecimal exact = new BigDecimal(q)
                .divide(b.add(b.multiply(b).subtract(new BigDecimal(q)).sqrt(DIGITS)), DIGITS);
            assertEquals(exact.doubleValue(), found, Math.ulp(found), () -> p + " and " + q);
        }
    }

    @Test
    void aQuotientWithADivisorBelowZeroIsTheSameNumber() {
        Surd quotient = Surd.quotient(Dyadic.of(3), Dyadic.of(-4));
        assertEquals(-0.75, quotient.doubleValue());
        assertEquals(-1, quotient.signum());
        assertEquals(1, Surd.ZERO.compareTo(quotient));
    }
}
