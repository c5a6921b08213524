package raytracing.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import raytracing.math.Vector;

/**
 * Ordinary questions are answered in doubles. A kernel whose bounds leave too much to exact numbers is as right as before,
 * only slow. The bodies reach 1 from the middle along the axes.
 */
class QuickStepTest {
    private static final int CASES = 1_000;

    /** A single exact answer for each ten questions makes more objects. */
    private static final long MOST_BYTES = 10 * CASES;
    private static final double ERROR = 0x1p-49;

    private enum Body {
        SPHERE {
            @Override
            double firstCrossing(double[] p, double[] d) {
                return SphereKernel.firstCrossing(p[0], p[1], p[2], d[0], d[1], d[2], ERROR, 0, 0, 0, 1);
            }

            @Override
            Answer crossesBetween(double[] p, double[] q) {
                return SphereKernel.crossesBetween(p[0], p[1], p[2], ERROR, q[0], q[1], q[2], ERROR, 0, 0, 0, 1);
            }

            @Override
            Answer isOutside(double[] p) {
                return SphereKernel.isOutside(p[0], p[1], p[2], ERROR, 0, 0, 0, 1);
            }

            @Override
            boolean isPlainlyMissed(double[] p, double[] d) {
                return SphereKernel.isPlainlyMissed(p[0], p[1], p[2], d[0], d[1], d[2], ERROR, 0, 0, 0, 1);
            }
        },

        BOX {
            @Override
            double firstCrossing(double[] p, double[] d) {
                return BoxKernel.firstCrossing(p[0], p[1], p[2], d[0], d[1], d[2], ERROR, 0, 0, 0, 1);
            }

            @Override
            Answer crossesBetween(double[] p, double[] q) {
                return BoxKernel.crossesBetween(p[0], p[1], p[2], ERROR, q[0], q[1], q[2], ERROR, 0, 0, 0, 1);
            }

            @Override
            Answer isOutside(double[] p) {
                return BoxKernel.isOutside(p[0], p[1], p[2], ERROR, 0, 0, 0, 1);
            }

            @Override
            boolean isPlainlyMissed(double[] p, double[] d) {
                return BoxKernel.isPlainlyMissed(p[0], p[1], p[2], d[0], d[1], d[2], Surface.MISS, ERROR, 0, 0, 0, 1);
            }
        };

        abstract double firstCrossing(double[] p, double[] d);

        abstract Answer crossesBetween(double[] p, double[] q);

        abstract Answer isOutside(double[] p);

        abstract boolean isPlainlyMissed(double[] p, double[] d);
    }

    /** A question about two vectors, and whether its answer is the expected one. */
    private interface Question {
        boolean isAnsweredRightly(double[] first, double[] second);
    }

    /** In a random direction, from {@code least} to {@code most} far from the middle. */
    private static Vector around(SplittableRandom random, double least, double most) {
        return SphereTest.randomVector(random, 1).unit().times(random.nextDouble(least, most));
    }

    private static double[] parts(Vector vector) {
        return new double[] {vector.x(), vector.y(), vector.z()};
    }

    private static void assertMadeOfDoubles(Stream<Vector[]> pairs, Question question) {
        double[][][] numbers = pairs.limit(CASES)
            .map(pair -> new double[][] {parts(pair[0]), parts(pair[1])}).toArray(double[][][]::new);
        assertEquals(CASES, countRight(numbers, question));      // and whatever is made once, is made now
        ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = thread.getCurrentThreadAllocatedBytes();
        countRight(numbers, question);
        long made = thread.getCurrentThreadAllocatedBytes() - before;
        assertTrue(made < MOST_BYTES, made + " bytes made");
    }

    private static int countRight(double[][][] numbers, Question question) {
        int right = 0;
        for (double[][] pair : numbers) {
            right += question.isAnsweredRightly(pair[0], pair[1]) ? 1 : 0;
        }
        return right;
    }

    private static Stream<Vector[]> rays(long seed, double leastStart, double mostStart, double mostAside) {
        SplittableRandom random = new SplittableRandom(seed);
        return Stream.generate(() -> {
            Vector start = around(random, leastStart, mostStart);
            return new Vector[] {start, around(random, 0, mostAside).minus(start)};
        });
    }

    /** From outside, through a point near the middle. */
    @ParameterizedTest
    @EnumSource
    void aRayThatHitsSquarely(Body body) {
        assertMadeOfDoubles(rays(31, 3, 9, 0.5), (p, d) -> body.firstCrossing(p, d) < 1);
    }

    @ParameterizedTest
    @EnumSource
    void aRayFromInside(Body body) {
        assertMadeOfDoubles(rays(32, 0.1, 0.6, 0.05), (p, d) -> body.firstCrossing(p, d) > 1);
    }

