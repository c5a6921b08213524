package raytracing.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/** What lies in the way between two points, seen from either of them. */
class SegmentTest {
    private static final double THIRD = 1 / 3.0;

    static List<Surface> surfaces() {
        return List.of(new Sphere(new Vector(0.1, -0.2, 0.3), 0.7, 0), new Sphere(new Vector(1e6, 0, 0), 1e6, 0),
            new Box(new Vector(0.1, -0.2, 0.3), 1.4, 0), new Box(new Vector(0, -1e6, 0), 2e6, 0),
            new Plane(new Vector(1, 2, 3), 0.3, 0), new Plane(new Vector(0, -0.1, 0), 0.07, 0),
            Triangle.of(new Vector(-1, -1, 0.3), new Vector(1.5, -0.7, -0.2), new Vector(0, 1.5, 0.5), 0),
            Triangle.of(new Vector(-1e6, 0.1, -1e6), new Vector(1e6, 0.2, -1e6), new Vector(0.3, -0.3, 1e6), 0));
    }

    private static boolean crosses(Surface surface, Vector p, double pError, Vector q, double qError) {
        return SurfaceQuestions.crosses(surface, new SegmentRecord(p, pError, q, qError), Departure.ELSEWHERE);
    }

    /** Somewhere around a surface, or by rounding on, before or behind it: the hit point of a random ray. */
    private static Vector point(Surface surface, SplittableRandom random) {
        Vector origin = SphereTest.randomVector(random, 2);
        RayRecord ray = new RayRecord(origin, SphereTest.randomVector(random, 2).minus(origin));
        double t = SurfaceQuestions.firstCrossing(surface, ray, Departure.ELSEWHERE);
        return random.nextInt(3) == 0 || t == Surface.MISS ? origin : HitRecord.at(surface, ray, t, 0).point();
    }

    @ParameterizedTest
    @MethodSource("surfaces")
    void theAnswerIsTheSameFromEitherEnd(Surface surface) {
        SplittableRandom random = new SplittableRandom(14);
        int crossed = 0;
        for (int i = 0; i < 100_000; i++) {
            Vector p = point(surface, random);
            Vector q = point(surface, random);
            double error = random.nextInt(2) * 1e-16;
            boolean crosses = crosses(surface, p, error, q, 3 * error);
            assertEquals(crosses, crosses(surface, q, 3 * error, p, error), () -> p + " to " + q);
            crossed += crosses ? 1 : 0;
        }
        assertTrue(crossed > 5_000 && crossed < 95_000, crossed + " crossed");
    }

    /** Both ends well off the surface, the line to the end is a ray that meets it before t = 1, or is not. */
    @ParameterizedTest
    @MethodSource("surfaces")
    void awayFromTheEndsTheAnswerIsThatOfARay(Surface surface) {
        SplittableRandom random = new SplittableRandom(15);
        int crossed = 0;
        for (int i = 0; i < 50_000; i++) {
            Vector p = SphereTest.randomVector(random, 2);
            Vector q = SphereTest.randomVector(random, 2);
            double t = SurfaceQuestions.firstCrossing(surface, new RayRecord(p, q.minus(p)), Departure.ELSEWHERE);
            if (Math.abs(t - 1) > 1e-9) {
                assertEquals(t < 1, crosses(surface, p, 0, q, 0), () -> p + " to " + q);
                crossed += t < 1 ? 1 : 0;
            }
        }
        assertTrue(crossed > 1_000, crossed + " crossed");
    }

