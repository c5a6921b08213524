package raytracing.film;

import java.awt.image.BufferedImage;
import java.awt.image.WritableRaster;
import java.util.BitSet;
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
    private static final int OPAQUE = 0xff000000;

    private final int width;
    private final int height;
    private final double[] light;

    /** Pixels that were not finished; none but in pictures that were stopped. */
    private final BitSet gaps = new BitSet();

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
     * Another film with some of this film's rows and columns.
     *
     * @param left first column
     * @param top first row
     * @param partWidth how many columns
     * @param partHeight how many rows
     * @return a copy that has its own pixels
     */
    public Film part(int left, int top, int partWidth, int partHeight) {
        Film part = new Film(partWidth, partHeight);
        for (int y = 0; y < partHeight; y++) {
            System.arraycopy(light, CHANNELS * ((top + y) * width + left), part.light, CHANNELS * (y * partWidth),
                CHANNELS * partWidth);
        }
        return part;
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
     * Makes a pixel one that was not finished.
     *
     * @param x column, in [0, width)
     * @param y row, in [0, height), from the top
     * @param instead what it shows where a picture can have no gaps
     */
    public void leaveGap(int x, int y, Color instead) {
        set(x, y, instead.red(), instead.green(), instead.blue());
        gaps.set(y * width + x);
    }

    /**
     * Whether a pixel was not finished.
     *
     * @param x column, in [0, width)
     * @param y row, in [0, height), from the top
     * @return true if it is a gap
     */
    public boolean isGap(int x, int y) {
        return gaps.get(y * width + x);
    }

    /**
     * Whether some pixels were not finished.
     *
     * @return true if there are gaps
     */
    public boolean hasGaps() {
        return !gaps.isEmpty();
    }

    /**
     * How far two pixels are apart in the picture, where light above 1 looks like 1.
     *
     * @param x column of the one, in [0, width)
     * @param y row, in [0, height), from the top
     * @param otherX column of the other
     * @param otherY row
     * @return the largest difference of a channel clamped to [0, 1]
     */
    public double contrast(int x, int y, int otherX, int otherY) {
        int i = CHANNELS * (y * width + x);
        int j = CHANNELS * (otherY * width + otherX);
        double largest = 0;
        for (int channel = 0; channel < CHANNELS; channel++) {
            largest = Math.max(largest, Math.abs(shown(light[i + channel]) - shown(light[j + channel])));
        }
        return largest;
    }

    /**
     * What a picture shows of a channel's light.
     *
     * @param channel linear light, at least 0
     * @return the channel, at most 1
     */
    public static double shown(double channel) {
        return Math.min(channel, 1);
    }

    /**
     * The picture in 8 bits a channel, without gamma: each channel clamped to [0, 1] and rounded to the nearest of
     * 0/255 to 255/255, ties upwards.
     *
     * @return a picture of type {@link BufferedImage#TYPE_INT_RGB}
     */
    public BufferedImage toImage() {
        return toImage(BufferedImage.TYPE_INT_RGB);
    }

    /**
     * The picture as {@link #toImage} has it, with transparent black in its gaps.
     *
     * @return a picture of type {@link BufferedImage#TYPE_INT_ARGB}
     */
    BufferedImage toImageWithGaps() {
        return toImage(BufferedImage.TYPE_INT_ARGB);
    }

    private BufferedImage toImage(int type) {
        BufferedImage image = new BufferedImage(width, height, type);
        paint(image, 0);
        return image;
    }

    /** Paints all rows into an image as wide as they are, from one of its rows on; with gaps if it can have some. */
    void paint(BufferedImage image, int top) {
        WritableRaster pixels = image.getRaster();   // copies rows; the image itself would convert pixel by pixel
        int[] row = new int[width];
        for (int y = 0; y < height; y++) {
            encodeRow(y, row);
            if (image.getType() == BufferedImage.TYPE_INT_ARGB) {
                cutGaps(y, row);
            }
            pixels.setDataElements(0, top + y, width, 1, row);
        }
    }

    /** Writes a row of the picture into an array: 8 bits each of red, green and blue, the last lowest. */
    void encodeRow(int y, int[] row) {
        for (int x = 0; x < width; x++) {
            row[x] = encoded(x, y);
        }
    }

    private void cutGaps(int y, int[] row) {
        for (int x = 0; x < width; x++) {
            row[x] = isGap(x, y) ? 0 : OPAQUE | row[x];
        }
    }

    /**
     * What a picture shows of a pixel.
     *
     * @param x column, in [0, width)
     * @param y row, in [0, height), from the top
     * @return 8 bits each of red, green and blue, the last lowest
     */
    public int encoded(int x, int y) {
        int i = CHANNELS * (y * width + x);
        return encoded(light[i], light[i + 1], light[i + 2]);
    }

    /**
     * What a picture would show of some light.
     *
     * @param light linear
     * @return 8 bits each of red, green and blue, the last lowest
     */
    public static int encoded(Color light) {
        return encoded(light.red(), light.green(), light.blue());
    }

    private static int encoded(double red, double green, double blue) {
        return encoded(red) << 16 | encoded(green) << 8 | encoded(blue);
    }

    private static int encoded(double channel) {
        if (channel <= 0) {
            return 0;
        }
        return channel < 1 ? (int) Math.round(FULL * channel) : FULL;
    }
}