    @Test
    void aRayThatLeavesASphereBehind() {
        assertMadeOfDoubles(rays(33, 3, 9, 0.5).map(ray -> new Vector[] {ray[0], ray[1].negated()}),
            (p, d) -> Body.SPHERE.firstCrossing(p, d) == Surface.MISS);
    }

    /** At a right angle to the way from the middle, and at least 2 away from it. */
    private static Stream<Vector[]> passing(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        return Stream.generate(() -> {
            Vector beside = around(random, 2, 9);
            Vector along = beside.cross(SphereTest.randomVector(random, 1).unit());
            return new Vector[] {beside.minus(along), along.times(2)};
        });
    }

    @Test
    void aRayThatPassesASphere() {
        assertMadeOfDoubles(passing(34), (p, d) -> Body.SPHERE.firstCrossing(p, d) == Surface.MISS);
    }

    @ParameterizedTest
    @EnumSource
    void aLineThatPassesIsSeenAtOnceToDoSo(Body body) {
        assertMadeOfDoubles(passing(35), body::isPlainlyMissed);
    }

    private static Stream<Vector[]> lines(long seed, double leastStart, double mostStart, double leastEnd, double mostEnd) {
        SplittableRandom random = new SplittableRandom(seed);
        return Stream.generate(() -> {
            Vector start = around(random, leastStart, mostStart);
            Vector end = around(random, leastEnd, mostEnd);
            return new Vector[] {start, end};
        });
    }

    @ParameterizedTest
    @EnumSource
    void aLineFromOutsideToInside(Body body) {
        assertMadeOfDoubles(lines(36, 3, 9, 0.1, 0.6), (p, q) -> body.crossesBetween(p, q) == Answer.YES);
        assertMadeOfDoubles(lines(37, 0.1, 0.6, 3, 9), (p, q) -> body.crossesBetween(p, q) == Answer.YES);
    }

    @ParameterizedTest
    @EnumSource
    void aLineWithBothEndsInside(Body body) {
        assertMadeOfDoubles(lines(38, 0.1, 0.6, 0.1, 0.6), (p, q) -> body.crossesBetween(p, q) == Answer.NO);
    }

    @ParameterizedTest
    @EnumSource
    void aLineRightThrough(Body body) {
        SplittableRandom random = new SplittableRandom(39);
        assertMadeOfDoubles(rays(39, 3, 9, 0.3).map(ray -> new Vector[] {ray[0], ray[0].plus(random.nextDouble(2, 3), ray[1])}),
            (p, q) -> body.crossesBetween(p, q) == Answer.YES);
    }

    @Test
    void aLineThatEndsBeforeASphere() {
        assertMadeOfDoubles(rays(40, 5, 9, 0.3).map(ray -> new Vector[] {ray[0], ray[0].plus(0.5, ray[1])}),
            (p, q) -> Body.SPHERE.crossesBetween(p, q) == Answer.NO);
    }

    /** Well above or below the plane x + y + z = 0. */
    private static Vector besidePlane(SplittableRandom random, double sign) {
        return new Vector(random.nextDouble(1, 9), random.nextDouble(-0.5, 9), random.nextDouble(1, 9)).times(sign);
    }

    private static Stream<Vector[]> pairsBesidePlane(long seed, double endSign) {
        SplittableRandom random = new SplittableRandom(seed);
        return Stream.generate(() -> new Vector[] {besidePlane(random, 1), besidePlane(random, endSign)});
    }

    @Test
    void aRayToAPlaneAndOneAwayFromIt() {
        assertMadeOfDoubles(pairsBesidePlane(41, -1), (p, d) -> PlaneKernel.firstCrossing(p[0], p[1], p[2],
            d[0], d[1], d[2], ERROR, 1, 1, 1, 0) < Surface.MISS);
        assertMadeOfDoubles(pairsBesidePlane(42, 1), (p, d) -> PlaneKernel.firstCrossing(p[0], p[1], p[2],
            d[0], d[1], d[2], ERROR, 1, 1, 1, 0) == Surface.MISS);
    }

    @Test
    void aLineThroughAPlaneAndOneBesideIt() {
        assertMadeOfDoubles(pairsBesidePlane(43, -1), (p, q) -> PlaneKernel.crossesBetween(p[0], p[1], p[2], ERROR,
            q[0], q[1], q[2], ERROR, 1, 1, 1, 0) == Answer.YES);
        assertMadeOfDoubles(pairsBesidePlane(44, 1), (p, q) -> PlaneKernel.crossesBetween(p[0], p[1], p[2], ERROR,
            q[0], q[1], q[2], ERROR, 1, 1, 1, 0) == Answer.NO);
    }

    @ParameterizedTest
    @EnumSource
    void aPointOutsideAndOneInside(Body body) {
        assertMadeOfDoubles(lines(45, 2, 9, 0.1, 0.6), (p, q) -> body.isOutside(p) == Answer.YES && body.isOutside(q) == Answer.NO);
    }
}
