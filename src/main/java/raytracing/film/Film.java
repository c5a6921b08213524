package raytracing.film;

import java.awt.image.BufferedImage;
import java.awt.image.WritableRaster;
import raytracing.color.Color;

/**
 * Linear light for every pixel, row by row from the upper left corner. Each pixel has one writer; different pixels may
 * be written by different threads, and whoever reads must have waited for them.
 */
public final class Film {
    /** Most pixels that one film can hold: three numbers each in one array. */
    public static final int MOST_PIXELS = (Integer.MAX_VALUE - 8) / 3;

    private static final int CHANNELS = 3;
    private static final int FULL = 255;

    private final int width;
    private final int height;
    private final double[] light;

    /**
     * A black film.
     *
     * @param width in pixels, at least 1
     * @param height in pixels, at least 1; width times height at most {@link #MOST_PIXELS}
     */
    public Film(int width, int height) {
        this.width = width;
        this.height = height;
        light = new double[CHANNELS * Math.multiplyExact(width, height)];
    }

    /**
     * Width of the picture.
     *
     * @return in pixels
     */
    public int width() {
        return width;
    }

    /**
     * Height of the picture.
     *
     * @return in pixels
     */
    public int height() {
        return height;
    }

    /**
     * Exposes a pixel.
     *
     * @param x column, in [0, width)
     * @param y row, in [0, height), from the top
     * @param red linear light, at least 0
     * @param green linear light
     * @param blue linear light
     */
    public void set(int x, int y, double red, double green, double blue) {
        int i = CHANNELS * (y * width + x);
        light[i] = red;
        light[i + 1] = green;
        light[i + 2] = blue;
    }

    /**
     * The light of a pixel.
     *
     * @param x column, in [0, width)
     * @param y row, in [0, height), from the top
     * @return linear light as it was set, black before
     */
    public Color get(int x, int y) {
        int i = CHANNELS * (y * width + x);
        return new Color(light[i], light[i + 1], light[i + 2]);
    }

    /**
     * The picture in 8 bits a channel, without gamma: each channel clamped to [0, 1] and rounded to the nearest of
     * 0/255 to 255/255, ties upwards.
     *
     * @return a picture of type {@link BufferedImage#TYPE_INT_RGB}
     */
    public BufferedImage toImage() {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        WritableRaster pixels = image.getRaster();   // copies rows; the image itself would convert pixel by pixel
        int[] row = new int[width];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int i = CHANNELS * (y * width + x);
                row[x] = encoded(light[i]) << 16 | encoded(light[i + 1]) << 8 | encoded(light[i + 2]);
            }
            pixels.setDataElements(0, y, width, 1, row);
        }
        return image;
    }

    private static int encoded(double channel) {
        if (channel <= 0) {
            return 0;
        }
        return channel < 1 ? (int) Math.round(FULL * channel) : FULL;
    }
}
