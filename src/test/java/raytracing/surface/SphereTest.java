package raytracing.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.math.ExactVector;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/** Rays of the tables run along +z from (0, y, z). */
class SphereTest {
    private static final Sphere UNIT = new Sphere(Vector.ZERO, 1, 0);

    /** The way from the centre, (4e307, -2.3e308), is no double in length: it points along (4, -23). */
    @Test
    void aHitHasItsNormalAlsoWhereSumsAreBeyondAllDoubles() {
        Sphere sphere = new Sphere(new Vector(0, 1e267, 0), 1, 0);
        RayRecord ray = new RayRecord(new Vector(1.2e308, -1.7e308, 0), new Vector(-0.8, -0.6, 0));
        HitRecord hit = HitRecord.at(sphere, ray, 1e308, 0);
        assertEquals(-4 / Math.sqrt(4 * 4 + 23 * 23), hit.normal().x(), 1e-15);
        assertEquals(23 / Math.sqrt(4 * 4 + 23 * 23), hit.normal().y(), 1e-15);
        assertEquals(1e267, hit.point().y());
        assertTrue(hit.pointError() < Double.POSITIVE_INFINITY);
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "through the middle,                  0,   -5,         4",
        "touching,                            1,   -5,         5",
        "an ulp outside of touching, 1.0000000000000002, -5, Infinity",
        "3-4-5 chord,                       0.6,   -5,       4.2",
        "past it,                             2,   -5,  Infinity",
        "from the middle,                     0,    0,         1",
        "from inside,                       0.6,  0.5,       0.3",
        "from inside close to the wall,       0, -0.75,     1.75",
        "from behind,                         0,    5,  Infinity",
        "from the wall inwards,               0,   -1,         2",
        "from the wall outwards,              0,    1,  Infinity",
    })
    void firstCrossingIsTheOneSolvedByHand(String why, double y, double z, double expected) {
        double found = SurfaceQuestions.firstCrossing(UNIT, new RayRecord(new Vector(0, y, z), new Vector(0, 0, 1)),
            Departure.ELSEWHERE);
        assertEquals(expected, found, 4e-16 * 5, why);
    }

    @Test
    void distancesCountInMultiplesOfTheDirection() {
        Vector origin = new Vector(0, 0, -5);
        assertEquals(2, SurfaceQuestions.firstCrossing(UNIT, new RayRecord(origin, new Vector(0, 0, 2)), Departure.ELSEWHERE));
        assertEquals(0x1p102, SurfaceQuestions.firstCrossing(UNIT, new RayRecord(origin, new Vector(0, 0, 0x1p-100)),
            Departure.ELSEWHERE));
    }

    @Test
    void randomRaysAgreeWithExactArithmetic() {
        SplittableRandom random = new SplittableRandom(4);
        int hits = 0;
        for (int i = 0; i < 3_000; i++) {
            Sphere sphere = new Sphere(randomVector(random, 3), random.nextDouble(0.1, 2), 0);
            Vector origin = randomVector(random, 5);
            Vector direction = Vectors.plus(sphere.centre(), randomVector(random, 2)).minus(origin);
            double exact = exactFirstCrossing(sphere, origin, direction);
            double found = SurfaceQuestions.firstCrossing(sphere, new RayRecord(origin, direction), Departure.ELSEWHERE);
            if (exact == Surface.MISS) {
                assertEquals(exact, found);
            } else {
                // Rays this ordinary lose a few digits where they graze: at least 11 of 16 stay.
                assertEquals(exact, found, 1e-11 * exact);
                hits++;
            }
        }
        assertTrue(hits > 500, "too few hits to mean anything");
    }

    private static double exactFirstCrossing(Sphere sphere, Vector origin, Vector direction) {
        ExactVector o = ExactVector.of(origin).minus(ExactVector.of(sphere.centre()));
        ExactVector d = ExactVector.of(direction);
        BigDecimal a = d.dot(d);
        BigDecimal b = o.dot(d).negate();
        BigDecimal c = o.dot(o).subtract(new BigDecimal(sphere.radius()).pow(2));
        BigDecimal discriminant = b.multiply(b).subtract(a.multiply(c));
        if (discriminant.signum() < 0) {
            return Surface.MISS;
        }
        BigDecimal root = discriminant.sqrt(ExactVector.DIGITS);
        BigDecimal near = b.subtract(root).divide(a, ExactVector.DIGITS);
        BigDecimal far = b.add(root).divide(a, ExactVector.DIGITS);
        BigDecimal first = near.signum() > 0 ? near : far;
        return first.signum() > 0 ? first.doubleValue() : Surface.MISS;
    }

    static Vector randomVector(SplittableRandom random, double size) {
        return new Vector(random.nextDouble(-size, size), random.nextDouble(-size, size),
            random.nextDouble(-size, size));
    }

    @Test
    void normalsPointOutOfTheBody() {
        Sphere sphere = new Sphere(new Vector(10, 20, 30), 2, 0);
        assertEquals(new Vector(0, 0, -1),
            OutwardNormal.of(sphere, new RayRecord(new Vector(10, 20, 25), new Vector(0, 0, 1)), 3));
    }

    /** The hit is met, but its distance rounds to that of the centre: no direction is left between the two. */
    @Test
    void aBallSmallerThanRoundingAtItsDistanceFacesTheRay() {
        Sphere speck = new Sphere(Vector.ZERO, 1e-12, 0);
        Vector origin = new Vector(0, 0, -1e9);
        Vector direction = new Vector(0, 0, 1);
        double distance = SurfaceQuestions.firstCrossing(speck, new RayRecord(origin, direction), Departure.ELSEWHERE);
        assertEquals(1e9, distance);
        assertEquals(-1, OutwardNormal.of(speck, new RayRecord(origin, direction), distance).z());
    }

    /** A law: what leaves a convex body outwards never meets it, what leaves inwards meets the far wall. */
    @Test
    void aRayNeverMeetsTheWallItLeaves() {
        SplittableRandom random = new SplittableRandom(5);
        Sphere sphere = new Sphere(new Vector(1, 2, 3), 0.7, 0);
        for (int i = 0; i < 10_000; i++) {
            Vector normal = randomVector(random, 1).unit();
            Vector point = Vectors.plus(sphere.centre(), sphere.radius(), normal);
            Vector direction = randomVector(random, 1).unit();
            double inwards = -normal.dot(direction);
            if (inwards > 1e-3) {
                double across = SurfaceQuestions.firstCrossing(sphere, new RayRecord(point, direction), Departure.INWARD);
                assertEquals(2 * sphere.radius() * inwards, across, 1e-14);
            }
            assertEquals(Surface.MISS, SurfaceQuestions.firstCrossing(sphere, new RayRecord(point, direction),
                Departure.OUTWARD));
        }
    }
}
