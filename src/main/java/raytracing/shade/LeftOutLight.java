package raytracing.shade;

import java.util.Arrays;
import raytracing.color.Color;
import raytracing.color.MutableColor;

/**
 * Estimates the light of the rays of a pixel that are not followed, in place of the background. In a hall of transparent
 * mirrors these are most rays, and together they bring much light, which is like that of the rays that were followed last:
 * their weights are the least of those followed.
 *
 * <p>Of these last rays, the later half at least, two means are known: the light E that such a ray brings by itself, and the
 * sum M of the weights of the rays as which it goes on, mirrored or, as too faint a ray, behind glass; both for a weight of 1.
 * So a ray that may be mirrored k times more brings L(k) = E + M L(k - 1), with L(-1) the background. For rays that weigh
 * still less both are smaller, M above all, so of what L(k) has beyond L(0) only a {@link #SHARE} is taken (measured in halls of
 * planes and of balls: DECISIONS). Mutable, so that following rays does not allocate. Not thread-safe.
 */
final class LeftOutLight {
    private static final double SHARE = 0.4;

    /** Number of the first ray that is recorded, a power of two: most pixels have fewer, and need no estimate. */
    private static final int FIRST = 4;

    /** In each array three channels of the sum of the weights followed, of those going on, of those replaced, of light. */
    private static final int FOLLOWED = 0;
    private static final int GOING_ON = 3;
    private static final int REPLACED = 6;
    private static final int LIGHT = 9;
    private static final int SUMS = 12;

    private final Color background;
    private final int maxReflections;
    private final double unseenWeight;
    private final double[] sums = new double[SUMS];

    /** The sums when the number of followed rays was last a power of two, and the one before. */
    private final double[] atPower = new double[SUMS];
    private final double[] atPowerBefore = new double[SUMS];

    /** Of the rays left out: the sum of their weights, and the same times how often each was mirrored. */
    private final MutableColor weights = new MutableColor();
    private final MutableColor reflections = new MutableColor();
    private int followed;

    /**
     * Nothing left out yet.
     *
     * @param background stands for the rays left out while they weigh no more than {@code unseenWeight} together
     * @param maxReflections how often light may be mirrored
     */
    LeftOutLight(Color background, int maxReflections, double unseenWeight) {
        this.background = background;
        this.maxReflections = maxReflections;
        this.unseenWeight = unseenWeight;
    }

    /** For a new pixel. */
    void clear() {
        weights.clear();
        reflections.clear();
        followed = 0;
    }

    /** A mirrored ray of this weight is followed next; until now the pixel has this light. */
    void follow(MutableColor weight, MutableColor pixel) {
        if (followed >= FIRST) {
            record(weight, pixel);
        }
        followed++;
    }

    private void record(MutableColor weight, MutableColor pixel) {
        if (Integer.bitCount(followed) == 1) {
            if (followed == FIRST) {
                Arrays.fill(sums, 0);
            }
            set(LIGHT, pixel);
            System.arraycopy(followed == FIRST ? sums : atPower, 0, atPowerBefore, 0, SUMS);
            System.arraycopy(sums, 0, atPower, 0, SUMS);
        }
        add(FOLLOWED, weight);
    }

    /** Some of the ray goes on as one of this weight, which is followed later or never. */
    void goOn(MutableColor weight) {
        if (followed > FIRST) {
            add(GOING_ON, weight);
        }
    }

    /** In place of a ray that may not be mirrored again, the background was taken. */
    void replace(MutableColor weight) {
        if (followed > FIRST) {
            add(REPLACED, weight);
        }
    }

    /** The background was taken in place of a ray that would be followed if it weighed more, mirrored so many times. */
    void leaveOut(MutableColor weight, int timesMirrored) {
        replace(weight);
        leaveWaiting(weight, timesMirrored);
    }

    /** The same after the last ray was followed. */
    void leaveWaiting(MutableColor weight, int timesMirrored) {
        weights.add(1, weight, Color.WHITE);
        reflections.add(timesMirrored, weight, Color.WHITE);
    }

    /** The last ray was followed, and the pixel has this light. */
    void end(MutableColor pixel) {
        set(LIGHT, pixel);
    }

    /** Adds to a pixel what the rays left out bring beyond the background. */
    void addTo(MutableColor pixel) {
        if (followed > FIRST && weights.max() > unseenWeight) {
            pixel.add(beyond(0, weights.red(), reflections.red(), background.red()),
                beyond(1, weights.green(), reflections.green(), background.green()),
                beyond(2, weights.blue(), reflections.blue(), background.blue()));
        }
    }

    /** In one channel; what may be unseen is not counted, so that the estimate does not begin with a step. */
    private double beyond(int channel, double weight, double weightTimesReflections, double behind) {
        double seen = weight - unseenWeight;
        double started = since(FOLLOWED + channel);
        if (!(seen > 0 && started > 0)) {
            return 0;
        }
        double own = Math.max(0, (since(LIGHT + channel) - behind * since(REPLACED + channel)) / started);
        double mirrored = since(GOING_ON + channel) / started;
        double timesLeft = maxReflections - weightTimesReflections / weight;
        double light = behind;
        for (double left = timesLeft; left > -1; left--) {
            double next = own + mirrored * light;
            light += Math.min(left + 1, 1) * (next - light);      // the last step is a part of one
        }
        double once = own + mirrored * behind;
        double beyond = seen * (once + SHARE * (light - once) - behind);
        return Math.abs(beyond) <= Double.MAX_VALUE ? beyond : beyond > 0 ? Double.MAX_VALUE : 0;
    }

    private double since(int sum) {
        return sums[sum] - atPowerBefore[sum];
    }

    private void set(int sum, MutableColor color) {
        sums[sum] = color.red();
        sums[sum + 1] = color.green();
        sums[sum + 2] = color.blue();
    }

    private void add(int sum, MutableColor weight) {
        sums[sum] += weight.red();
        sums[sum + 1] += weight.green();
        sums[sum + 2] += weight.blue();
    }
}
