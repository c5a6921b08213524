package raytracing.estimate;

import java.util.Arrays;
import java.util.List;
import raytracing.color.MutableColor;
import raytracing.math.CounterRandom;
import raytracing.math.Vector;
import raytracing.shade.VertexReservoir;
import raytracing.surface.Hit;

/**
 * The light that arrives where the first rays of gather points end. It is a mean over small cells of the surfaces, in which
 * all paths share what they find (Keller, Dahm, Binder, Path Space Filtering, SIGGRAPH 2014 talks). What rays from a cell
 * bring depends on the light in other cells: all bounces together solve a system of linear equations, as in radiosity
 * (Goral, Torrance, Greenberg, Battaile, Modeling the Interaction of Light Between Diffuse Surfaces, SIGGRAPH 1984). Not
 * changed once it is made.
 */
final class FurtherLight {
    /** The number of no cell. */
    static final long NO_CELL = 0;

    private static final int CHANNELS = 3;

    /** A cell's edge is the power of two below the distance from the eye over this number (measured: DECISIONS). */
    private static final double CELLS_IN_DISTANCE = 8;

    /** Each adds a bounce to the first guess, which has the mean of all bounces already. */
    private static final int ITERATIONS = 6;

    private static final int DIRECTIONS = 6;

    private final long[] cells;
    private final double[] light;
    private final double[] mean = new double[CHANNELS];

    /** Solved from rays that started in cells. */
    FurtherLight(List<PathSegments> paths) {
        int count = 0;
        for (PathSegments segments : paths) {
            count += segments.count();
        }
        long[] numbers = new long[count];
        int at = 0;
        for (PathSegments segments : paths) {
            for (int i = 0; i < segments.count(); i++) {
                numbers[at++] = segments.from(i);
            }
        }
        cells = different(numbers);
        light = new double[CHANNELS * cells.length];
        guess(paths, count);
        int[] ends = new int[2 * count];
        at = 0;
        for (PathSegments segments : paths) {
            for (int i = 0; i < segments.count(); i++) {
                ends[at++] = find(segments.from(i));
                ends[at++] = find(segments.to(i));
            }
        }
        for (int iteration = 0; iteration < ITERATIONS; iteration++) {
            addBounce(paths, ends);
        }
    }

    private static long[] different(long[] numbers) {
        Arrays.sort(numbers);
        int count = 0;
        for (int i = 0; i < numbers.length; i++) {
            if (i == 0 || numbers[i] != numbers[i - 1]) {
                numbers[count++] = numbers[i];
            }
        }
        return Arrays.copyOf(numbers, count);
    }

    /**
     * Light by endless bounces if all cells were alike: if rays find light b and bring a share r of what arrives where they
     * end, together b + r b + r r b + ... = b / (1 - r).
     */
    private void guess(List<PathSegments> paths, int count) {
        for (int channel = 0; channel < CHANNELS; channel++) {
            double found = 0;
            double onward = 0;
            for (PathSegments segments : paths) {
                for (int i = 0; i < segments.count(); i++) {
                    found += segments.light(i, channel);
                    onward += segments.onward(i, channel);
                }
            }
            double lost = Math.max(count - onward, (1 - VertexReservoir.MOST_REFLECTANCE) * count);
            mean[channel] = count == 0 ? 0 : Math.min(found / lost, Double.MAX_VALUE);
        }
        for (int i = 0; i < light.length; i++) {
            light[i] = mean[i % CHANNELS];
        }
    }

    private void addBounce(List<PathSegments> paths, int[] ends) {
        double[] sums = new double[light.length];
        int[] counts = new int[cells.length];
        int at = 0;
        for (PathSegments segments : paths) {
            for (int i = 0; i < segments.count(); i++) {
                int from = ends[at++];
                int to = ends[at++];
                counts[from]++;
                for (int channel = 0; channel < CHANNELS; channel++) {
                    sums[CHANNELS * from + channel] += segments.light(i, channel)
                        + segments.onward(i, channel) * light(to, channel);
                }
            }
        }
        for (int i = 0; i < sums.length; i++) {
            light[i] = Math.min(sums[i] / counts[i / CHANNELS], Double.MAX_VALUE);
        }
    }

    private int find(long cell) {
        return Arrays.binarySearch(cells, cell);
    }

    /** Of a cell from which no ray started, the mean of all. */
    private double light(int index, int channel) {
        return index >= 0 ? light[CHANNELS * index + channel] : mean[channel];
    }

    /** Adds the light that arrives in a cell, each channel times its share. */
    void addTo(MutableColor sum, MutableColor share, long cell) {
        int index = find(cell);
        sum.add(share.red() * light(index, 0), share.green() * light(index, 1), share.blue() * light(index, 2));
    }

    /** The number of a point's cell: a hash of the cell's place, its size and the axis that is nearest to the normal. */
    static long cell(Hit hit, Vector eye) {
        double x = hit.x() - eye.x();
        double y = hit.y() - eye.y();
        double z = hit.z() - eye.z();
        int exponent = Math.getExponent(Vector.length(x, y, z) / CELLS_IN_DISTANCE);
        double perEdge = Math.scalb(1.0, -exponent);
        long key = CounterRandom.bits(DIRECTIONS * exponent + direction(hit), (long) Math.floor(x * perEdge));
        key = CounterRandom.bits(key, (long) Math.floor(y * perEdge));
        key = CounterRandom.bits(key, (long) Math.floor(z * perEdge));
        return key == NO_CELL ? 1 : key;
    }

    private static int direction(Hit hit) {
        double x = Math.abs(hit.normalX());
        double y = Math.abs(hit.normalY());
        double z = Math.abs(hit.normalZ());
        if (x > y && x > z) {
            return hit.normalX() > 0 ? 0 : 1;
        }
        if (y > z) {
            return hit.normalY() > 0 ? 2 : 3;
        }
        return hit.normalZ() > 0 ? 4 : 5;
    }
}
