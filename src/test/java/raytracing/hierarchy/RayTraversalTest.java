package raytracing.hierarchy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.math.Vector;
import raytracing.surface.Departure;
import raytracing.surface.RayOrigin;
import raytracing.surface.RayRecord;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;

class RayTraversalTest {
    private static final double EVER = Double.POSITIVE_INFINITY;

    private final RayTraversal traversal = new RayTraversal();

    /** The bodies of all leaves that a ray, six numbers, comes to. */
    private BitSet visited(Boxes boxes, double[] ray, double originError, double latest) {
        BitSet bodies = new BitSet();
        traversal.startRay(boxes.hierarchy(), ray[0], ray[1], ray[2], originError, ray[3], ray[4], ray[5]);
        while (traversal.nextLeaf(latest)) {
            for (int i = traversal.from(); i < traversal.to(); i++) {
                bodies.set(boxes.hierarchy().order()[i]);
            }
        }
        return bodies;
    }

    /** When a ray comes into a box, by the textbook's slabs and without any slack; infinite if it does not. */
    private static double entry(Boxes boxes, int body, double[] ray) {
        double entry = 0;
        double exit = Double.MAX_VALUE;
        for (int axis = 0; axis < 3; axis++) {
            double low = boxes.low(body, axis) - ray[axis];
            double high = boxes.high(body, axis) - ray[axis];
            double d = ray[3 + axis];
            if (d != 0) {
                entry = Math.max(entry, Math.min(low / d, high / d));
                exit = Math.min(exit, Math.max(low / d, high / d));
            } else if (low > 0 || high < 0) {
                return EVER;
            }
        }
        return entry <= exit ? entry : EVER;
    }

    /** From somewhere around the cube from 0 to 1 or in it, towards a point in it. */
    private static double[] randomRay(SplittableRandom random) {
        double[] ray = new double[6];
        for (int axis = 0; axis < 3; axis++) {
            ray[axis] = random.nextDouble(-1, 2);
            ray[3 + axis] = random.nextDouble() - ray[axis];
        }
        return ray;
    }

    @ParameterizedTest(name = "{0} bodies of size {1}")
    @CsvSource({"1, 0.5", "2, 0.5", "7, 0.3", "9, 0.3", "300, 0.1", "3000, 0.03", "300, 0.7"})
    void aRayComesToAllThatItMeets(int n, double size) {
        Boxes boxes = Boxes.of(Boxes.scattered(n, size));
        SplittableRandom random = new SplittableRandom(n);
        int met = 0;
        for (int i = 0; i < 1_000; i++) {
            double[] ray = randomRay(random);
            BitSet visited = visited(boxes, ray, 0, EVER);
            for (int body = 0; body < n; body++) {
                boolean isMet = entry(boxes, body, ray) < EVER;
                assertTrue(!isMet || visited.get(body));
                met += isMet ? 1 : 0;
            }
        }
        assertTrue(met > 50, "too few meetings to mean anything");
    }

    /**
     * Rays from lattice points along lattice directions, through cubes that fill a lattice: they run in faces and along
     * edges, pass through corners, start on all of these. All times are multiples of a sixth, so counted in sixths they
     * are exact.
     */
    @Test
    void raysThroughFacesEdgesAndCornersComeToAllThatTheyTouch() {
        int n = 6;
        Boxes boxes = Boxes.of(Boxes.grid(n));
        SplittableRandom random = new SplittableRandom(3);
        double[] steps = {-3, -2, -1, -0.0, 0.0, 1, 2, 3};
        int touched = 0;
        for (int i = 0; i < 5_000; i++) {
            double[] ray = latticeRay(random, n, steps);
            BitSet visited = visited(boxes, ray, 0, EVER);
            for (int body = 0; body < boxes.size(); body++) {
                boolean isTouched = exactEntryInSixths(boxes, body, ray) < EVER;
                assertTrue(!isTouched || visited.get(body));
                touched += isTouched ? 1 : 0;
            }
        }
        assertTrue(touched > 20_000, "too few touches to mean anything");
    }

    private static double[] latticeRay(SplittableRandom random, int n, double[] steps) {
        double[] ray = new double[6];
        for (int axis = 0; axis < 3; axis++) {
            ray[axis] = random.nextInt(-2, n + 3);
            ray[3 + axis] = steps[random.nextInt(steps.length)];
        }
        if (ray[3] == 0 && ray[4] == 0 && ray[5] == 0) {
            ray[3] = 1;
        }
        return ray;
    }

