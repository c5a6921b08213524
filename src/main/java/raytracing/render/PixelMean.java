package raytracing.render;

import java.util.Arrays;
import raytracing.outline.OutlineQuery;

/**
 * The mean of what the rays of one pixel show, as it grows, and how far it may be from the pixel's true value. Rays are added
 * in the order of a {@code ScrambledNet}, up to powers of two. Not thread-safe.
 *
 * <p>Two things tell the error. The rays' four quarters, in the order of the sequence, are nets themselves; how much their
 * means differ shows how much chance is left. As four numbers may agree by luck, the error is also taken to be at least what it
 * is where a straight edge is all that makes the rays differ. Both factors are measured (SAMPLING).
 */
final class PixelMean {
    /** Fewest rays of a pixel that has more than one, and most. */
    static final int FEWEST_RAYS = 4;
    static final int MOST_RAYS = OutlineQuery.MOST_RAYS;

    /** Steps between black and white. */
    static final double STEPS = 255;

    private static final int CHANNELS = 3;
    private static final int QUARTERS = 4;

    /** Variance of the mean over that of the quarters' means: 1/4 if their errors are independent, less as nets even out. */
    private static final double OF_QUARTERS = 0.125;

    /** Variance of the mean of n rays at a straight edge, over the rays' range times their deviation, in units of n^-1.5. */
    private static final double OF_AN_EDGE = 0.3;

    private final double[] sums = new double[QUARTERS * CHANNELS];
    private final double[] squares = new double[CHANNELS];
    private final double[] least = new double[CHANNELS];
    private final double[] greatest = new double[CHANNELS];
    private int rays;
    private int planned;

    /** Forgets all rays. */
    void clear() {
        Arrays.fill(sums, 0);
        Arrays.fill(squares, 0);
        Arrays.fill(least, 1);
        Arrays.fill(greatest, 0);
        rays = 0;
        planned = FEWEST_RAYS;
    }

    /** Plans to have so many rays in all, a power of two; then they must be added. */
    void plan(int count) {
        while (planned < count) {
            planned *= 2;
            for (int c = 0; c < CHANNELS; c++) {
                sums[c] += sums[CHANNELS + c];
                sums[CHANNELS + c] = sums[2 * CHANNELS + c] + sums[3 * CHANNELS + c];
                sums[2 * CHANNELS + c] = 0;
                sums[3 * CHANNELS + c] = 0;
            }
        }
    }

    /** Adds what the next ray shows, each channel in [0, 1]. */
    void add(double red, double green, double blue) {
        int quarter = CHANNELS * (int) ((long) QUARTERS * rays / planned);
        rays++;
        add(0, quarter, red);
        add(1, quarter, green);
        add(2, quarter, blue);
    }

    private void add(int channel, int quarter, double value) {
        sums[quarter + channel] += value;
        squares[channel] += value * value;
        least[channel] = Math.min(least[channel], value);
        greatest[channel] = Math.max(greatest[channel], value);
    }

    int rays() {
        return rays;
    }

    double red() {
        return mean(0);
    }

    double green() {
        return mean(1);
    }

    double blue() {
        return mean(2);
    }

    private double mean(int channel) {
        return (sums[channel] + sums[CHANNELS + channel] + sums[2 * CHANNELS + channel] + sums[3 * CHANNELS + channel])
            / rays;
    }

    /** The probable error of the mean, in the worst channel: its standard deviation, in steps. */
    double error() {
        double largest = 0;
        for (int c = 0; c < CHANNELS; c++) {
            largest = Math.max(largest, squaredError(c));
        }
        return STEPS * Math.sqrt(largest);
    }

    /** How much the rays differ, in the worst channel: their standard deviation, in steps. */
    double deviation() {
        double largest = 0;
        for (int c = 0; c < CHANNELS; c++) {
            largest = Math.max(largest, variance(c));
        }
        return STEPS * Math.sqrt(largest);
    }

    private double variance(int channel) {
        double mean = mean(channel);
        return Math.max(0, squares[channel] / rays - mean * mean);
    }

    private double squaredError(int channel) {
        double mean = mean(channel);
        double spread = 0;
        for (int quarter = 0; quarter < QUARTERS; quarter++) {
            double difference = QUARTERS * sums[CHANNELS * quarter + channel] / rays - mean;
            spread += difference * difference;
        }
        double range = greatest[channel] - least[channel];
        return Math.max(OF_QUARTERS * spread / (QUARTERS - 1),
            OF_AN_EDGE * range * Math.sqrt(variance(channel)) / (rays * Math.sqrt(rays)));
    }
}
