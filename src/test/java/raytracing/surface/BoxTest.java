package raytracing.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.math.ExactVector;
import raytracing.math.Vector;
import raytracing.math.Vectors;

class BoxTest {
    /** From -1 to 1 on every axis. */
    private static final Box CUBE = new Box(Vector.ZERO, 2, 0);

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "head-on,                    0,   0,  -5,    0, 0, 1,         4",
        "head-on with minus zeros,   0,   0,  -5, -0.0, -0.0, 1,      4",
        "slanted,                   -3,   0,  -3,    1, 0.25, 1,      2",
        "past it,                    2,   0,  -5,    0, 0, 1,  Infinity",
        "slanted past an edge,      -3,   0,  -6,    1, 0, 1,  Infinity",
        "slanted and touching it,   -3,   0,  -5,    1, 0, 1,         4",
        "from the middle,            0,   0,   0,    0, 1, 0,         1",
        "from inside,              0.5, 0.5, 0.5,    1, 2, 4,     0.125",
        "from behind,                0,   0,   5,    0, 0, 1,  Infinity",
        "in the plane of a face,     1,   0,  -5,    0, 0, 1,         4",
        "through an edge,           -3,   0,  -1,    1, 0, 0,         2",
        "through a corner,          -3,  -3,  -3,    1, 1, 1,         2",
        "far axes decide last,      -4,  -2,  -3,    3, 1, 2,         1",
    })
    void firstCrossingIsTheOneSolvedByHand(String why, double x, double y, double z,
                                           double dx, double dy, double dz, double expected) {
        assertEquals(expected,
            SurfaceQuestions.firstCrossing(CUBE, new RayRecord(new Vector(x, y, z), new Vector(dx, dy, dz)),
                Departure.ELSEWHERE), why);
    }

    @Test
    void randomRaysAgreeWithExactArithmetic() {
        SplittableRandom random = new SplittableRandom(6);
        int hits = 0;
        for (int i = 0; i < 3_000; i++) {
            Box box = new Box(SphereTest.randomVector(random, 3), random.nextDouble(0.1, 3), 0);
            Vector origin = SphereTest.randomVector(random, 5);
            Vector direction = Vectors.plus(box.centre(), SphereTest.randomVector(random, 2)).minus(origin);
            double exact = exactFirstCrossing(box, origin, direction);
            double found = SurfaceQuestions.firstCrossing(box, new RayRecord(origin, direction), Departure.ELSEWHERE);
            if (exact == Surface.MISS) {
                assertEquals(exact, found);
            } else {
                assertEquals(exact, found, 1e-12 * exact);   // a face less than a thousandth of a unit ahead costs digits
                hits++;
            }
        }
        assertTrue(hits > 500, "too few hits to mean anything");
    }

    private static double exactFirstCrossing(Box box, Vector origin, Vector direction) {
        ExactVector o = ExactVector.of(origin).minus(ExactVector.of(box.centre()));
        ExactVector d = ExactVector.of(direction);
        BigDecimal half = new BigDecimal(box.edge()).divide(BigDecimal.valueOf(2));
        BigDecimal enter = BigDecimal.valueOf(Double.MAX_VALUE).negate();
        BigDecimal exit = BigDecimal.valueOf(Double.MAX_VALUE);
        for (List<BigDecimal> axis : List.of(List.of(o.x(), d.x()), List.of(o.y(), d.y()), List.of(o.z(), d.z()))) {
            BigDecimal low = half.negate().subtract(axis.get(0)).divide(axis.get(1), ExactVector.DIGITS);
            BigDecimal high = half.subtract(axis.get(0)).divide(axis.get(1), ExactVector.DIGITS);
            enter = enter.max(low.min(high));
            exit = exit.min(low.max(high));
        }
        if (enter.compareTo(exit) > 0 || exit.signum() <= 0) {
            return Surface.MISS;
        }
        return (enter.signum() > 0 ? enter : exit).doubleValue();
    }

    @ParameterizedTest
    @CsvSource({"1, 0, 0", "-1, 0, 0", "0, 1, 0", "0, -1, 0", "0, 0, 1", "0, 0, -1"})
    void everyFaceHasItsOwnAxisAsNormal(double x, double y, double z) {
        Vector outward = new Vector(x, y, z);
        RayRecord fromOutside = new RayRecord(Vectors.plus(outward.times(5), new Vector(0.1, 0.2, 0.3)),
            Vectors.negated(outward));
        RayRecord fromInside = new RayRecord(new Vector(0.1, 0.2, 0.3), outward);
        HitRecord outer = hit(fromOutside);
        HitRecord inner = hit(fromInside);
        assertEquals(outward, Vectors.plus(outer.normal(), Vector.ZERO));
        assertEquals(Departure.OUTWARD, outer.side());
        assertEquals(Vectors.plus(Vectors.negated(outward), Vector.ZERO), Vectors.plus(inner.normal(), Vector.ZERO));
        assertEquals(Departure.INWARD, inner.side());
    }

    /** A slanted ray through each face of a cube far from the world's origin: only one face can be right. */
    @ParameterizedTest
    @CsvSource({"1, 0, 0", "-1, 0, 0", "0, 1, 0", "0, -1, 0", "0, 0, 1", "0, 0, -1"})
    void theFaceIsFoundWhereverTheCubeStands(double x, double y, double z) {
        Vector outward = new Vector(x, y, z);
        Vector centre = new Vector(100, -70, 30);
        Box cube = new Box(centre, 2, 0);
        Vector origin = Vectors.plus(Vectors.plus(centre, 4, outward), new Vector(0.25, 0.5, -0.25));
        Vector direction = Vectors.plus(outward.times(-3), new Vector(0.1, -0.2, 0.3));
        double distance = SurfaceQuestions.firstCrossing(cube, new RayRecord(origin, direction), Departure.ELSEWHERE);
        assertEquals(outward, OutwardNormal.of(cube, new RayRecord(origin, direction), distance));
    }

    private static HitRecord hit(RayRecord ray) {
        return HitRecord.at(CUBE, ray, SurfaceQuestions.firstCrossing(CUBE, ray, Departure.ELSEWHERE), 0);
    }

    @Test
    void aRayThatLeavesInwardsMeetsTheFarWallEvenFromARoundedOrigin() {
        Vector justOutside = new Vector(0, 0, Math.nextDown(-1.0));
        Vector justInside = new Vector(0, 0, Math.nextUp(-1.0));
        Vector inwards = new Vector(0, 0, 1);
        assertEquals(2, SurfaceQuestions.firstCrossing(CUBE, new RayRecord(justOutside, inwards), Departure.INWARD), 1e-15);
        assertEquals(2, SurfaceQuestions.firstCrossing(CUBE, new RayRecord(justInside, inwards), Departure.INWARD), 1e-15);
        assertEquals(Surface.MISS, SurfaceQuestions.firstCrossing(CUBE, new RayRecord(justOutside, inwards),
            Departure.OUTWARD));
    }

    /** Two boxes share the face x = 1; a ray that runs exactly in it must not slip between them. */
    @Test
    void aRayBetweenTouchingBoxesMeetsOneOfThem() {
        Box neighbour = new Box(new Vector(2, 0, 0), 2, 0);
        Vector origin = new Vector(1, 0.3, -5);
        Vector direction = new Vector(0, 0.01, 1);
        double first = Math.min(SurfaceQuestions.firstCrossing(CUBE, new RayRecord(origin, direction), Departure.ELSEWHERE),
            SurfaceQuestions.firstCrossing(neighbour, new RayRecord(origin, direction), Departure.ELSEWHERE));
        assertEquals(4, first);
    }
}
