package raytracing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.List;
import org.junit.jupiter.api.Test;
import raytracing.report.EqualError.Origin;

class EqualErrorTest {
    private static final double ROUNDING = 1e-9;

    /** Four times the time for half the error. */
    private static final EqualError HALVING = new EqualError(List.of(new TimedError(16, 2), new TimedError(1, 8),
        new TimedError(64, 1), new TimedError(4, 4), new TimedError(256, 0.5)));

    private static void assertTime(double milliseconds, Origin origin, EqualError.Time found) {
        assertEquals(milliseconds, found.milliseconds(), ROUNDING * milliseconds);
        assertEquals(origin, found.origin());
    }

    @Test
    void theErrorOfASettingIsReachedInItsTime() {
        assertTime(16, Origin.INTERPOLATED, HALVING.at(2).orElseThrow());
    }

    @Test
    void betweenSettingsTheLineIsStraightOnLogarithmicAxes() {
        assertTime(8, Origin.INTERPOLATED, HALVING.at(Math.sqrt(8)).orElseThrow());
    }

    @Test
    void beyondTheFinestThePowerLawGoesOn() {
        assertTime(4096, Origin.EXTRAPOLATED, HALVING.at(0.125).orElseThrow());
    }

    @Test
    void withMoreErrorThanTheCoarsestItsTimeIsEnough() {
        assertTime(1, Origin.COARSEST, HALVING.at(10).orElseThrow());
    }

    /** The first two cost almost the same whatever they get wrong; the law is that of the last three. */
    @Test
    void theCoarserHalfHasNoVoteInTheLaw() {
        EqualError bent = new EqualError(List.of(new TimedError(10, 1000), new TimedError(11, 100),
            new TimedError(16, 2), new TimedError(64, 1), new TimedError(256, 0.5)));
        assertTime(1024, Origin.EXTRAPOLATED, bent.at(0.25).orElseThrow());
    }

    @Test
    void whatGetsNoBetterIsNotExtrapolated() {
        EqualError worse = new EqualError(List.of(new TimedError(1, 1), new TimedError(2, 2), new TimedError(4, 3),
            new TimedError(8, 4), new TimedError(16, 5)));
        assertFalse(worse.at(0.5).isPresent());
    }

    @Test
    void aLineThroughTwoPointsIsNotExtrapolated() {
        EqualError two = new EqualError(List.of(new TimedError(1, 2), new TimedError(2, 1)));
        assertFalse(two.at(0.5).isPresent());
    }

    @Test
    void ofNothingThereIsNoAnswer() {
        assertFalse(new EqualError(List.of()).at(1).isPresent());
    }

    @Test
    void settingsWithoutErrorAreLeftOut() {
        EqualError series = new EqualError(List.of(new TimedError(1, 0), new TimedError(2, 4), new TimedError(8, 1)));
        assertTime(4, Origin.INTERPOLATED, series.at(2).orElseThrow());
    }
}
