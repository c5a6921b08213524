package raytracing.surface;

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
import raytracing.math.Vectors;

/**
 * Ordinary questions are answered in doubles. A kernel whose bounds leave too much to exact numbers is as right as before,
 * only slow. The bodies reach 1 from the middle along the axes.
 */
class QuickStepTest {
    private static final int CASES = 1_000;

    /** A single exact answer for each ten questions makes more objects. */
    private static final long MOST_BYTES = 10 * CASES;
    private static final double ERROR = 0x1p-49;

    private static final Ray RAY = new Ray();
    private static final Segment SEGMENT = new Segment();
    private static final RayOrigin START = new RayOrigin();
    private static final Plane PLANE = new Plane(new Vector(1, 1, 1), 0, 0);

    /** In that plane, so large that all lines through it near the middle meet it, and so small that none does. */
    private static final Triangle LARGE = triangle(40);
    private static final Triangle SMALL = triangle(0x1p-10);

    private static Triangle triangle(double size) {
        return Triangle.of(new Vector(2, -1, -1).times(size), new Vector(-1, 2, -1).times(size),
            new Vector(-1, -1, 2).times(size), 0);
    }

    private enum Shape {
        SPHERE(new Sphere(Vector.ZERO, 1, 0)),
        BOX(new Box(Vector.ZERO, 2, 0));

        private final Body surface;

        Shape(Body surface) {
            this.surface = surface;
        }

        double firstCrossing(double[] p, double[] d) {
            return QuickStepTest.firstCrossing(surface, p, d);
        }

        boolean isCrossed(double[] p, double[] q) {
            return QuickStepTest.isCrossed(surface, p, q);
        }

        boolean isOutside(double[] p) {
            SEGMENT.connect(START, p[0], p[1], p[2], ERROR);
            return surface.isLeft(SEGMENT);
        }
    }

    private static double firstCrossing(Surface surface, double[] p, double[] d) {
        START.set(p[0], p[1], p[2], ERROR, RayOrigin.NO_SURFACE, Departure.ELSEWHERE);
        RAY.leave(START, d[0], d[1], d[2]);
        return surface.firstCrossing(RAY, Surface.MISS);
    }

    private static boolean isCrossed(Surface surface, double[] p, double[] q) {
        START.set(p[0], p[1], p[2], ERROR, RayOrigin.NO_SURFACE, Departure.ELSEWHERE);
        SEGMENT.connect(START, q[0], q[1], q[2], ERROR);
        return surface.isCrossed(SEGMENT, 0);
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
    void aRayThatHitsSquarely(Shape body) {
        assertMadeOfDoubles(rays(31, 3, 9, 0.5), (p, d) -> body.firstCrossing(p, d) < 1);
    }

    @ParameterizedTest
    @EnumSource
    void aRayFromInside(Shape body) {
        assertMadeOfDoubles(rays(32, 0.1, 0.6, 0.05), (p, d) -> body.firstCrossing(p, d) > 1);
    }

    @Test
    void aRayThatLeavesASphereBehind() {
        assertMadeOfDoubles(rays(33, 3, 9, 0.5).map(ray -> new Vector[] {ray[0], Vectors.negated(ray[1])}),
            (p, d) -> Shape.SPHERE.firstCrossing(p, d) == Surface.MISS);
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
        assertMadeOfDoubles(passing(34), (p, d) -> Shape.SPHERE.firstCrossing(p, d) == Surface.MISS);
    }

    @ParameterizedTest
    @EnumSource
    void aLineThatPassesIsSeenAtOnceToDoSo(Shape body) {
        assertMadeOfDoubles(passing(35), (p, d) -> body.firstCrossing(p, d) == Surface.MISS);
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
    void aLineFromOutsideToInside(Shape body) {
        assertMadeOfDoubles(lines(36, 3, 9, 0.1, 0.6), (p, q) -> body.isCrossed(p, q));
        assertMadeOfDoubles(lines(37, 0.1, 0.6, 3, 9), (p, q) -> body.isCrossed(p, q));
    }

    @ParameterizedTest
    @EnumSource
    void aLineWithBothEndsInside(Shape body) {
        assertMadeOfDoubles(lines(38, 0.1, 0.6, 0.1, 0.6), (p, q) -> !body.isCrossed(p, q));
    }

    @ParameterizedTest
    @EnumSource
    void aLineRightThrough(Shape body) {
        SplittableRandom random = new SplittableRandom(39);
        assertMadeOfDoubles(rays(39, 3, 9,
            0.3).map(ray -> new Vector[] {ray[0], Vectors.plus(ray[0], random.nextDouble(2, 3), ray[1])}),
            (p, q) -> body.isCrossed(p, q));
    }

    @Test
    void aLineThatEndsBeforeASphere() {
        assertMadeOfDoubles(rays(40, 5, 9, 0.3).map(ray -> new Vector[] {ray[0], Vectors.plus(ray[0], 0.5, ray[1])}),
            (p, q) -> !Shape.SPHERE.isCrossed(p, q));
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
        assertMadeOfDoubles(pairsBesidePlane(41, -1), (p, d) -> firstCrossing(PLANE, p, d) < Surface.MISS);
        assertMadeOfDoubles(pairsBesidePlane(42, 1), (p, d) -> firstCrossing(PLANE, p, d) == Surface.MISS);
    }

    @Test
    void aLineThroughAPlaneAndOneBesideIt() {
        assertMadeOfDoubles(pairsBesidePlane(43, -1), (p, q) -> isCrossed(PLANE, p, q));
        assertMadeOfDoubles(pairsBesidePlane(44, 1), (p, q) -> !isCrossed(PLANE, p, q));
    }

    @ParameterizedTest
    @EnumSource
    void aPointOutsideAndOneInside(Shape body) {
        assertMadeOfDoubles(lines(45, 2, 9, 0.1, 0.6), (p, q) -> body.isOutside(p) && !body.isOutside(q));
    }

    private static Stream<Vector[]> raysBetween(Stream<Vector[]> pairs) {
        return pairs.map(pair -> new Vector[] {pair[0], pair[1].minus(pair[0])});
    }

    @Test
    void aRayToATriangleAndOneAwayFromIt() {
        assertMadeOfDoubles(raysBetween(pairsBesidePlane(46, -1)), (p, d) -> firstCrossing(LARGE, p, d) < 1);
        assertMadeOfDoubles(pairsBesidePlane(47, 1), (p, d) -> firstCrossing(LARGE, p, d) == Surface.MISS);
    }

    @Test
    void aLineThroughATriangleAndOneBesideIt() {
        assertMadeOfDoubles(pairsBesidePlane(48, -1), (p, q) -> isCrossed(LARGE, p, q));
        assertMadeOfDoubles(pairsBesidePlane(49, 1), (p, q) -> !isCrossed(LARGE, p, q));
    }

    @Test
    void aRayAndALineThatPassATriangle() {
        assertMadeOfDoubles(passing(50), (p, d) -> firstCrossing(SMALL, p, d) == Surface.MISS);
        assertMadeOfDoubles(passing(50), (p, d) -> !isCrossed(SMALL, p, d));
    }
}
