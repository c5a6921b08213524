package raytracing.hierarchy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.parallel.ForkJoin;

class PointTraversalTest {
    /** Numbers of a ball: its middle, x, y and z, and its radius. */
    private static final int STRIDE = 4;

    private static final int RADIUS = 3;

    private static double[] balls(int count, double size, long seed) {
        Random random = new Random(seed);
        double[] balls = new double[STRIDE * count];
        for (int i = 0; i < balls.length; i++) {
            balls[i] = i % STRIDE == RADIUS ? size * random.nextDouble() : random.nextDouble();
        }
        return balls;
    }

    private static Hierarchy over(double[] balls) {
        Bounds bounds = new Bounds(balls.length / STRIDE);
        for (int i = 0; i < bounds.size(); i++) {
            int at = STRIDE * i;
            bounds.setAround(i, balls[at], balls[at + 1], balls[at + 2], balls[at + RADIUS]);
        }
        return Hierarchy.over(bounds, ForkJoin.sequential());
    }

    private static TreeSet<Integer> found(Hierarchy hierarchy, double x, double y, double z) {
        TreeSet<Integer> found = new TreeSet<>();
        PointTraversal traversal = new PointTraversal();
        int[] order = hierarchy.order();
        traversal.start(hierarchy, x, y, z);
        while (traversal.nextLeaf()) {
            for (int i = traversal.from(); i < traversal.to(); i++) {
                assertTrue(found.add(order[i]), "found twice");
            }
        }
        return found;
    }

    @ParameterizedTest(name = "{0} balls of up to {1}")
    @CsvSource({"1, 2", "2, 1", "9, 0.5", "300, 0.1", "300, 1", "5000, 0.05"})
    void everyBallAroundAPointIsFoundOnce(int count, double size) {
        double[] balls = balls(count, size, 1);
        Hierarchy hierarchy = over(balls);
        Random random = new Random(2);
        for (int query = 0; query < 200; query++) {
            double x = random.nextDouble();
            double y = random.nextDouble();
            double z = random.nextDouble();
            TreeSet<Integer> found = found(hierarchy, x, y, z);
            for (int i = 0; i < count; i++) {
                int at = STRIDE * i;
                double distance = Math.hypot(Math.hypot(x - balls[at], y - balls[at + 1]), z - balls[at + 2]);
                assertTrue(distance > balls[at + RADIUS] || found.contains(i), "ball " + i);
            }
        }
    }

    @Test
    void mostBallsAreNotVisited() {
        Hierarchy hierarchy = over(balls(5000, 0.05, 3));
        assertTrue(found(hierarchy, 0.5, 0.5, 0.5).size() < 200);
    }

    @Test
    void thereAreNoBallsFarAway() {
        Hierarchy hierarchy = over(balls(300, 0.1, 4));
        PointTraversal traversal = new PointTraversal();
        traversal.start(hierarchy, 5, 0.5, 0.5);
        assertFalse(traversal.nextLeaf());
    }

    @Test
    void coincidentBallsAreAllFound() {
        assertEquals(100, found(over(new double[STRIDE * 100]), 0, 0, 0).size());
    }
}
