package raytracing.watch;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

class PaceTest {
    private static final long SECOND = 1_000_000_000;

    private final Pace pace = new Pace(5 * SECOND);

    @Test
    void theRestTakesAsLongAsItsShare() {
        pace.advance(0.25, 8 * SECOND);
        assertEquals(9, pace.secondsLeft().orElseThrow(), 1e-9);
        assertEquals(25, pace.percent());
    }

    @Test
    void nothingIsForetoldFromVeryLittle() {
        pace.advance(0.009, 8 * SECOND);
        assertEquals(OptionalDouble.empty(), pace.secondsLeft());
        assertEquals(0, pace.percent());
    }

    @Test
    void theShareNeverFalls() {
        pace.advance(0.5, 8 * SECOND);
        pace.advance(0.4, 10 * SECOND);
        assertEquals(50, pace.percent());
        assertEquals(5, pace.secondsLeft().orElseThrow(), 1e-9);
    }

    @Test
    void aHundredPercentAreAll() {
        pace.advance(0.9999, 8 * SECOND);
        assertEquals(99, pace.percent());
        pace.advance(1, 9 * SECOND);
        assertEquals(100, pace.percent());
        assertEquals(0, pace.secondsLeft().orElseThrow());
    }
}
