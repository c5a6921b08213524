package raytracing.shadow;

import raytracing.math.CounterRandom;

/**
 * Points of a light's square, and how much light comes through along the line from the hit to each of them. Obstacle after
 * obstacle dims all points whose lines it crosses: a loop over plain numbers, where a loop over obstacles for each line would
 * be calls. Not thread-safe.
 */
final class LightSamples {
    /** So many points at most at a time, which stay in the processor's nearest cache. */
    static final int MOST = 64;

    /** Along the square's axes, from its middle; in scene units. The first {@link #count} are in use. */
    final double[] x = new double[MOST];
    final double[] y = new double[MOST];

    /** From the hit. */
    final double[] squaredDistance = new double[MOST];

    /** What the obstacles so far let through, in [0, 1]. */
    final double[] transmittance = new double[MOST];
    int count;

    /**
     * Places a random point in each of some cells, to which nothing is in the way yet.
     *
     * @param first of the cells, which are counted row by row from 0
     * @param size how many cells, at most {@link #MOST}
     * @param root number of cells along an edge of the square
     * @param key of the random numbers
     */
    void place(int first, int size, int root, Shaft shaft, long key) {
        double cell = 2 * shaft.halfWidth / root;
        double halfRoot = root / 2.0;
        int row = first / root;
        int column = first % root;
        int i = 0;
        while (i < size) {
            int end = Math.min(size, i + root - column);
            double left = column - halfRoot;
            double bottom = row - halfRoot;
            for (; i < end; i++) {
                long bits = CounterRandom.bits(key, first + i);
                x[i] = (left + CounterRandom.upperFraction(bits)) * cell;
                y[i] = (bottom + CounterRandom.lowerFraction(bits)) * cell;
                left++;
            }
            column = 0;
            row++;
        }
        setDistances(shaft.depth * shaft.depth, size);
    }

    private void setDistances(double squaredDepth, int size) {
        for (int i = 0; i < size; i++) {
            squaredDistance[i] = x[i] * x[i] + y[i] * y[i] + squaredDepth;
            transmittance[i] = 1;
        }
        count = size;
    }

    /** Dims all points by a surface that all their lines cross. */
    void dimAll(double passing) {
        for (int i = 0; i < count; i++) {
            transmittance[i] *= passing;
        }
    }

    /** Adds what comes through to a sum, point by point, so that a sum over many groups is rounded as one. */
    double addTo(double sum) {
        double total = sum;
        for (int i = 0; i < count; i++) {
            total += transmittance[i];
        }
        return total;
    }
}
