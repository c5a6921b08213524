package raytracing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import raytracing.Films;
import raytracing.film.Film;
import raytracing.render.Region;

class ReferenceTest {
    private static final int SIZE = 100;
    private static final double LIGHT = 0.5;
    private static final double NOISE = 0.01;

    private static Film noisy(long seed) {
        Random random = new Random(seed);
        Film film = new Film(SIZE, SIZE);
        for (int i = 0; i < SIZE * SIZE; i++) {
            film.set(i % SIZE, i / SIZE, LIGHT + NOISE * random.nextGaussian(), LIGHT + NOISE * random.nextGaussian(),
                LIGHT + NOISE * random.nextGaussian());
        }
        return film;
    }

    /** 30,000 independent numbers: their root mean square is known to half a percent. */
    @Test
    void itsOwnErrorIsThatFromTheTruth() {
        Reference reference = Reference.of(noisy(1), noisy(2), 1);
        double distance = Films.rootMeanSquare(reference.whole().orElseThrow(), Pictures.even(SIZE, LIGHT));
        assertEquals(1, reference.ownError() / distance, 0.03);
    }

    @Test
    void aHalfHasTheErrorThatItsNoiseMakes() {
        assertEquals(NOISE, Reference.of(noisy(3), noisy(4), 1).half().error(), 0.03 * NOISE);
    }

    @Test
    void thePictureWithoutErrorIsHidden() {
        Reference reference = Reference.of(noisy(5), noisy(6), 1);
        double distance = Films.rootMeanSquare(reference.whole().orElseThrow(), Pictures.even(SIZE, LIGHT));
        assertTrue(reference.hides(distance));
        assertEquals(reference.ownError(), reference.error(distance));
    }

    /** A half is off by the square root of 2 times the reference's error; two other such errors add up to more. */
    @Test
    void aPictureAsBadAsAHalfIsNotHidden() {
        Reference reference = Reference.of(noisy(7), noisy(8), 1);
        double distance = Films.rootMeanSquare(reference.whole().orElseThrow(), noisy(9));
        assertFalse(reference.hides(distance));
        assertEquals(distance, reference.error(distance));
    }

    @Test
    void squaresOfItHaveTheirOwnErrorTogether() {
        Reference squares = Reference.of(List.of(new Region(5, 5, 105, 105), new Region(205, 5, 305, 105)),
            List.of(noisy(1), Pictures.even(SIZE, LIGHT)), List.of(noisy(2), Pictures.even(SIZE, LIGHT)), 1);
        assertEquals(Reference.of(noisy(1), noisy(2), 1).ownError() / Math.sqrt(2), squares.ownError(), 1e-12);
        assertFalse(squares.whole().isPresent());
        assertEquals(2 * SIZE * SIZE, squares.pixels());
    }

    @Test
    void nothingIsHiddenByAReferenceWithoutError() {
        Reference exact = Reference.of(Pictures.even(SIZE, LIGHT), Pictures.even(SIZE, LIGHT), 1);
        assertFalse(exact.hides(0));
        assertEquals(0, exact.error(0));
    }
}