    private static double exactEntryInSixths(Boxes boxes, int body, double[] ray) {
        double[] sixthOfSpeed = ray.clone();
        for (int axis = 3; axis < 6; axis++) {
            sixthOfSpeed[axis] = ray[axis] == 0 ? 0 : 6 / ray[axis];
        }
        double entry = 0;
        double exit = EVER;
        for (int axis = 0; axis < 3; axis++) {
            double low = boxes.low(body, axis) - ray[axis];
            double high = boxes.high(body, axis) - ray[axis];
            double per = sixthOfSpeed[3 + axis];
            if (per != 0) {
                entry = Math.max(entry, Math.min(low * per, high * per));
                exit = Math.min(exit, Math.max(low * per, high * per));
            } else if (low > 0 || high < 0) {
                return EVER;
            }
        }
        return entry <= exit ? entry : EVER;
    }

    /** What is met at the very moment of the nearest hit so far may win the tie. */
    @Test
    void aBodyMetAtTheLatestTimeIsNotTooLate() {
        Boxes boxes = Boxes.of(Boxes.scattered(300, 0.1));
        SplittableRandom random = new SplittableRandom(5);
        int ties = 0;
        for (int i = 0; i < 1_000; i++) {
            double[] ray = randomRay(random);
            for (int body = 0; body < boxes.size(); body++) {
                double entry = entry(boxes, body, ray);
                if (entry > 0 && entry < EVER) {
                    assertTrue(visited(boxes, ray, 0, entry * (1 - 0x1p-48)).get(body));
                    ties++;
                }
            }
        }
        assertTrue(ties > 1_000, "too few ties to mean anything");
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "met at once,            0, 0, 0.5,    0, 0, 1,  Infinity, true",
        "met just in time,       0, 0, -3,     0, 0, 1,  3,        true",
        "met too late,           0, 0, -3,     0, 0, 1,  2.9999,   false",
        "behind,                 0, 0, 1.001,  0, 0, 1,  Infinity, false",
        "left behind,            0, 0, 1,      0, 0, 1,  Infinity, true",
        "passed beside,          0, 1.001, -3, 0, 0, 1,  Infinity, false",
        "passed along a face,    0, 1, -3,     0, 0, 1,  Infinity, true",
        "passed along an edge,   1, 1, -3,     0, 0, 1,  Infinity, true",
        "touched at a corner,    2, 0, 0,     -1, 1, 1,  Infinity, true",
        "missed at a corner,     2.001, 0, 0, -1, 1, 1,  Infinity, false",
        "backwards,              0, 0, 3,      0, 0, -1, Infinity, true",
        "backwards from behind,  0, 0, -3,     0, 0, -1, Infinity, false",
        "with parts of -0,       0, 0, -3,  -0.0, -0.0, 1, Infinity, true",
        "beside with parts of -0, 0, 1.001, -3, -0.0, -0.0, 1, Infinity, false",
    })
    void aSingleBoxIsFoundWhenItIsMet(String why, double x, double y, double z, double dx, double dy, double dz,
                                      double latest, boolean isMet) {
        Boxes boxes = farFromAnother(-1, -1, 0, 1, 1, 1);
        assertEquals(isMet, !visited(boxes, new double[] {x, y, z, dx, dy, dz}, 0, latest).isEmpty(), why);
    }

    /** A box in a leaf of its own: the only leaf of a hierarchy is not tested. Four equal boxes fill a leaf. */
    private static Boxes farFromAnother(double... box) {
        double[] numbers = new double[8 * Bounds.STRIDE];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = box[i % Bounds.STRIDE] + (i < numbers.length / 2 ? 0 : 1e4);
        }
        return Boxes.of(numbers);
    }

    @Test
    void theOnlyLeafIsAlwaysFound() {
        assertFalse(visited(Boxes.of(-1, -1, -1, 1, 1, 1), new double[] {5, 5, 5, 1, 0, 0}, 0, EVER).isEmpty());
    }

    /** The origin may be meant to be one error away, and a body that it lies on may be four errors off: twice that. */
    @Test
    void boxesGrowByEightTimesTheErrorOfTheOrigin() {
        Boxes boxes = farFromAnother(-1, -1, -1, 1, 1, 1);
        double error = 0x1p-15;
        double[] close = {1 + 7.8 * error, 0, -3, 0, 0, 1};
        double[] far = {1 + 8.2 * error, 0, -3, 0, 0, 1};
        assertFalse(visited(boxes, close, error, EVER).isEmpty());
        assertTrue(visited(boxes, close, 0, EVER).isEmpty());
        assertTrue(visited(boxes, far, error, EVER).isEmpty());
        assertFalse(visited(boxes, new double[] {0, 0, 1 + 7.8 * error, 0, 0, 1}, error, EVER).isEmpty(), "ahead");
        assertTrue(visited(boxes, new double[] {0, 0, 1 + 8.2 * error, 0, 0, 1}, error, EVER).isEmpty(), "behind");
    }

    @Test
    void nearerBodiesComeFirst() {
        Boxes row = Boxes.of(row(200));
        for (double dx : new double[] {1, -1}) {
            traversal.startRay(row.hierarchy(), dx > 0 ? -5 : 405, 0.5, 0.5, 0, dx, 0, 0);
            double last = -1;
            while (traversal.nextLeaf(EVER)) {
                for (int i = traversal.from(); i < traversal.to(); i++) {
                    double low = row.low(row.hierarchy().order()[i], 0);
                    double distance = dx > 0 ? low : 400 - low;
                    assertTrue(distance > last - 2 * (traversal.to() - traversal.from()), "a leaf out of order");
                    last = Math.max(last, distance);
                }
            }
            assertTrue(last > 390, "the row has no end");
        }
    }

    /** Cubes with gaps along the x axis, the longer the farther, in no order. */
    private static double[] row(int n) {
        double[] numbers = new double[Bounds.STRIDE * n];
        for (int i = 0; i < n; i++) {
            double low = 2 * (i * 77 % n);
            System.arraycopy(new double[] {low, 0, 0, low + 1, 1, 1}, 0, numbers, Bounds.STRIDE * i, Bounds.STRIDE);
        }
        return numbers;
    }

    @Test
    void nothingBehindTheNearestHitIsLookedAt() {
        Boxes row = Boxes.of(row(200));
        traversal.startRay(row.hierarchy(), -5, 0.5, 0.5, 0, 1, 0, 0);
        assertTrue(traversal.nextLeaf(EVER));
        assertFalse(traversal.nextLeaf(5));
    }

    @Test
    void coincidentBodiesAreAllFound() {
        Boxes boxes = Boxes.of(new double[6 * 1_000]);
        assertEquals(1_000, visited(boxes, new double[] {-1, -1, -1, 1, 1, 1}, 0, EVER).cardinality());
    }

    /** Half edges run from 1/2 to 1: those of more than 0.75 are met, half of all. */
    @Test
    void ofConcentricBodiesTheLargeEnoughOnesAreFound() {
        Boxes boxes = Boxes.of(Boxes.concentric(100_000));
        double[] ray = {1.0 / 3 + 0.75, 0.7, -5, 0, 0, 1};
        BitSet visited = visited(boxes, ray, 0, EVER);
        for (int body = 0; body < boxes.size(); body++) {
            assertTrue(entry(boxes, body, ray) == EVER || visited.get(body));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0x1p-40, 0x1p40})
    void scaleMakesNoDifference(double factor) {
        double[] numbers = Boxes.scattered(1_000, 0.05);
        Boxes ordinary = Boxes.of(numbers);
        Boxes scaled = Boxes.of(Boxes.scaled(numbers, factor));
        SplittableRandom random = new SplittableRandom(6);
        for (int i = 0; i < 1_000; i++) {
            double[] ray = randomRay(random);
            assertEquals(leaves(ordinary, ray), leaves(scaled, Boxes.scaled(ray, factor)));
        }
    }

    private List<Integer> leaves(Boxes boxes, double[] ray) {
        List<Integer> leaves = new ArrayList<>();
        traversal.startRay(boxes.hierarchy(), ray[0], ray[1], ray[2], 0, ray[3], ray[4], ray[5]);
        while (traversal.nextLeaf(EVER)) {
            leaves.add(traversal.from());
        }
        return leaves;
    }

    /** At the ends of the range of floats and beyond, boxes may be infinite: too much may be visited, and nothing is lost. */
    @ParameterizedTest
    @ValueSource(ints = {-1000, -149, -140, -126, -100, 100, 120, 125, 126, 127, 128, 1000})
    void noScaleLosesAnything(int exponent) {
        double factor = Math.scalb(1.0, exponent);
        Boxes boxes = Boxes.of(Boxes.scaled(Boxes.scattered(300, 0.1), factor));
        SplittableRandom random = new SplittableRandom(exponent);
        for (int i = 0; i < 300; i++) {
            double[] ray = Boxes.scaled(randomRay(random), factor);
            for (int speed = 0; speed < 2; speed++) {
                BitSet visited = visited(boxes, ray, 0, EVER);
                for (int body = 0; body < boxes.size(); body++) {
                    assertTrue(entry(boxes, body, ray) == EVER || visited.get(body));
                }
                for (int axis = 3; axis < 6; axis++) {
                    ray[axis] /= factor;     // directions near 1
                }
            }
        }
    }

    /** Reciprocals may become infinite, and times may keep few bits: nothing that a ray touches is lost by that. */
    @ParameterizedTest
    @ValueSource(ints = {-1074, -1060, -1024, -1023, -1000, -300, 300, 1000, 1019, 1020, 1021})
    void theLengthOfTheDirectionLosesNothing(int exponent) {
        Boxes boxes = Boxes.of(Boxes.grid(4));
        Boxes tiny = Boxes.of(Boxes.scaled(Boxes.grid(4), 0x1p-54));
        SplittableRandom random = new SplittableRandom(10);
        double[] steps = {-6, -3, -2, -1, 0, 1, 2, 3, 6};
        for (int i = 0; i < 2_000; i++) {
            double[] ray = latticeRay(random, 4, steps);
            double[] scaled = Boxes.scaled(ray, 0x1p-54);
            for (int axis = 3; axis < 6; axis++) {
                scaled[axis] = Math.scalb(ray[axis], exponent);
            }
            BitSet visited = visited(tiny, scaled, 0, EVER);
            for (int body = 0; body < boxes.size(); body++) {
                assertTrue(exactEntryInSixths(boxes, body, ray) == EVER || visited.get(body));
            }
        }
    }

    /** A line of length 1 through 100,000 boxes with an edge of 1/90 on average meets about twenty of them. */
    @Test
    void fewLeavesAreVisitedOfManyBodies() {
        Boxes boxes = Boxes.of(Boxes.scattered(100_000, 0.01));
        SplittableRandom random = new SplittableRandom(7);
        int leaves = 0;
        for (int i = 0; i < 1_000; i++) {
            leaves += leaves(boxes, randomRay(random)).size();
        }
        assertTrue(leaves > 5_000 && leaves < 50_000, "leaves for 1000 rays: " + leaves);
    }

    /** Along a plane in which many boxes end, distance and reciprocal would be 0 and infinite at all of them. */
    @Test
    void aRayInAPlaneOfFacesVisitsOnlyWhatItTouches() {
        Boxes boxes = Boxes.of(Boxes.grid(20));
        int visited = visited(boxes, new double[] {-1, 10, 10, 1, 0, 0}, 0, EVER).cardinality();
        assertTrue(visited >= 80 && visited <= 400, () -> visited + " of 8000");
    }

    /** Spheres that touch and overlap, rays that leave them: what the traversal finds is what there is, bit for bit. */
    @Test
    void theNearestCrossingIsThatOfAllSpheres() {
        int n = 500;
        double[] spheres = new SplittableRandom(8).doubles(4 * n, 0.05, 1).toArray();
        Boxes boxes = Boxes.of(around(spheres));
        SplittableRandom random = new SplittableRandom(9);
        double[] ray = randomRay(random);
        int hits = 0;
        for (int i = 0; i < 5_000; i++) {
            double error = Math.max(Math.abs(ray[0]), Math.max(Math.abs(ray[1]), Math.abs(ray[2]))) * 0x1p-49;
            double expected = Surface.MISS;
            for (int body = 0; body < n; body++) {
                expected = Math.min(expected, crossing(spheres, body, ray, error));
            }
            double found = Surface.MISS;
            traversal.startRay(boxes.hierarchy(), ray[0], ray[1], ray[2], error, ray[3], ray[4], ray[5]);
            while (traversal.nextLeaf(found)) {
                for (int k = traversal.from(); k < traversal.to(); k++) {
                    found = Math.min(found, crossing(spheres, boxes.hierarchy().order()[k], ray, error));
                }
            }
            assertEquals(expected, found);
            hits += found < Surface.MISS ? 1 : 0;
            ray = found < Surface.MISS ? from(ray, found, random) : randomRay(random);
        }
        assertTrue(hits > 2_000, "too few hits to mean anything");
    }

    private static double[] around(double[] spheres) {
        double[] numbers = new double[spheres.length / 4 * Bounds.STRIDE];
        for (int i = 0; i < numbers.length; i++) {
            int body = i / Bounds.STRIDE;
            double radius = spheres[4 * body + 3] / 8;
            double centre = spheres[4 * body + i % 3];
            numbers[i] = i % 6 < 3 ? Math.nextDown(centre - radius) : Math.nextUp(centre + radius);
        }
        return numbers;
    }

    private static double crossing(double[] spheres, int body, double[] ray, double error) {
        Vector centre = new Vector(spheres[4 * body], spheres[4 * body + 1], spheres[4 * body + 2]);
        RayRecord record = new RayRecord(new Vector(ray[0], ray[1], ray[2]), error, new Vector(ray[3], ray[4], ray[5]),
            RayOrigin.NO_SURFACE, Departure.ELSEWHERE);
        return new Sphere(centre, spheres[4 * body + 3] / 8, 0).firstCrossing(record.toRay(), Surface.MISS);
    }

    private static double[] from(double[] ray, double distance, SplittableRandom random) {
        double[] next = new double[6];
        for (int axis = 0; axis < 3; axis++) {
            next[axis] = ray[axis] + distance * ray[3 + axis];
            next[3 + axis] = random.nextDouble(-1, 1);
        }
        return next;
    }
}
