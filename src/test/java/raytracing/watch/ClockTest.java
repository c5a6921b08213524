package raytracing.watch;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ClockTest {
    @ParameterizedTest
    @CsvSource({"0, 0:00", "0.4, 0:00", "6.6, 0:07", "59.6, 1:00", "754, 12:34", "3599.4, 59:59", "3599.5, 1:00:00",
        "3723, 1:02:03", "360000, 100:00:00"})
    void timesAreReadLikeClocks(double seconds, String text) {
        assertEquals(text, Clock.text(seconds));
    }
}
