package raytracing.film;

import java.awt.image.BufferedImage;
import java.awt.image.WritableRaster;
import java.util.BitSet;
import raytracing.color.Color;

/**
 * Linear light for every pixel, row by row from the upper left corner, as a picture in one band. Each pixel has one writer;
 * different threads may write different pixels, and a reader must have waited for them.
 */
public final class Film implements Bands {
    /** Most pixels that one film can hold: three numbers each in one array. */
    public static final int MOST_PIXELS = (Integer.MAX_VALUE - 8) / 3;

    private static final int CHANNELS = 3;
    private static final int FULL = 255;

    private final int width;
    private final int height;
    private final double[] light;

    /** Pixels that were not finished; there are some only in pictures that were stopped. */
    private final BitSet gaps = new BitSet();

    /** A black film of at least one and at most {@link #MOST_PIXELS} pixels. */
    public Film(int width, int height) {
        this.width = width;
        this.height = height;
        light = new double[CHANNELS * Math.multiplyExact(width, height)];
    }

    /** A copy of some rows and columns. */
    public Film part(int left, int top, int partWidth, int partHeight) {
        Film part = new Film(partWidth, partHeight);
        for (int y = 0; y < partHeight; y++) {
            System.arraycopy(light, CHANNELS * ((top + y) * width + left), part.light, CHANNELS * (y * partWidth),
                CHANNELS * partWidth);
        }
        return part;
    }

    @Override
    public int width() {
        return width;
    }

    @Override
    public int height() {
        return height;
    }

    @Override
    public int bandHeight() {
        return height;
    }

    @Override
    public Film band(int index) {
        return this;
    }

    /** Sets the linear light, at least 0 in each channel, of the pixel in column x and row y, both from 0. */
    public void set(int x, int y, double red, double green, double blue) {
        int i = CHANNELS * (y * width + x);
        light[i] = red;
        light[i + 1] = green;
        light[i + 2] = blue;
    }

    /** The linear light of a pixel; black before it is set. */
    public Color get(int x, int y) {
        int i = CHANNELS * (y * width + x);
        return new Color(light[i], light[i + 1], light[i + 2]);
    }

    /** Marks a pixel as not finished; {@code instead} is its light where a picture can have no gaps. */
    public void leaveGap(int x, int y, Color instead) {
        set(x, y, instead.red(), instead.green(), instead.blue());
        gaps.set(y * width + x);
    }

    public boolean isGap(int x, int y) {
        return gaps.get(y * width + x);
    }

    public boolean hasGaps() {
        return !gaps.isEmpty();
    }

    /** The largest difference, over the channels, of the {@link #shown} light of two pixels. */
    public double contrast(int x, int y, int otherX, int otherY) {
        int i = CHANNELS * (y * width + x);
        int j = CHANNELS * (otherY * width + otherX);
        double largest = 0;
        for (int channel = 0; channel < CHANNELS; channel++) {
            largest = Math.max(largest, Math.abs(shown(light[i + channel]) - shown(light[j + channel])));
        }
        return largest;
    }

    /** The part of a channel's linear light, at least 0, that a picture can show: at most 1. */
    public static double shown(double channel) {
        return Math.min(channel, 1);
    }

    /**
     * The picture in 8 bits a channel, of type {@link BufferedImage#TYPE_INT_RGB} and without gamma: each channel is clamped
     * to [0, 1] and rounded to the nearest of 0/255 to 255/255, ties upwards.
     */
    public BufferedImage toImage() {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        paint(image, 0);
        return image;
    }

    /** Copies all rows into an image of this type and width, from its row {@code top} on. */
    void paint(BufferedImage image, int top) {
        WritableRaster pixels = image.getRaster();   // copies rows; the image itself would convert pixel by pixel
        int[] row = new int[width];
        for (int y = 0; y < height; y++) {
            encodeRow(y, row);
            pixels.setDataElements(0, top + y, width, 1, row);
        }
    }

    /** Writes a row of the picture into an array, each pixel as {@link #encoded(int, int)}. */
    void encodeRow(int y, int[] row) {
        int i = CHANNELS * y * width;
        for (int x = 0; x < width; x++) {
            row[x] = encoded(light[i], light[i + 1], light[i + 2]);
            i += CHANNELS;
        }
    }

    /** A pixel of the picture: 8 bits each of red, green and blue, blue lowest. */
    public int encoded(int x, int y) {
        return encoded(get(x, y));
    }

    /** The pixel of a picture for some linear light: 8 bits each of red, green and blue, blue lowest. */
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
