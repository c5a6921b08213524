package raytracing.report;

import java.awt.image.BufferedImage;
import java.util.function.IntBinaryOperator;
import raytracing.film.Film;

/** Made-up pictures. */
final class Pictures {
    private Pictures() {
    }

    /** A grey from 0 to 255 for each column and row. */
    static BufferedImage grey(int width, int height, IntBinaryOperator greyAt) {
        BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                picture.setRGB(x, y, 0x010101 * greyAt.applyAsInt(x, y));
            }
        }
        return picture;
    }

    /** The same light in all channels of all pixels. */
    static Film even(int size, double light) {
        Film film = new Film(size, size);
        for (int i = 0; i < size * size; i++) {
            film.set(i % size, i / size, light, light, light);
        }
        return film;
    }
}
