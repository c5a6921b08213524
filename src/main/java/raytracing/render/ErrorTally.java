package raytracing.render;

import java.util.Arrays;

/**
 * How many rays the pixels of a picture got under an {@link ErrorLimit}, and how large their errors probably are. Sums are
 * kept as whole numbers, so they are the same whatever the order in which pixels are added. Not thread-safe.
 *
 * <p>An error is that of a pixel's worst channel, in steps of 1/255. The error of the picture is the root of the mean square
 * over the pixels that show more than one value: those whose rays, or neighbours, differ by more than half a step.
 */
public final class ErrorTally {
    /** Squares of errors are summed in this unit, in squared steps; 2^31 pixels that are wholly wrong still fit. */
    private static final double UNIT = 0x1p-15;

    private static final int LOGARITHM_OF_FEWEST = Integer.numberOfTrailingZeros(PixelMean.FEWEST_RAYS);

    /** Numbers of rays: 1, then from the fewest on each twice the one before. */
    private static final int LEVELS = level(PixelMean.MOST_RAYS) + 1;

    private final long[] pixels = new long[LEVELS];
    private long varied;
    private long squares;
    private double largest;
    private long unfinished;
    private double largestUnfinished;

    private static int level(int rays) {
        return rays == 1 ? 0 : 1 + Integer.numberOfTrailingZeros(rays) - LOGARITHM_OF_FEWEST;
    }

    /** The number of rays of a level, from 0 on: 1, 4, 8, 16 and so on. */
    public static int rays(int level) {
        return level == 0 ? 1 : PixelMean.FEWEST_RAYS << level - 1;
    }

    /** Forgets all pixels. */
    void clear() {
        Arrays.fill(pixels, 0);
        varied = 0;
        squares = 0;
        largest = 0;
        unfinished = 0;
        largestUnfinished = 0;
    }

    /** Adds a pixel. */
    void add(int rays, double error, boolean isVaried) {
        pixels[level(rays)]++;
        if (isVaried) {
            varied++;
            squares += Math.round(error * error / UNIT);
            largest = Math.max(largest, error);
        }
    }

    /** Adds to the pixel before that its rays ran out while its error was still above the limit. */
    void addUnfinished(double error) {
        unfinished++;
        largestUnfinished = Math.max(largestUnfinished, error);
    }

    /** Adds all pixels of another tally. */
    void add(ErrorTally other) {
        for (int i = 0; i < LEVELS; i++) {
            pixels[i] += other.pixels[i];
        }
        varied += other.varied;
        squares += other.squares;
        largest = Math.max(largest, other.largest);
        unfinished += other.unfinished;
        largestUnfinished = Math.max(largestUnfinished, other.largestUnfinished);
    }

    /** How many numbers of rays there are. */
    public static int levels() {
        return LEVELS;
    }

    /** The most rays that a pixel can get. */
    public static int mostRays() {
        return PixelMean.MOST_RAYS;
    }

    /** How many pixels got the number of rays of a level. */
    public long pixelsAt(int level) {
        return pixels[level];
    }

    /** Pixels with more than one ray. */
    public long refined() {
        long count = 0;
        for (int i = 1; i < LEVELS; i++) {
            count += pixels[i];
        }
        return count;
    }

    /** The rays of those pixels, without their first. */
    long furtherRays() {
        long rays = 0;
        for (int i = 1; i < LEVELS; i++) {
            rays += pixels[i] * rays(i);
        }
        return rays;
    }

    /** The probable error of the picture, 0 if all its pixels show one value each. */
    public double error() {
        return varied == 0 ? 0 : Math.sqrt(squares * UNIT / varied);
    }

    /** The largest probable error of a pixel. */
    public double largest() {
        return largest;
    }

    /** Pixels whose rays ran out while their probable error was still above the limit. */
    public long unfinished() {
        return unfinished;
    }

    /** The largest error of those. */
    public double largestUnfinished() {
        return largestUnfinished;
    }
}
