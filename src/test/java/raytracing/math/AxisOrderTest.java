package raytracing.math;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class AxisOrderTest {
    @ParameterizedTest(name = "{0} {1} {2}: {3}")
    @CsvSource({"1, 2, 3, Z_LAST", "1, 2, -3, Z_LAST", "3, 1, 2, X_LAST", "-3, -2, -1, X_LAST", "2, 3, 1, Y_LAST",
        "0, -1, 0, Y_LAST"})
    void theAxisAlongWhichTheRayGoesFurthestComesLast(double x, double y, double z, AxisOrder expected) {
        assertEquals(expected, AxisOrder.of(x, y, z));
    }

    /** Either would do, but pictures keep their last bits from version to version only if it is always the same one. */
    @ParameterizedTest(name = "{0} {1} {2}: {3}")
    @CsvSource({"1, 1, 1, Z_LAST", "1, 0, -1, Z_LAST", "0, 1, 1, Z_LAST", "1, -1, 0, X_LAST"})
    void ofEquallyFarAxesZComesLastAndOtherwiseX(double x, double y, double z, AxisOrder expected) {
        assertEquals(expected, AxisOrder.of(x, y, z));
    }
}
