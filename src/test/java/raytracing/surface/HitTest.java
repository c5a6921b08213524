package raytracing.surface;

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
        HitRecord hit = new HitRecord(3, 0, Vector.ZERO, 1e-9, UP, seenFrom);
        assertEquals(expected, hit.departureTowards(1, dy, 0));
    }

    @ParameterizedTest(name = "going {0} {1} {2}: {3}")
    @CsvSource({"3, -1, -1, OUTWARD", "1, -1, -1, INWARD", "-1, 3, -1, OUTWARD", "-1, 1, -1, INWARD",
        "-1, -1, 3, OUTWARD", "-1, -1, 1, INWARD"})
    void allThreePartsOfTheNormalDecide(double dx, double dy, double dz, Departure expected) {
        HitRecord hit = new HitRecord(3, 0, Vector.ZERO, 1e-9, new Vector(1, 1, 1).unit(), Departure.OUTWARD);
        assertEquals(expected, hit.departureTowards(dx, dy, dz));
    }

    @ParameterizedTest
    @EnumSource(names = {"OUTWARD", "INWARD"})
    void aRayKnowsOnWhichSurfaceItStartsAndToWhichSideItLeaves(Departure side) {
        Ray mirrored = new Ray();
        mirrored.leave(new HitRecord(3, 0, Vector.ZERO, 1e-9, UP, side).toHit().origin(), 0, 1, 0);
        assertEquals(new RayRecord(Vector.ZERO, 1e-9, UP, 3, side), RayRecord.of(mirrored));
    }

    @Test
    void aRayFromANamedPointStartsOnNoSurface() {
        Ray ray = new Ray();
        ray.startAt(UP, 0, 1, 0);
        assertEquals(new RayRecord(UP, 0x1p-51, UP, RayOrigin.NO_SURFACE, Departure.ELSEWHERE), RayRecord.of(ray));
    }
}
