package raytracing.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
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
        Hit hit = new Hit(3, 0, 1, Vector.ZERO, 1e-9, UP, seenFrom);
        assertEquals(expected, hit.departureTowards(1, dy, 0));
    }

    @ParameterizedTest(name = "going {0} {1} {2}: {3}")
    @CsvSource({"3, -1, -1, OUTWARD", "1, -1, -1, INWARD", "-1, 3, -1, OUTWARD", "-1, 1, -1, INWARD",
        "-1, -1, 3, OUTWARD", "-1, -1, 1, INWARD"})
    void allThreePartsOfTheNormalDecide(double dx, double dy, double dz, Departure expected) {
        Hit hit = new Hit(3, 0, 1, Vector.ZERO, 1e-9, new Vector(1, 1, 1).unit(), Departure.OUTWARD);
        assertEquals(expected, hit.departureTowards(dx, dy, dz));
    }

    @ParameterizedTest
    @EnumSource(names = {"OUTWARD", "INWARD"})
    void aRayKnowsWhichSurfaceItLeavesAndToWhichSide(Departure side) {
        Ray mirrored = new Hit(3, 0, 1, Vector.ZERO, 1e-9, UP, side).leaving(UP);
        assertEquals(new Ray(Vector.ZERO, 1e-9, UP, 3, side), mirrored);
    }

    @Test
    void aRayFromAFreePointLeavesNoSurface() {
        assertEquals(new Ray(UP, 0x1p-51, UP, Ray.NO_SURFACE, Departure.ELSEWHERE), new Ray(UP, UP));
    }
}
