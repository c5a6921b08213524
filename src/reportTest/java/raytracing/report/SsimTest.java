package raytracing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;

class SsimTest {
    private static final double C1 = 2.55 * 2.55;
    private static final double C2 = 7.65 * 7.65;
    private static final double ROUNDING = 1e-9;

    /** A slope whose middle is the middle of its only window: by symmetry its weighted mean is the grey there. */
    private static BufferedImage slope(int middle, int step) {
        return Pictures.grey(11, 11, (x, y) -> middle + step * (x - 5));
    }

    /** The weighted mean of the squared distance from the middle column, from the definition of the window. */
    private static double squaredWidth() {
        double weights = 0;
        double squares = 0;
        for (int i = -5; i <= 5; i++) {
            weights += Math.exp(-i * i / 4.5);
            squares += i * i * Math.exp(-i * i / 4.5);
        }
        return squares / weights;
    }

    @Test
    void aPictureIsWhollySimilarToItself() {
        BufferedImage picture = Pictures.grey(20, 15, (x, y) -> (x * 37 + y * 101) % 256);
        assertEquals(1, Ssim.mean(picture, picture), ROUNDING);
    }

    @Test
    void evenPicturesAreComparedByTheirMeansAlone() {
        double expected = (2 * 100 * 150 + C1) / (100 * 100 + 150 * 150 + C1);
        assertEquals(expected, Ssim.mean(Pictures.grey(16, 12, (x, y) -> 100), Pictures.grey(16, 12, (x, y) -> 150)),
            ROUNDING);
    }

    @Test
    void moreOfTheSameLightCostsOnlyTheMeans() {
        double expected = (2 * 100 * 120 + C1) / (100 * 100 + 120 * 120 + C1);
        assertEquals(expected, Ssim.mean(slope(100, 5), slope(120, 5)), ROUNDING);
    }

    @Test
    void aSlopeTurnedRoundIsAsDissimilarAsItsVariance() {
        double variance = 25 * squaredWidth();
        double expected = (-2 * variance + C2) / (2 * variance + C2);
        assertEquals(expected, Ssim.mean(slope(100, 5), slope(100, -5)), ROUNDING);
    }

    @Test
    void columnsAndRowsCountAlike() {
        BufferedImage across = Pictures.grey(11, 11, (x, y) -> 10 * x);
        BufferedImage down = Pictures.grey(11, 11, (x, y) -> 10 * y);
        BufferedImage even = Pictures.grey(11, 11, (x, y) -> 50);
        assertEquals(Ssim.mean(across, even), Ssim.mean(down, even), ROUNDING);
    }

    /** Of the 2 windows of a row of 12 pixels the first lacks the last column, and there the pictures differ. */
    @Test
    void onlyWindowsWhollyInThePictureCount() {
        BufferedImage black = Pictures.grey(12, 11, (x, y) -> 0);
        BufferedImage lastColumn = Pictures.grey(12, 11, (x, y) -> x == 11 ? 255 : 0);
        BufferedImage ofSecondWindow = Pictures.grey(11, 11, (x, y) -> x == 10 ? 255 : 0);
        double second = Ssim.mean(Pictures.grey(11, 11, (x, y) -> 0), ofSecondWindow);
        assertEquals((1 + second) / 2, Ssim.mean(black, lastColumn), ROUNDING);
    }

    @Test
    void greenCountsAsLumaHasIt() {
        BufferedImage black = Pictures.grey(11, 11, (x, y) -> 0);
        double expected = C1 / (Math.pow(0.587 * 255, 2) + C1);
        BufferedImage green = Pictures.grey(11, 11, (x, y) -> 0);
        for (int i = 0; i < 121; i++) {
            green.setRGB(i % 11, i / 11, 0x00ff00);
        }
        assertEquals(expected, Ssim.mean(black, green), ROUNDING);
    }

    @Test
    void aPictureSmallerThanTheWindowHasNoSimilarity() {
        BufferedImage small = Pictures.grey(11, 10, (x, y) -> 0);
        assertThrows(IllegalArgumentException.class, () -> Ssim.mean(small, small));
    }

    @Test
    void picturesOfDifferentSizesHaveNoSimilarity() {
        assertThrows(IllegalArgumentException.class,
            () -> Ssim.mean(Pictures.grey(11, 11, (x, y) -> 0), Pictures.grey(12, 11, (x, y) -> 0)));
    }
}
