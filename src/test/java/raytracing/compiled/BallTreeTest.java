package raytracing.compiled;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BallTreeTest {
    private static double[] balls(int count, double size, long seed) {
        Random random = new Random(seed);
        double[] balls = new double[BallTree.STRIDE * count];
        for (int i = 0; i < balls.length; i++) {
            balls[i] = i % BallTree.STRIDE == BallTree.RADIUS ? size * random.nextDouble() : random.nextDouble();
        }
        return balls;
    }

    private static TreeSet<Integer> found(BallTree tree, double x, double y, double z) {
        TreeSet<Integer> found = new TreeSet<>();
        BallWalk walk = new BallWalk();
        int[] order = tree.order();
        walk.start(tree, x, y, z);
        while (walk.nextLeaf()) {
            for (int i = walk.from(); i < walk.to(); i++) {
                assertTrue(found.add(order[i]), "found twice");
            }
        }
        return found;
    }

    @ParameterizedTest(name = "{0} balls of up to {1}")
    @CsvSource({"1, 2", "2, 1", "9, 0.5", "300, 0.1", "300, 1", "5000, 0.05"})
    void everyBallAroundAPointIsFoundOnce(int count, double size) {
        double[] balls = balls(count, size, 1);
        BallTree tree = new BallTree(balls);
        Random random = new Random(2);
        for (int query = 0; query < 200; query++) {
            double x = random.nextDouble();
            double y = random.nextDouble();
            double z = random.nextDouble();
            TreeSet<Integer> found = found(tree, x, y, z);
            for (int i = 0; i < count; i++) {
                int at = BallTree.STRIDE * i;
                double distance = Math.hypot(Math.hypot(x - balls[at], y - balls[at + 1]), z - balls[at + 2]);
                assertTrue(distance > balls[at + BallTree.RADIUS] || found.contains(i), "ball " + i);
            }
        }
    }

    @Test
    void mostBallsAreNotAskedFor() {
        BallTree tree = new BallTree(balls(5000, 0.05, 3));
        assertTrue(found(tree, 0.5, 0.5, 0.5).size() < 200);
    }

    @Test
    void thereAreNoBallsFarAway() {
        BallTree tree = new BallTree(balls(300, 0.1, 4));
        BallWalk walk = new BallWalk();
        walk.start(tree, 5, 0.5, 0.5);
        assertFalse(walk.nextLeaf());
    }

    @Test
    void coincidentBallsAreAllFound() {
        assertEquals(100, found(new BallTree(new double[BallTree.STRIDE * 100]), 0, 0, 0).size());
    }
}
