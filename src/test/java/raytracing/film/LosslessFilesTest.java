package raytracing.film;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.color.Color;

/** The files that this program writes itself are those that ImageIO would write. */
class LosslessFilesTest {
    /** Colours at random, which hardly get smaller: 300 x 200 of them take six chunks of a PNG file. */
    private static Film noise(int width, int height) {
        Random random = new Random(7);
        Film film = new Film(width, height);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                film.set(x, y, 1.2 * random.nextDouble(), random.nextDouble(), x / (double) width);
            }
        }
        return film;
    }

    private static byte[] written(Encoder encoder) throws IOException {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        encoder.writeTo(file);
        return file.toByteArray();
    }

    private static byte[] byImageIo(BufferedImage image, String format) throws IOException {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        ImageIO.write(image, format, file);
        return file.toByteArray();
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "2, 1", "3, 2", "5, 7", "300, 200"})
    void aPngIsThatOfImageIo(int width, int height) throws IOException {
        Film film = noise(width, height);
        assertArrayEquals(byImageIo(film.toImage(), "png"), written(new PngEncoder(film)));
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "2, 1", "3, 2", "4, 2", "5, 7", "300, 200"})
    void aBmpIsThatOfImageIo(int width, int height) throws IOException {
        Film film = noise(width, height);
        assertArrayEquals(byImageIo(film.toImage(), "bmp"), written(new BmpEncoder(film)));
    }

    @Test
    void aPngWithGapsIsThatOfImageIo() throws IOException {
        Film film = noise(40, 30);
        film.leaveGap(0, 0, Color.WHITE);
        film.leaveGap(39, 29, Color.WHITE);
        BufferedImage image = new BufferedImage(40, 30, BufferedImage.TYPE_INT_ARGB);
        image.getGraphics().drawImage(film.toImage(), 0, 0, null);
        image.setRGB(0, 0, 0);
        image.setRGB(39, 29, 0);
        assertArrayEquals(byImageIo(image, "png"), written(new PngEncoder(film)));
    }

    /** The gaps of a later band are not known when the header is written. */
    @Test
    void aPngInBandsHasNoTransparentPixel() throws IOException {
        Film film = noise(4, 4);
        film.leaveGap(1, 0, Color.WHITE);
        Bands bands = new Bands() {
            @Override
            public int width() {
                return 4;
            }

            @Override
            public int height() {
                return 8;
            }

            @Override
            public int bandHeight() {
                return 4;
            }

            @Override
            public Film band(int index) {
                return film;
            }
        };
        BufferedImage read = ImageIO.read(new ByteArrayInputStream(written(new PngEncoder(bands))));
        assertEquals(0xffffffff, read.getRGB(1, 0));
        assertEquals(0xffffffff, read.getRGB(1, 4));
        assertEquals(film.toImage().getRGB(2, 3), read.getRGB(2, 7));
    }
}
