package raytracing.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ScrambledNetTest {
    private static final int MOST = 1 << 12;

    private static double[][] points(long key, int first, int count) {
        ScrambledNet net = new ScrambledNet();
        net.begin(key);
        double[][] points = new double[count][];
        for (int i = 0; i < count; i++) {
            net.moveTo(first + i);
            points[i] = new double[] {net.x(), net.y()};
        }
        return points;
    }

    /** Every way to divide the square into 2^m equal rectangles, 2^a columns by 2^(m - a) rows: one point in each. */
    private static void assertIsNet(double[][] points) {
        int m = Integer.numberOfTrailingZeros(points.length);
        for (int a = 0; a <= m; a++) {
            Set<Integer> cells = new HashSet<>();
            for (double[] point : points) {
                int column = (int) (point[0] * (1 << a));
                int row = (int) (point[1] * (1 << (m - a)));
                cells.add(row << a | column);
            }
            assertEquals(points.length, cells.size(), "2^" + m + " points in 2^" + a + " columns");
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {0, 1, -1, 4711, Long.MIN_VALUE})
    void everyPowerOfTwoIsANet(long key) {
        for (int count = 1; count <= MOST; count *= 2) {
            assertIsNet(points(key, 0, count));
        }
    }

    @Test
    void everyQuarterOfThemIsANet() {
        for (int count = 1; count <= MOST / 4; count *= 2) {
            for (int quarter = 0; quarter < 4; quarter++) {
                assertIsNet(points(17, quarter * count, count));
            }
        }
    }

    @Test
    void noTwoPointsShareACoordinate() {
        Set<Double> xs = new HashSet<>();
        Set<Double> ys = new HashSet<>();
        for (double[] point : points(3, 0, MOST)) {
            assertTrue(point[0] >= 0 && point[0] < 1 && point[1] >= 0 && point[1] < 1);
            xs.add(point[0]);
            ys.add(point[1]);
        }
        assertEquals(MOST, xs.size());
        assertEquals(MOST, ys.size());
    }

    /**
     * Over many keys, a point is anywhere with equal chance: chi-square of 64 x 64 cells with 100 points each, of point 0 and
     * of point 5. It has 4095 degrees of freedom; five standard deviations above, a false alarm has a chance below 1e-6.
     */
    @ParameterizedTest
    @ValueSource(ints = {0, 5, 4095})
    void overAllKeysAPointIsUniform(int index) {
        int[] hits = new int[64 * 64];
        ScrambledNet net = new ScrambledNet();
        for (int key = 0; key < 100 * hits.length; key++) {
            net.begin(key);
            net.moveTo(index);
            hits[(int) (64 * net.y()) * 64 + (int) (64 * net.x())]++;
        }
        double chiSquare = 0;
        for (int count : hits) {
            chiSquare += (count - 100.0) * (count - 100.0) / 100;
        }
        assertEquals(hits.length - 1, chiSquare, 5 * Math.sqrt(2.0 * (hits.length - 1)));
    }

    /** The area of a quarter disc: independent points would be off by 0.41 / 64 at 4096 points, a net by much less. */
    @Test
    void theirMeanComesFasterToTheIntegral() {
        double squares = 0;
        int keys = 64;
        for (int key = 0; key < keys; key++) {
            int inside = 0;
            for (double[] point : points(key, 0, MOST)) {
                inside += point[0] * point[0] + point[1] * point[1] < 1 ? 1 : 0;
            }
            double error = (double) inside / MOST - Math.PI / 4;
            squares += error * error;
        }
        assertTrue(Math.sqrt(squares / keys) < 0.41 / 64 / 6, Math.sqrt(squares / keys) + "");
    }
}
