package raytracing.color;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class ColorTest {
    @Test
    void lightBeyondEveryDoubleIsTheLargestDouble() {
        assertEquals(new Color(Double.MAX_VALUE, 1e200, 1), new Color(1e200 * 1e200, 1e200, 1));
    }

    @Test
    void onlyNoLightAtAllIsBlack() {
        assertTrue(Color.BLACK.isBlack());
        assertFalse(new Color(0, 0, Double.MIN_VALUE).isBlack());
    }
}
