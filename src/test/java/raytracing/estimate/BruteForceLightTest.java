package raytracing.estimate;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.SceneText;
import raytracing.math.Vector;
import raytracing.scene.Scene;
import raytracing.surface.RayRecord;

/** The truth itself, held to answers on paper. Six standard errors are allowed: by chance, one in 500 million. */
class BruteForceLightTest {
    private static final RayRecord ALONG_Z = new RayRecord(Vector.ZERO, new Vector(0, 0, 1));

    private static double seen(Scene scene, RayRecord ray, int bounces, int root) {
        return new BruteForceLight(scene, bounces, 1).ambientSeen(ray, root)[0];
    }

    /** Every ray of a furnace brings the same, so one bounce, or two, have no error but rounding. */
    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.5, 0.9})
    void theFirstBounceInAFurnaceIsItsReflectance(double a) {
        assertEquals(a * a, seen(AmbientScenes.furnace(a), ALONG_Z, 1, 3), 1e-12);
    }

    /** The number of bounces is geometric, its standard deviation sqrt(a) / (1 - a), each bringing a. */
    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.5, 0.9})
    void allBouncesInAFurnaceAddUpToTheGeometricSeries(double a) {
        int root = 200;
        double deviation = a * a * Math.sqrt(a) / (1 - a);
        assertEquals(a * a / (1 - a), seen(AmbientScenes.furnace(a), ALONG_Z, 1000, root), 6 * deviation / root);
    }

    /** See {@link AmbientScenes#lightUnderBlackBall}. */
    @ParameterizedTest
    @CsvSource({"2, 1, 0", "1, 1, 0", "5, 0.5, 0", "1, 1, 1", "1.5, 1, 3"})
    void aBallHidesItsShareOfTheSky(double height, double radius, double aside) {
        Scene scene = AmbientScenes.blackBallOverFloor(height, radius);
        RayRecord down = new RayRecord(new Vector(aside, 1e-9, 0), new Vector(0, -1, 0));
        double light = AmbientScenes.lightUnderBlackBall(height, radius, aside);
        int root = 100;
        assertEquals(light, seen(scene, down, 1, root), 6 * Math.sqrt(light * (1 - light)) / root + 1e-9);
    }

    /** Half of a wall's hemisphere is the floor, lit by nothing; the other half the sky. */
    @Test
    void aWallOnABlackFloorSeesHalfTheSky() {
        Scene scene = SceneText.scene("cam 0 0 0  0 0 1  0 1 0  1 2", "set 1 1 1  1 5", "mtl 0 0 0  0 0 0  0 0 0  1 0  1 1 1",
            "pln 0 0 1  3 1", "pln 0 1 0  -0.000001 1");
        assertEquals(0.5, seen(scene, ALONG_Z, 1, 100), 6 * 0.5 / 100);
    }

    /**
     * One half of a white ball's light comes through the glass, one half of another's is mirrored by it. The balls see
     * the sky through the glass as bright as without it, halved and mirrored alike, but for themselves in the mirror: (1
     * / 8)^2 of it.
     */
    @Test
    void ambientLightIsSeenThroughGlassAndInMirrors() {
        Scene scene = SceneText.scene("cam 0 0 0  0 0 1  0 1 0  1 2", "set 1 1 1  1 5",
            "mtl 0 0 0  0 0 0  0.5 0.5 0.5  1 0.5  0 0 0", "mtl 0 0 0  0 0 0  0 0 0  1 0  1 1 1",
            "pln 0 0 1  1 1", "sph 0 0 9 1 2", "sph 0 0 -9 1 2");
        assertEquals(1, seen(scene, ALONG_Z, 1, 60), 0.01);
    }
}
