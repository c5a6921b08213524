package raytracing.color;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class ColorTest {
    private static final Color ORANGE = new Color(1, 0.5, 0);

    @Test
    void filtersWorkChannelByChannel() {
        assertEquals(new Color(0.5, 0.25, 0), ORANGE.times(0.5));
        assertEquals(new Color(0.25, 0.5, 0), ORANGE.times(new Color(0.25, 1, 4)));
    }

    @Test
    void lightBeyondEveryDoubleStaysANumberThatNothingTimesIsNothing() {
        Color overflow = new Color(1e200, 1e200, 1).times(new Color(1e200, 1, 1));
        assertEquals(new Color(Double.MAX_VALUE, 1e200, 1), overflow);
        assertEquals(new Color(0, 1e200, 1), overflow.times(new Color(0, 1, 1)));
    }

    @Test
    void onlyNoLightAtAllIsBlack() {
        assertTrue(Color.BLACK.isBlack());
        assertFalse(new Color(0, 0, Double.MIN_VALUE).isBlack());
    }

    @Test
    void theBrightestChannelIsTheMaximum() {
        assertEquals(1, ORANGE.max());
        assertEquals(3, new Color(1, 2, 3).max());
    }
}
