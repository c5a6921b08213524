package raytracing.math;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** With and without the processor's help, the results are those of {@link Math#fma}, to the bit and the sign of 0. */
class FusedTest {
    private static final double[] SPECIAL = {0, -0.0, 1, -1, 3, 0.1, 1 + 0x1p-52, 1 - 0x1p-53, -(1 + 0x1p-52), 0x1p27 + 1,
        0x1.fffffffffffffp0, Double.MIN_VALUE, -Double.MIN_VALUE, Double.MIN_NORMAL, 0x1p-450, 0x1p-540, 0x1p-970, 0x1p500,
        0x1p989, 0x1p990, 0x1p1000, 0x1p1023, Double.MAX_VALUE, -Double.MAX_VALUE, Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY, Double.NaN};

    private static void check(double a, double b, double c) {
        double expected = Math.fma(a, b, c);
        String numbers = a + " * " + b + " + " + c;
        assertEquals(expected, Fused.slowMultiplyAdd(a, b, c), numbers);
        assertEquals(expected, Fused.multiplyAdd(a, b, c), numbers);
    }

    private static void checkError(double a, double b) {
        double product = a * b;
        double expected = Math.fma(a, b, -product);
        assertEquals(expected, Fused.slowErrorOfProduct(a, b, product), a + " * " + b);
        assertEquals(expected, Fused.errorOfProduct(a, b, product), a + " * " + b);
    }

    @Test
    void numbersAtTheEdgesOfTheRange() {
        for (double a : SPECIAL) {
            for (double b : SPECIAL) {
                checkError(a, b);
                for (double c : SPECIAL) {
                    check(a, b, c);
                }
            }
        }
    }

    /** A number of any size between two powers of two; one in four has few digits, so that halves are met. */
    private static double number(Random random, int leastExponent, int mostExponent) {
        long bits = random.nextLong();
        double mantissa = Double.longBitsToDouble(bits & 0x800fffffffffffffL | 0x3ff0000000000000L);
        if (random.nextInt(4) == 0) {
            mantissa = (float) mantissa;
        }
        return Math.scalb(mantissa, leastExponent + random.nextInt(mostExponent - leastExponent));
    }

    @Test
    void numbersOfAllSizes() {
        Random random = new Random(1);
        for (int i = 0; i < 200_000; i++) {
            double a = number(random, -1074, 1024);
            double b = number(random, -1074, 1024);
            checkError(a, b);
            check(a, b, number(random, -1074, 1024));
        }
    }

    /** Most products are about as large as what is added: there, the sum is small and its last bit hard to tell. */
    @Test
    void sumsThatNearlyVanish() {
        Random random = new Random(2);
        for (int i = 0; i < 200_000; i++) {
            double a = number(random, -30, 30);
            double b = number(random, -30, 30);
            int shift = random.nextInt(120) - 60;
            checkError(a, b);
            check(a, b, -a * b);
            check(a, b, Math.nextUp(-a * b));
            check(a, b, Math.scalb(-a * b, shift));
            check(a, b, Math.scalb(Math.ulp(a * b), shift) / 2);
            check(a, b, Math.scalb(number(random, -1, 1), shift));
        }
    }
}
