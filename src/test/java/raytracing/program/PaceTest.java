package raytracing.program;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

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

    @Test
    void theTimeThatIsLeftIsSaidWhereItIsKnown() {
        assertEquals("", pace.left(", "));
        pace.advance(0.25, 8 * SECOND);
        assertEquals(", 0:09 left", pace.left(", "));
    }

    @ParameterizedTest
    @CsvSource({"0, 0:00", "0.4, 0:00", "6.6, 0:07", "59.6, 1:00", "754, 12:34", "3599.4, 59:59", "3599.5, 1:00:00",
        "3723, 1:02:03", "360000, 100:00:00"})
    void timesAreReadLikeClocks(double seconds, String text) {
        assertEquals(text, Pace.clock(seconds));
    }
}
