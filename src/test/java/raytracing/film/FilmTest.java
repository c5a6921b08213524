package raytracing.film;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.color.Color;

class FilmTest {
    @Test
    void pixelsStayWhereTheyAreSet() {
        Film film = new Film(3, 2);
        film.set(2, 0, 1, 0, 0);
        film.set(0, 1, 0, 1, 0);
        assertEquals(new Color(1, 0, 0), film.get(2, 0));
        assertEquals(Color.BLACK, film.get(0, 0));
        assertEquals(0xffff0000, film.toImage().getRGB(2, 0));
        assertEquals(0xff00ff00, film.toImage().getRGB(0, 1));
        assertEquals(0xff000000, film.toImage().getRGB(1, 1));
    }

    @Test
    void lightBeyondFullIsKeptUntilItIsEncoded() {
        Film film = new Film(1, 1);
        film.set(0, 0, 7, 0.5, 0);
        assertEquals(7, film.get(0, 0).red());
    }

    @ParameterizedTest(name = "{0}: {1} becomes {2}")
    @CsvSource({
        "no light,                 0,                   0",
        "half a step,              0.00196078431372549, 1",
        "just under half a step,   0.0019607843,        0",
        "the middle tie,           0.5,                 128",
        "just under full,          0.998,               254",
        "half a step below full,   0.9980392156862745,  255",
        "full,                     1,                   255",
        "beyond full,              1e300,               255",
        "beyond every double,      Infinity,            255",
        "below nothing,            -1,                  0",
    })
    void channelsAreClampedAndRounded(String why, double light, int expected) {
        Film film = new Film(1, 1);
        film.set(0, 0, light, light, light);
        assertEquals(expected, film.toImage().getRGB(0, 0) & 0xff, why);
    }

    @Test
    void aSizeBeyondTheLargestArrayIsRefused() {
        assertThrows(ArithmeticException.class, () -> new Film(100_000, 100_000));
    }

    @Test
    void aPartHasItsRowsAndColumnsAndPixelsOfItsOwn() {
        Film film = new Film(5, 4);
        film.set(3, 2, 7, 0.5, 0);
        Film part = film.part(2, 1, 3, 2);
        film.set(3, 2, 0, 0, 0);
        assertEquals(new Color(7, 0.5, 0), part.get(1, 1));
        assertEquals(3, part.width());
        assertEquals(2, part.height());
    }

    @Test
    void aGapShowsWhatStandsInstead() {
        Film film = new Film(2, 1);
        film.set(0, 0, 1, 0, 0);
        assertFalse(film.hasGaps());
        film.leaveGap(1, 0, new Color(0, 0, 1));
        assertTrue(film.hasGaps());
        assertTrue(film.isGap(1, 0));
        assertFalse(film.isGap(0, 0));
        assertEquals(0xff0000ff, film.toImage().getRGB(1, 0));
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "the largest difference counts, 0.5,  0.2,  0.5,  0.6, 0.4",
        "in either direction,           0.5,  0.6,  0.5,  0.2, 0.4",
        "light above 1 looks like 1,    0.75, 50,   1,    1,   0.25",
        "the same,                      0.3,  0.4,  0.3,  0.4, 0",
    })
    void contrastIsThatOfThePicture(String why, double red, double green, double otherRed, double otherGreen,
                                    double expected) {
        Film film = new Film(2, 3);
        film.set(1, 2, red, green, 1);
        film.set(0, 1, otherRed, otherGreen, 1);
        assertEquals(expected, film.contrast(1, 2, 0, 1), 1e-15, why);
        assertEquals(expected, film.contrast(0, 1, 1, 2), 1e-15, why);
    }
}