    /** A surface that contains a point to within its error does not come between it and what is on either side. */
    @ParameterizedTest
    @MethodSource("surfaces")
    void aLineThatOnlyEndsOnASurfaceDoesNotCrossIt(Surface surface) {
        SplittableRandom random = new SplittableRandom(16);
        for (int i = 0; i < 20_000; i++) {
            Vector origin = SphereTest.randomVector(random, 2);
            RayRecord ray = new RayRecord(origin, SphereTest.randomVector(random, 2).minus(origin));
            double t = SurfaceQuestions.firstCrossing(surface, ray, Departure.ELSEWHERE);
            if (t < Surface.MISS) {
                HitRecord hit = HitRecord.at(surface, ray, t, 0);
                assertFalse(crosses(surface, origin, 0, hit.point(), hit.pointError()), () -> "to " + hit);
                assertFalse(crosses(surface, hit.point(), hit.pointError(), origin, 0), () -> "from " + hit);
            }
        }
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        // from x, y  to x, y, crossed: a disc of radius 1, and a square from -1 to 1, around the middle
        "through both walls,        -2,   0,    2,   0, true",
        "in by one wall,            -2,   0,    0, 0.1, true",
        "stays inside,            -0.5,   0,  0.5,   0, false",
        "stays outside,             -2,   0, -1.5,   0, false",
        "passes by,                 -2, 1.5,    2, 1.5, false",
        "ends on the near wall,     -2,   0,   -1,   0, false",
        "ends on the far wall,      -2,   0,    1,   0, true",
        "from wall to wall,         -1,   0,    1,   0, false",
        "from the wall outwards,     1,   0,    2,   0, false",
        "from the wall through,     -1,   0,    2,   0, true",
        "from the wall inwards,     -1,   0,    0,   0, false",
        "touches,                   -2,   1,    2,   1, true",
        "ends where it would touch, -2,   1,    0,   1, false",
    })
    void bodiesAreCrossedBetweenTheEndsOnly(String why, double px, double py, double qx, double qy, boolean expected) {
        Vector p = new Vector(px, py, 0);
        Vector q = new Vector(qx, qy, 0);
        assertEquals(expected, crosses(new Sphere(Vector.ZERO, 1, 0), p, 0, q, 0), why);
        if (!why.startsWith("ends where")) {         // on a square's side the line is already in its boundary
            assertEquals(expected, crosses(new Box(Vector.ZERO, 2, 0), p, 0, q, 0), why);
        }
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "from side to side,  1, -1, true",
        "on one side,        1,  2, false",
        "down onto it,       1,  0, false",
        "along in it,        0,  0, false",
    })
    void aPlaneIsCrossedFromSideToSide(String why, double fromHeight, double toHeight, boolean expected) {
        Plane plane = new Plane(new Vector(0, 3, 0), 1, 0);
        Vector p = new Vector(-1, THIRD + fromHeight, 0);
        Vector q = new Vector(1, THIRD + toHeight, 0);
        assertEquals(expected, crosses(plane, p, 1e-16, q, 1e-16), why);
    }

    /** With the body between, or the far wall: what is known of the start decides, not its coordinates. */
    @Test
    void fromItsOwnWallABodyIsCrossedOnlyByALineThatComesOutAgain() {
        Vector top = new Vector(0, 1, 0);
        for (Surface body : List.of(new Sphere(Vector.ZERO, 1, 0), new Box(Vector.ZERO, 2, 0))) {
            SegmentRecord through = new SegmentRecord(top, 0, new Vector(0.1, -2, 0), 0);
            SegmentRecord into = new SegmentRecord(top, 0, new Vector(0.1, -0.5, 0), 0);
            SegmentRecord toTheFarWall = new SegmentRecord(top, 0, new Vector(0, Math.nextDown(-1.0), 0), 1e-15);
            assertTrue(SurfaceQuestions.crosses(body, through, Departure.INWARD));
            assertFalse(SurfaceQuestions.crosses(body, into, Departure.INWARD));
            assertFalse(SurfaceQuestions.crosses(body, toTheFarWall, Departure.INWARD));
            assertFalse(SurfaceQuestions.crosses(body, through, Departure.OUTWARD));
        }
    }

    /** Doubles may never lose a crossing: wherever they say "missed", exact numbers agree. */
    @Test
    void whatIsPlainlyMissedIsMissed() {
        SplittableRandom random = new SplittableRandom(17);
        int missed = 0;
        for (int i = 0; i < 300_000; i++) {
            double size = Math.scalb(1.0, random.nextInt(-30, 30));
            Vector c = SphereTest.randomVector(random, 1);
            Vector rim = Vectors.plus(c, size * (1 + random.nextInt(-2, 3) * 0x1p-51),
                SphereTest.randomVector(random, 1).unit());
            Vector o = random.nextBoolean() ? rim : SphereTest.randomVector(random, 2);
            Vector d = Vectors.plus((random.nextBoolean() ? rim : SphereTest.randomVector(random, 2)).minus(o), 0x1p-50,
                SphereTest.randomVector(random, 1));
            Ray ray = new RayRecord(o, 0, d, RayOrigin.NO_SURFACE, Departure.ELSEWHERE).toRay();
            Sphere sphere = new Sphere(c, size, 0);
            if (sphere.firstCrossing(ray, Surface.MISS) == Surface.MISS) {
                assertTrue(sphere.exactCrossing(ray, 0).isEmpty());
                missed++;
            }
            Box box = new Box(c, 2 * size, 0);
            double first = Surface.distance(box.exactCrossing(ray, 0));
            double latest = random.nextBoolean() ? 1 : Double.POSITIVE_INFINITY;
            if (box.firstCrossing(ray, latest) == Surface.MISS) {
                assertTrue(first > latest || first == Surface.MISS, () -> o + " " + d + " " + c + " " + size);
                missed++;
            }
        }
        assertTrue(missed > 50_000, missed + " missed");
    }
}
