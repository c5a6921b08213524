package raytracing.hierarchy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.BitSet;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.math.Vector;
import raytracing.math.Vectors;

class PyramidTraversalTest {
    /** From the apex at 0 to z = 10. */
    private static final Pyramid TEN_WIDE = new Pyramid(Vector.ZERO, new Vector(0, 0, 1), new Vector(1, 0, 0),
        new Vector(0, 1, 0), 10, 5);

    private final PyramidTraversal traversal = new PyramidTraversal();

    /** A pyramid as {@link PyramidTraversal#startPyramid} takes it. */
    private record Pyramid(Vector apex, Vector axis, Vector right, Vector up, double length, double halfWidth) {
        static Pyramid random(SplittableRandom random) {
            Vector axis = randomVector(random).unit();
            Vector right = axis.cross(randomVector(random)).unit();
            return new Pyramid(randomVector(random), axis, right, axis.cross(right), random.nextDouble(0.1, 2),
                random.nextDouble(0.01, 1));
        }

        /** A point somewhere inside. */
        Vector point(SplittableRandom random) {
            double height = random.nextDouble();
            return Vectors.plus(Vectors.plus(Vectors.plus(apex, height * length, axis),
                height * random.nextDouble(-halfWidth, halfWidth), right),
                    height * random.nextDouble(-halfWidth, halfWidth), up);
        }

        Pyramid scaled(double factor) {
            return new Pyramid(new Vector(factor * apex.x(), factor * apex.y(), factor * apex.z()), axis, right, up,
                factor * length, factor * halfWidth);
        }
    }

    private static Vector randomVector(SplittableRandom random) {
        return new Vector(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
    }

    private BitSet visited(Boxes boxes, Pyramid pyramid, double margin) {
        Vector p = pyramid.apex();
        Vector n = pyramid.axis();
        Vector u = pyramid.right();
        Vector v = pyramid.up();
        traversal.startPyramid(boxes.hierarchy(), p.x(), p.y(), p.z(), n.x(), n.y(), n.z(), u.x(), u.y(), u.z(),
            v.x(), v.y(), v.z(), pyramid.length(), pyramid.halfWidth(), margin);
        BitSet bodies = new BitSet();
        while (traversal.nextLeaf()) {
            for (int i = traversal.from(); i < traversal.to(); i++) {
                bodies.set(boxes.hierarchy().order()[i]);
            }
        }
        return bodies;
    }

    private static boolean contains(Boxes boxes, int body, Vector point) {
        return point.x() >= boxes.low(body, 0) && point.x() <= boxes.high(body, 0)
            && point.y() >= boxes.low(body, 1) && point.y() <= boxes.high(body, 1)
            && point.z() >= boxes.low(body, 2) && point.z() <= boxes.high(body, 2);
    }

    @ParameterizedTest(name = "{0} bodies of size {1}")
    @CsvSource({"1, 0.5", "8, 0.3", "9, 0.3", "300, 0.2", "1000, 0.02"})
    void allThatHoldAPointOfThePyramidAreFound(int n, double size) {
        Boxes boxes = Boxes.of(Boxes.scattered(n, size));
        SplittableRandom random = new SplittableRandom(n);
        int held = 0;
        for (int i = 0; i < 300; i++) {
            Pyramid pyramid = Pyramid.random(random);
            BitSet visited = visited(boxes, pyramid, 0);
            for (int k = 0; k < 100; k++) {
                Vector point = pyramid.point(random);
                for (int body = 0; body < n; body++) {
                    boolean isHeld = contains(boxes, body, point);
                    assertTrue(!isHeld || visited.get(body));
                    held += isHeld ? 1 : 0;
                }
            }
        }
        assertTrue(held > 20, "too few points to mean anything");
    }

    /** Cubes of edge 2 about the pyramid over a square of edge 10. */
    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "in the middle,          0, 0, 5,       true",
        "around the apex,        0, 0, 0,       true",
        "just before the base,   0, 0, 10.999,  true",
        "just behind the base,   0, 0, 11.001,  false",
        "just before the apex,   0, 0, -1.001,  false",
        "reaching into a side,   3.999, 0, 5,   true",
        "beside a side,          4.001, 0, 5,   false",
        "reaching into another, -3.999, 0, 5,   true",
        "beside another,        -4.001, 0, 5,   false",
        "reaching into a third,  0, 3.999, 5,   true",
        "beside a third,         0, 4.001, 5,   false",
        "reaching into a fourth, 0, -3.999, 5,  true",
        "beside a fourth,        0, -4.001, 5,  false",
    })
    void aSingleBoxIsFoundWhenItReachesInside(String where, double x, double y, double z, boolean isInside) {
        Boxes boxes = Boxes.of(x - 1, y - 1, z - 1, x + 1, y + 1, z + 1);
        assertEquals(isInside, !visited(boxes, TEN_WIDE, 0).isEmpty(), where);
    }

    @Test
    void boxesGrowByTheMargin() {
        Boxes boxes = Boxes.of(-1, -1, 11.5, 1, 1, 13.5);
        assertTrue(visited(boxes, TEN_WIDE, 1.4).isEmpty());
        assertFalse(visited(boxes, TEN_WIDE, 1.6).isEmpty());
    }

    /** Of a body that only touches, rounding must not decide that it does not. */
    @Test
    void aPointOnASideIsFound() {
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < 10_000; i++) {
            Pyramid pyramid = Pyramid.random(random);
            double height = random.nextDouble();
            Vector point = Vectors.plus(Vectors.plus(pyramid.apex(), height * pyramid.length(), pyramid.axis()),
                height * pyramid.halfWidth(), pyramid.right());
            Boxes speck = Boxes.of(point.x(), point.y(), point.z(), point.x(), point.y(), point.z());
            double margin = 0x1p-51 * (pyramid.apex().largestPart() + point.largestPart());
            assertFalse(visited(speck, pyramid, margin).isEmpty());
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0x1p-40, 0x1p40})
    void scaleMakesNoDifference(double factor) {
        double[] numbers = Boxes.scattered(1_000, 0.05);
        Boxes ordinary = Boxes.of(numbers);
        Boxes scaled = Boxes.of(Boxes.scaled(numbers, factor));
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 300; i++) {
            Pyramid pyramid = Pyramid.random(random);
            assertEquals(visited(ordinary, pyramid, 0), visited(scaled, pyramid.scaled(factor), 0));
        }
    }

    @Test
    void aLightAtThePointItselfLosesNothing() {
        Boxes boxes = Boxes.of(-1, -1, -1, 1, 1, 1);
        Pyramid flat = new Pyramid(Vector.ZERO, new Vector(0, 0, 1), new Vector(1, 0, 0), new Vector(0, 1, 0),
            0, 0.5);
        assertFalse(visited(boxes, flat, 0).isEmpty());
    }

    /** A pyramid of 1 in length and 1/50 in width holds one body in 7500 of those all around. */
    @Test
    void fewBodiesAreVisitedInANarrowPyramid() {
        Boxes boxes = Boxes.of(Boxes.scattered(100_000, 0.002));
        Pyramid pyramid = new Pyramid(new Vector(0.5, 0.5, 0), new Vector(0, 0, 1), new Vector(1, 0, 0),
            new Vector(0, 1, 0), 1, 0.01);
        int visited = visited(boxes, pyramid, 0).cardinality();
        assertTrue(visited > 13 && visited < 400, () -> visited + " of 100000");
    }
}
