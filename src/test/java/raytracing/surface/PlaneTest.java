package raytracing.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.math.Vector;

class PlaneTest {
    /** y = 2, written with a normal three units long: offset counts in multiples of it. */
    private static final Plane LEVEL = new Plane(new Vector(0, 3, 0), 6, 0);

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "straight down on it,           5,  0, -1,  0,         3",
        "from below,                   -1,  0,  1,  0,         3",
        "slanted,                       5,  4, -1,  3,         3",
        "away from it,                  5,  0,  1,  0,  Infinity",
        "along it,                      5,  1,  0,  0,  Infinity",
        "inside it,                     2,  1,  0,  0,  Infinity",
        "inside it with a minus zero,   2,  1, -0.0, 1, Infinity",
        "starting on it,                2,  1, -1,  0,  Infinity",
    })
    void firstCrossingIsTheOneSolvedByHand(String why, double y, double dx, double dy, double dz, double expected) {
        assertEquals(expected,
            SurfaceQuestions.firstCrossing(LEVEL, new RayRecord(new Vector(7, y, 9), new Vector(dx, dy, dz)),
                Departure.ELSEWHERE), why);
    }

    @Test
    void aRayNeverMeetsThePlaneItLeaves() {
        Vector rounded = new Vector(0, Math.nextUp(2.0), 0);
        Vector down = new Vector(0, -1, 0);
        assertEquals(Surface.MISS, SurfaceQuestions.firstCrossing(LEVEL, new RayRecord(rounded, down), Departure.OUTWARD));
        assertEquals(Surface.MISS, SurfaceQuestions.firstCrossing(LEVEL, new RayRecord(rounded, down), Departure.INWARD));
    }

    @Test
    void theNormalIsUnitAndAsWritten() {
        assertEquals(new Vector(0, 1, 0), OutwardNormal.of(LEVEL, new RayRecord(new Vector(0, 0, 0), new Vector(0, 1, 0)), 2));
    }

    @Test
    void aHitBeyondAllDoublesIsTheOutermostPointThereIs() {
        HitRecord hit = HitRecord.at(LEVEL, new RayRecord(new Vector(1.7e308, 5, 0), new Vector(0.8, -0.6, 0)),
            Double.MAX_VALUE, 0);
        assertEquals(Double.MAX_VALUE, hit.point().x());
        assertEquals(new Vector(0, 1, 0), hit.normal());
        assertTrue(hit.pointError() < Double.POSITIVE_INFINITY);
    }

    @Test
    void bothSidesAreSeenWithTheNormalTowardsTheEye() {
        HitRecord fromAbove = HitRecord.at(LEVEL, new RayRecord(new Vector(0, 5, 0), new Vector(0, -1, 0)), 3, 0);
        HitRecord fromBelow = HitRecord.at(LEVEL, new RayRecord(new Vector(0, -1, 0), new Vector(0, 1, 0)), 3, 0);
        assertEquals(new Vector(0, 1, 0), fromAbove.normal());
        assertEquals(-1, fromBelow.normal().y());
        assertEquals(2, fromAbove.point().y());
    }
}
