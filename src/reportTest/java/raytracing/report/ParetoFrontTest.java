package raytracing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.function.Function;
import org.junit.jupiter.api.Test;

class ParetoFrontTest {
    private static final TimedError QUICK = new TimedError(1, 8);
    private static final TimedError MIDDLE = new TimedError(2, 4);
    private static final TimedError FINE = new TimedError(4, 2);

    private static List<TimedError> front(TimedError... points) {
        return ParetoFront.of(List.of(points), Function.identity());
    }

    @Test
    void settingsThatGiveOneForTheOtherAreAllOnItTheFastestFirst() {
        assertEquals(List.of(QUICK, MIDDLE, FINE), front(FINE, QUICK, MIDDLE));
    }

    @Test
    void whoIsSlowerAndWorseIsNotOnIt() {
        assertEquals(List.of(QUICK, MIDDLE), front(QUICK, new TimedError(3, 5), MIDDLE));
    }

    @Test
    void aTieInOneFigureIsDecidedByTheOther() {
        assertEquals(List.of(MIDDLE), front(MIDDLE, new TimedError(2, 5)));
        assertEquals(List.of(MIDDLE), front(MIDDLE, new TimedError(3, 4)));
    }

    @Test
    void equalsDoNotBeatEachOther() {
        assertEquals(List.of(MIDDLE, MIDDLE), front(MIDDLE, new TimedError(2, 4)));
    }

    @Test
    void theBestInBothStandsAlone() {
        assertEquals(List.of(new TimedError(1, 1)), front(QUICK, MIDDLE, new TimedError(1, 1), FINE));
    }
}
