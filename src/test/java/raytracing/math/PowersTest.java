package raytracing.math;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class PowersTest {
    @ParameterizedTest
    @CsvSource({"2, 10, 1024", "0.5, 3, 0.125", "0, 4, 0", "0, 0, 1", "7, 0, 1", "1, 4096, 1", "4, 0.5, 2",
        "0, 0.5, 0", "0.5, 5000, 0"})
    void agreesWithPowersKnownByHeart(double base, double exponent, double expected) {
        assertEquals(expected, Powers.power(base, exponent));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 30, 100, 999, 4095, 4096})
    void wholeExponentsStayWithinTheProvedBound(int exponent) {
        for (double base : new double[] {0.9999, 0.99, 1 - 0x1p-20, 1 + 0x1p-52}) {
            double exact = new BigDecimal(base).pow(exponent, ExactVector.DIGITS).doubleValue();
            assertEquals(exact, Powers.power(base, exponent), exact * exponent * 0x1p-52);
        }
    }

    /** The bits of highlights hang on it: a logarithm and back would round elsewhere. */
    @Test
    void wholePowersUpTo4096AreProducts() {
        SplittableRandom random = new SplittableRandom(18);
        for (int i = 0; i < 1_000; i++) {
            double base = random.nextDouble(0.99, 1.01);
            assertEquals(base * (base * base), Powers.power(base, 3));
            double squaredTwelveTimes = base;
            for (int k = 0; k < 12; k++) {
                squaredTwelveTimes *= squaredTwelveTimes;
            }
            assertEquals(squaredTwelveTimes, Powers.power(base, 4096));
        }
    }

    @Test
    void theBorderBetweenTheTwoWaysDoesNotShow() {
        double below = Powers.power(0.999, 4096);
        double beyond = Powers.power(0.999, Math.nextUp(4096.0));
        assertEquals(below, beyond, below * 1e-12);
    }
}
