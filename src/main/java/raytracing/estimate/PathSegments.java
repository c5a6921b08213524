package raytracing.estimate;

import raytracing.color.MutableColor;

/** Rays of light paths, each with what it found and where it ended. Not thread-safe. */
final class PathSegments {
    private static final int CHANNELS = 3;

    private final long[] from;
    private final long[] to;
    private final double[] light;
    private final double[] onward;
    private int count;

    /** Has room for so many. */
    PathSegments(int most) {
        from = new long[most];
        to = new long[most];
        light = new double[CHANNELS * most];
        onward = new double[CHANNELS * most];
    }

    /**
     * Adds a ray.
     *
     * @param fromCell where it started, or {@link FurtherLight#NO_CELL}
     * @param found light that it brought
     * @param share of the light arriving where it ended that it brings too
     * @param toCell where it ended, or {@link FurtherLight#NO_CELL}
     */
    void add(long fromCell, MutableColor found, MutableColor share, long toCell) {
        from[count] = fromCell;
        to[count] = toCell;
        put(light, found);
        put(onward, share);
        count++;
    }

    private void put(double[] into, MutableColor color) {
        into[CHANNELS * count] = color.red();
        into[CHANNELS * count + 1] = color.green();
        into[CHANNELS * count + 2] = color.blue();
    }

    int count() {
        return count;
    }

    long from(int i) {
        return from[i];
    }

    long to(int i) {
        return to[i];
    }

    /** Light that ray i brought itself, in one channel. */
    double light(int i, int channel) {
        return light[CHANNELS * i + channel];
    }

    /** The share of the light arriving where ray i ended that it brings too, in one channel. */
    double onward(int i, int channel) {
        return onward[CHANNELS * i + channel];
    }
}
