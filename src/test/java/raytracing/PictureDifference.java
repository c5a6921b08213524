package raytracing;

import java.awt.image.BufferedImage;
import java.util.stream.IntStream;

/** How far a picture is from the one it should be, over all channels of all pixels, in steps of 1/255. */
public final class PictureDifference {
    private static final double FULL = 255;

    private final int pixels;
    private final int[] largestOfPixel;
    private double sum;
    private double squares;

    /** Compares two pictures of the same size. */
    public PictureDifference(BufferedImage found, BufferedImage expected) {
        if (found.getWidth() != expected.getWidth() || found.getHeight() != expected.getHeight()) {
            throw new IllegalArgumentException("pictures of different sizes");
        }
        pixels = found.getWidth() * found.getHeight();
        largestOfPixel = new int[pixels];
        for (int i = 0; i < pixels; i++) {
            int x = i % found.getWidth();
            int y = i / found.getWidth();
            for (int shift = 0; shift < 24; shift += 8) {
                int difference = (found.getRGB(x, y) >> shift & 0xff) - (expected.getRGB(x, y) >> shift & 0xff);
                sum += difference;
                squares += difference * difference;
                largestOfPixel[i] = Math.max(largestOfPixel[i], Math.abs(difference));
            }
        }
    }

    /** Peak signal-to-noise ratio in decibels; infinite for equal pictures. */
    public double psnr() {
        return 10 * Math.log10(FULL * FULL * 3 * pixels / squares);
    }

    /** Root of the mean square of found minus expected, in steps. */
    public double rootMeanSquare() {
        return Math.sqrt(squares / (3.0 * pixels));
    }

    /** The most steps by which a channel of a pixel differs. */
    public int largest() {
        return IntStream.of(largestOfPixel).max().orElse(0);
    }

    /** Mean of found minus expected. */
    public double mean() {
        return sum / (3.0 * pixels);
    }

    /** Share of pixels of which a channel differs by more than so many steps. */
    public double shareOffByMoreThan(int steps) {
        int off = 0;
        for (int largest : largestOfPixel) {
            off += largest > steps ? 1 : 0;
        }
        return (double) off / pixels;
    }

    @Override
    public String toString() {
        return psnr() + " dB, mean " + mean() + " steps, off by more than one: " + 100 * shareOffByMoreThan(1) + " %";
    }
}
