package raytracing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import raytracing.Films;
import raytracing.color.Color;
import raytracing.film.Film;

class FilmsTest {
    private static final double ROUNDING = 1e-15;

    /** Black, but for one pixel. */
    private static Film withPixel(double red, double green, double blue) {
        Film film = new Film(2, 2);
        film.set(1, 0, red, green, blue);
        return film;
    }

    /** One pixel of four is off by 3/8, 0 and 4/8: 25/64 in 12 channels. */
    @Test
    void theMeanSquareIsOverAllChannelsOfAllPixels() {
        assertEquals(Math.sqrt(25 / 64.0 / 12),
            Films.rootMeanSquare(withPixel(0.375, 0, 0.5), new Film(2, 2)), ROUNDING);
    }

    @Test
    void lightAboveFullWhiteCountsAsWhite() {
        assertEquals(0, Films.largest(withPixel(0, 9, 0), withPixel(0, 2, 0)));
        assertEquals(0.25, Films.largest(withPixel(0, 9, 0), withPixel(0, 0.75, 0)));
    }

    @Test
    void tooLittleLightIsAsWrongAsTooMuch() {
        assertEquals(0.5, Films.largest(withPixel(0.5, 0, 0), withPixel(1, 0, 0)));
        assertEquals(0.5, Films.largest(withPixel(1, 0, 0), withPixel(0.5, 0, 0)));
    }

    @Test
    void theMeanIsHalfWayInEveryChannel() {
        assertEquals(new Color(2, 4, 6),
            Films.mean(List.of(withPixel(1, 3, 5), withPixel(3, 5, 7))).get(1, 0));
    }

    @Test
    void aPixelHasChangedIfOneChannelHasByTheSmallestAmount() {
        assertEquals(0.25, Films.shareChanged(withPixel(0, 0, Double.MIN_VALUE), new Film(2, 2)));
        assertEquals(0, Films.shareChanged(withPixel(1, 2, 3), withPixel(1, 2, 3)));
    }

    @Test
    void theWorstChannelCountsForAPixel() {
        assertEquals(0.5, Films.largestOfPixel(new Color(0, 0.75, 0.5), new Color(0.25, 0.25, 0.25)));
    }
}
