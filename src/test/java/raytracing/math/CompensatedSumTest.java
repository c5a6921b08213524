package raytracing.math;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class CompensatedSumTest {
    /** s takes away what the products, rounded, add up to: 50 bits cancel, and still but the last one may be off. */
    @Test
    void cancellationCostsNothing() {
        SplittableRandom random = new SplittableRandom(13);
        for (int i = 0; i < 20_000; i++) {
            double[] v = random.doubles(6, -9, 9).toArray();
            double dot = v[0] * v[3] + v[1] * v[4] + v[2] * v[5];
            assertRoundedOnce(-dot * (1 + random.nextInt(3) * 0x1p-50), v);
        }
    }

    @Test
    void theFirstTermIsNotRoundedAway() {
        SplittableRandom random = new SplittableRandom(19);
        for (int i = 0; i < 20_000; i++) {
            assertRoundedOnce(random.nextDouble(-1_000, 1_000), random.doubles(6, -9, 9).toArray());
        }
    }

    private static void assertRoundedOnce(double s, double[] v) {
        BigDecimal exact = new BigDecimal(s);
        for (int axis = 0; axis < 3; axis++) {
            exact = exact.add(new BigDecimal(v[axis]).multiply(new BigDecimal(v[axis + 3])));
        }
        double wanted = exact.doubleValue();
        double size = Math.abs(s) + Math.abs(v[0] * v[3]) + Math.abs(v[1] * v[4]) + Math.abs(v[2] * v[5]);
        assertEquals(wanted, CompensatedSum.ofProducts(s, v[0], v[1], v[2], v[3], v[4], v[5]),
            Math.ulp(wanted) / 2 + 0x1p-102 * size);
    }
}
