package raytracing.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.math.Vector;

class HitTest {
    private static final Vector UP = new Vector(0, 1, 0);

    @ParameterizedTest(name = "seen from {0}, going {1}: {2}")
    @CsvSource({
        "OUTWARD,  1, OUTWARD",
        "OUTWARD,  0, OUTWARD",
        "OUTWARD, -1, INWARD",
        "INWARD,   1, INWARD",
        "INWARD,   0, INWARD",
        "INWARD,  -1, OUTWARD",
    })
    void aLineLeavesToTheSideItsDirectionPointsTo(Departure seenFrom, double dy, Departure expected) {
        Hit hit = new Hit(3, 0, 1, Vector.ZERO, UP, seenFrom);
        assertEquals(expected, hit.departureTowards(1, dy, 0));
    }

    @ParameterizedTest
    @CsvSource({"3, OUTWARD", "2, ELSEWHERE"})
    void aRayKnowsOnlyTheSurfaceItLeaves(int surface, Departure expected) {
        Ray mirrored = new Hit(3, 0, 1, Vector.ZERO, UP, Departure.OUTWARD).leaving(UP);
        assertEquals(expected, mirrored.departureFrom(surface));
    }
}
