package raytracing.film;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

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
}
