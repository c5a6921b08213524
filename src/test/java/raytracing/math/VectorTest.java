package raytracing.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class VectorTest {
    private static final Vector A = new Vector(1, -2, 3);
    private static final Vector B = new Vector(4, 5, -6);

    @Test
    void sumAndDifferenceWorkPartByPart() {
        assertEquals(new Vector(5, 3, -3), Vectors.plus(A, B));
        assertEquals(new Vector(-3, -7, 9), A.minus(B));
        assertEquals(new Vector(-1, 2, -3), Vectors.negated(A));
        assertEquals(new Vector(2, -4, 6), A.times(2));
        assertEquals(new Vector(9, 8, -9), Vectors.plus(A, 2, B));
    }

    @Test
    void dotProductIsTheSumOfProducts() {
        assertEquals(4 - 10 - 18, A.dot(B));
    }

    @Test
    void crossProductFollowsTheRightHandRuleOfTheCoordinates() {
        assertEquals(new Vector(0, 0, 1), new Vector(1, 0, 0).cross(new Vector(0, 1, 0)));
        assertEquals(new Vector(-3, 18, 13), A.cross(B));
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "a right triangle,                          3,        4,       0",
        "negative parts,                           -2,       -3,      -6",
        "squares underflow to nothing,         1e-200,  -2e-200,  2e-200",
        "squares are subnormal,                1e-161,        0,       0",
        "the smallest number there is,         4.9e-324,      0,       0",
        "squares overflow,                      1e200,    2e200,  -2e200",
        "the largest number there is, 1.7976931348623157e308, 0,       0",
        "just below the border to the shift, 0x1p-451,   0x1p-451,     0",
        "just above the border to the shift, 0x1p-450,   0x1p-460,     0",
        "just below the upper border,        0x1p499,     0x1p499,     0",
        "just above the upper border,        0x1p500,     0x1p499,     0",
        "one part is negligible,              1e-320,        1,        0",
    })
    void lengthAndDirectionAgreeWithExactArithmetic(String why, double x, double y, double z) {
        Vector vector = new Vector(x, y, z);
        BigDecimal exact = ExactVector.of(vector).length();
        assertEquals(exact.doubleValue(), vector.length(), 3 * Math.ulp(exact.doubleValue()), why);
        assertUnit(vector);
    }

    @Test
    void directionsOfRandomVectorsOfAllMagnitudesAgreeWithExactArithmetic() {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 2_000; i++) {
            int exponent = random.nextInt(-1000, 1000);
            assertUnit(new Vector(Math.scalb(random.nextDouble(-1, 1), exponent),
                Math.scalb(random.nextDouble(-1, 1), exponent + random.nextInt(-20, 20)),
                Math.scalb(random.nextDouble(-1, 1), exponent)));
        }
    }

    private static void assertUnit(Vector vector) {
        ExactVector exact = ExactVector.of(vector);
        BigDecimal length = exact.length();
        Vector unit = vector.unit();
        double bound = 4 * Math.ulp(1.0);    // what unit() promises
        assertEquals(exact.x().divide(length, ExactVector.DIGITS).doubleValue(), unit.x(), bound);
        assertEquals(exact.y().divide(length, ExactVector.DIGITS).doubleValue(), unit.y(), bound);
        assertEquals(exact.z().divide(length, ExactVector.DIGITS).doubleValue(), unit.z(), bound);
    }

    @Test
    void scalingByAPowerOfTwoDoesNotChangeTheDirectionByABit() {
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < 10_000; i++) {
            Vector vector = new Vector(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
            assertEquals(vector.unit(), vector.times(0x1p600).unit());
            assertEquals(vector.unit(), vector.times(0x1p-600).unit());
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 0", "-0.0, 0, 0", "NaN, 1, 1", "Infinity, 1, 1", "1, -Infinity, 1"})
    void whatHasNoDirectionIsRefused(double x, double y, double z) {
        assertThrows(ArithmeticException.class, () -> new Vector(x, y, z).unit());
    }

    @Test
    void theZeroVectorHasLengthZero() {
        assertEquals(0, Vector.ZERO.length());
    }

    @Test
    void onlyTheZeroVectorIsZero() {
        assertTrue(Vector.ZERO.isZero());
        assertTrue(new Vector(-0.0, 0, -0.0).isZero());
        assertFalse(new Vector(0, Double.MIN_VALUE, 0).isZero());
        assertFalse(new Vector(0, 0, Double.NaN).isZero());
    }

    /** The textbook formula, kept as a witness: these rows are hard, and it fails them. */
    @Test
    void theTextbookLengthFailsWhereSquaresLeaveTheRange() {
        Vector small = new Vector(1e-161, 0, 0);
        double textbook = Math.sqrt(small.dot(small));
        assertTrue(Math.abs(textbook / 1e-161 - 1) > 1e-3);
        assertEquals(1e-161, small.length());
    }
}
