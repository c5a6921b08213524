package raytracing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

class PowerLawTest {
    private static final double ROUNDING = 1e-12;

    @Test
    void aSeriesThatFollowsOneGivesItBack() {
        PowerLaw law = PowerLaw.fitted(List.of(new TimedError(1, 8), new TimedError(4, 4), new TimedError(16, 2)));
        assertEquals(-0.5, law.exponent(), ROUNDING);
        assertEquals(8, law.errorOfMillisecond(), ROUNDING);
    }

    /** Twice too large and twice too small at the same time cancel each other. */
    @Test
    void theFitIsInLogarithms() {
        PowerLaw law = PowerLaw.fitted(List.of(new TimedError(1, 8), new TimedError(4, 8), new TimedError(4, 2),
            new TimedError(16, 2)));
        assertEquals(-0.5, law.exponent(), ROUNDING);
    }

    @Test
    void itTellsWhenAnErrorIsReached() {
        assertEquals(64, new PowerLaw(-0.5, 8).milliseconds(1), 1e-9);
    }
}
