package raytracing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import raytracing.film.Film;

class ErrorFiguresTest {
    private static final int SIZE = 11;
    private static final double ROUNDING = 1e-9;

    @Test
    void thePictureItselfHasNoError() {
        Film film = Pictures.even(SIZE, 0.3);
        assertEquals(new ErrorFigures(0, 0, Double.POSITIVE_INFINITY, 0, 1), ErrorFigures.of(film, film));
    }

    /** 0.2 is step 51 of 255, 0.4 is step 102. */
    @Test
    void anEvenErrorIsTheSameInEveryFigure() {
        ErrorFigures figures = ErrorFigures.of(Pictures.even(SIZE, 0.4), Pictures.even(SIZE, 0.2));
        assertEquals(0.2, figures.rootMeanSquare(), ROUNDING);
        assertEquals(0.2, figures.largest(), ROUNDING);
        assertEquals(20 * Math.log10(5), figures.psnr(), ROUNDING);
        assertEquals(1, figures.shareOff());
        double c1 = 2.55 * 2.55;
        assertEquals((2 * 51 * 102 + c1) / (51 * 51 + 102 * 102 + c1), figures.ssim(), ROUNDING);
    }

    @Test
    void whatNoPictureShowsIsNoError() {
        assertEquals(new ErrorFigures(0, 0, Double.POSITIVE_INFINITY, 0, 1),
            ErrorFigures.of(Pictures.even(SIZE, 3), Pictures.even(SIZE, 2)));
    }

    /** Three parts of four are right, the fourth is off by 0.2 everywhere. */
    @Test
    void partsOfEqualSizeCountAlike() {
        ErrorFigures right = ErrorFigures.of(Pictures.even(SIZE, 0.2), Pictures.even(SIZE, 0.2));
        ErrorFigures wrong = ErrorFigures.of(Pictures.even(SIZE, 0.4), Pictures.even(SIZE, 0.2));
        ErrorFigures all = ErrorFigures.ofAll(List.of(right, wrong, right, right));
        assertEquals(0.1, all.rootMeanSquare(), ROUNDING);
        assertEquals(0.2, all.largest(), ROUNDING);
        assertEquals(20 * Math.log10(10), all.psnr(), ROUNDING);
        assertEquals(0.25, all.shareOff());
        assertEquals((3 + wrong.ssim()) / 4, all.ssim(), ROUNDING);
    }

    @Test
    void aSingleStepIsNotOff() {
        assertEquals(0, ErrorFigures.of(Pictures.even(SIZE, 11 / 255.0), Pictures.even(SIZE, 10 / 255.0)).shareOff());
        assertEquals(1, ErrorFigures.of(Pictures.even(SIZE, 12 / 255.0), Pictures.even(SIZE, 10 / 255.0)).shareOff());
    }
}
