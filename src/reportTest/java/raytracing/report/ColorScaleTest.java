package raytracing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;
import raytracing.film.Film;

class ColorScaleTest {
    private static final int WHITE = 0xffffff;

    /** The weights with which its author defines the brightness of a colour. */
    private static double brightness(int color) {
        return 0.30 * (color >> 16 & 0xff) + 0.59 * (color >> 8 & 0xff) + 0.11 * (color & 0xff);
    }

    @Test
    void noErrorAndTheLeastAreWhite() {
        assertEquals(WHITE, ColorScale.color(0));
        assertEquals(WHITE, ColorScale.color(ColorScale.LEAST));
    }

    @Test
    void moreThanTheMostLooksLikeTheMost() {
        assertEquals(ColorScale.color(ColorScale.MOST), ColorScale.color(100));
    }

    @Test
    void theLargerTheErrorTheDarkerItsColour() {
        double last = brightness(WHITE);
        for (int i = 1; i <= 40; i++) {
            double now = brightness(ColorScale.color(Math.pow(10, -4 + i / 10.0)));
            assertTrue(now < last, "error 10 to the power of " + (-4 + i / 10.0));
            last = now;
        }
    }

    /** The formula is made for this: in grey, the scale is a straight line. */
    @Test
    void brightnessFallsEvenlyWithTheLogarithm() {
        double most = brightness(ColorScale.color(1));
        assertEquals((255 + most) / 2, brightness(ColorScale.color(0.01)), 2);
    }

    @Test
    void theLegendRunsFromTheLeastToTheMost() {
        BufferedImage legend = ColorScale.legend(401, 2);
        assertEquals(ColorScale.color(0.01), legend.getRGB(200, 1) & WHITE);
        assertEquals(brightness(WHITE), brightness(legend.getRGB(0, 0)), 1);
        assertEquals(brightness(ColorScale.color(1)), brightness(legend.getRGB(400, 0)), 1);
    }

    @Test
    void aMapHasTheColourOfEachPixelsWorstChannel() {
        Film found = new Film(2, 1);
        found.set(1, 0, 0.001, 0.03, 0);
        BufferedImage map = ErrorMap.of(found, new Film(2, 1));
        assertEquals(WHITE, map.getRGB(0, 0) & WHITE);
        assertEquals(ColorScale.color(0.03), map.getRGB(1, 0) & WHITE);
    }
}
