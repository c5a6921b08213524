package raytracing.film;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import raytracing.PictureDifference;

/** How far two picture files are from each other, and the map of that. */
class ComparisonTest {
    @TempDir
    private Path folder;

    private StoredPicture stored(String name, BufferedImage image) throws IOException {
        Path file = folder.resolve(name);
        ImageIO.write(image, "png", file.toFile());
        return StoredPicture.open(file);
    }

    private static BufferedImage grey(int width, int height, int value) {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < width * height; i++) {
            image.setRGB(i % width, i / width, 0x10101 * value);
        }
        return image;
    }

    private static BufferedImage random(int width, int height, long seed) {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Random random = new Random(seed);
        for (int i = 0; i < width * height; i++) {
            image.setRGB(i % width, i / width, random.nextInt(1 << 24));
        }
        return image;
    }

    /** One channel of one of 20 pixels is off by 6, another by -1: the mean square is 37 / 60. */
    @Test
    void theFiguresAreThoseOfTheirDefinitions() throws IOException {
        BufferedImage changed = grey(5, 4, 100);
        changed.setRGB(1, 2, 0x646a64);
        changed.setRGB(4, 3, 0x636464);
        try (StoredPicture found = stored("a.png", changed); StoredPicture expected = stored("b.png", grey(5, 4, 100))) {
            Comparison comparison = Comparison.of(found, expected);
            assertEquals(new Comparison(20, 37, 6, 1), comparison);
            assertEquals(Math.sqrt(37 / 60.0), comparison.rootMeanSquare(), 1e-15);
            assertEquals(10 * Math.log10(255 * 255 * 60 / 37.0), comparison.psnr(), 1e-13);
            assertEquals(0.05, comparison.shareOff());
            assertEquals(comparison, Comparison.of(expected, found));
        }
    }

    @Test
    void equalPicturesHaveNoError() throws IOException {
        try (StoredPicture found = stored("a.png", grey(3, 2, 9)); StoredPicture expected = stored("b.png", grey(3, 2, 9))) {
            Comparison comparison = Comparison.of(found, expected);
            assertEquals(0, comparison.rootMeanSquare());
            assertEquals(Double.POSITIVE_INFINITY, comparison.psnr());
            assertEquals(0, comparison.shareOff());
        }
    }

    @Test
    void blackAndWhiteAreAsFarApartAsCanBe() throws IOException {
        try (StoredPicture found = stored("a.png", grey(3, 2, 0));
             StoredPicture expected = stored("b.png", grey(3, 2, 255))) {
            Comparison comparison = Comparison.of(found, expected);
            assertEquals(255, comparison.rootMeanSquare());
            assertEquals(0, comparison.psnr());
            assertEquals(255, comparison.largest());
            assertEquals(1, comparison.shareOff());
        }
    }

    @Test
    void theFiguresAreThoseOfTheTestsOwnComparison() throws IOException {
        BufferedImage one = random(37, 23, 1);
        BufferedImage other = random(37, 23, 2);
        PictureDifference difference = new PictureDifference(one, other);
        try (StoredPicture found = stored("a.png", one); StoredPicture expected = stored("b.png", other)) {
            Comparison comparison = Comparison.of(found, expected);
            assertEquals(difference.rootMeanSquare(), comparison.rootMeanSquare(), 1e-12);
            assertEquals(difference.psnr(), comparison.psnr(), 1e-12);
            assertEquals(difference.largest(), comparison.largest());
            assertEquals(difference.shareOffByMoreThan(1), comparison.shareOff());
        }
    }

    /** As much as the eye sees of a colour (ITU-R BT.709). */
    private static double brightness(int color) {
        return 0.2126 * (color >> 16) + 0.7152 * (color >> 8 & 0xff) + 0.0722 * (color & 0xff);
    }

    @Test
    void theColoursGetBrighterWithTheDifference() {
        assertEquals(0, DifferenceMap.color(0));
        for (int steps = 1; steps <= 255; steps++) {
            double more = brightness(DifferenceMap.color(steps)) - brightness(DifferenceMap.color(steps - 1));
            assertTrue(more >= 0, "step " + steps);
        }
        assertEquals(0x2020b0, DifferenceMap.color(1));
        assertEquals(0xa028d0, DifferenceMap.color(4));
        assertEquals(0xf04838, DifferenceMap.color(16));
        assertEquals(0xffd000, DifferenceMap.color(64));
        assertEquals(0xffffff, DifferenceMap.color(255));
    }

    /** Half of the way from 16 to 64 steps. */
    @Test
    void betweenTheNamedColoursTheyChangeEvenly() {
        assertEquals(0xf88c1c, DifferenceMap.color(40));
    }

    @Test
    void aPixelOfTheMapShowsTheWorstChannel() throws IOException {
        BufferedImage changed = grey(5, 4, 100);
        changed.setRGB(1, 2, 0x637464);
        try (StoredPicture found = stored("a.png", changed); StoredPicture expected = stored("b.png", grey(5, 4, 100))) {
            Film map = new DifferenceMap(found, expected).band(0);
            for (int i = 0; i < 20; i++) {
                assertEquals(i == 11 ? 0xf04838 : 0, map.encoded(i % 5, i / 5));
            }
        }
    }

    /** Of more than 2 million pixels, so that there are two bands; writers of bmp read the lower one first. */
    @Test
    void theBandsOfALargeMapCanBeReadInAnyOrder() throws IOException {
        BufferedImage changed = grey(2048, 1030, 100);
        changed.setRGB(5, 0, 0x656464);
        changed.setRGB(6, 1029, 0x686464);
        try (StoredPicture found = stored("a.png", changed);
             StoredPicture expected = stored("b.png", grey(2048, 1030, 100))) {
            expected.load();
            DifferenceMap map = new DifferenceMap(found, expected);
            assertEquals(2, map.count());
            for (int time = 0; time < 2; time++) {
                assertEquals(0xa028d0, map.band(1).encoded(6, 5));
                assertEquals(0x2020b0, map.band(0).encoded(5, 0));
            }
        }
    }
}
