package raytracing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class LogarithmicRangeTest {
    @Test
    void allDataLieInside() {
        LogarithmicRange range = LogarithmicRange.around(List.of(7.0, 0.02, 350.0));
        assertTrue(range.least() < 0.02 && range.most() > 350);
    }

    /** Only powers of ten have numbers on the axis, and one number alone makes no scale. */
    @Test
    void closeDataHaveAPowerOfTenOnBothSides() {
        LogarithmicRange range = LogarithmicRange.around(List.of(20.0, 30.0));
        assertTrue(range.least() < 10 && range.most() > 100);
        assertEquals(2, range.powersOfTen());
    }

    @Test
    void dataOverManyPowersOfTenAreNotSurroundedByMore() {
        LogarithmicRange range = LogarithmicRange.around(List.of(5.0, 5000.0));
        assertTrue(range.least() > 1 && range.most() < 10_000);
    }

    @Test
    void aSharedStepIsTheSameFactorEverywhere() {
        LogarithmicRange range = new LogarithmicRange(1, 10_000);
        assertEquals(50, range.moved(5, 0.25), 1e-9);
        assertEquals(0.5, range.moved(5, -0.25), 1e-9);
    }
}
