package raytracing.shadow;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.SceneText;
import raytracing.math.CounterRandom;
import raytracing.math.Vector;
import raytracing.scene.Scene;
import raytracing.surface.Departure;
import raytracing.surface.Hit;
import raytracing.surface.HitRecord;
import raytracing.trace.PreparedScene;
import raytracing.trace.Queries;
import raytracing.trace.ShadowMode;

/** A point on the floor y = 0 under a light 10 above it, two wide. */
class SoftShadowsTest {
    private static final String HEAD = """
        cam 0 5 -5 0 0 0 0 1 0 1 1
        set 0 0 0 1 1
        mtl 1 1 1 0 0 0 0 0 0 1 0
        mtl 1 1 1 0 0 0 0 0 0 1 0.5
        pln 0 1 0 0 1
        """;
    private static final Hit FLOOR = new HitRecord(0, 0, Vector.ZERO, 0, new Vector(0, 1, 0), Departure.OUTWARD).toHit();

    private static double share(int root, long key, double shadowIntensity, double width, String... surfaces) {
        Scene scene = SceneText.scene(HEAD + String.join("\n", surfaces)
            + "\nlgt 0 10 0 1 1 1 1 " + shadowIntensity + " " + width);
        PreparedScene prepared = Queries.prepared(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
        return new SampledShadows(prepared, root, 1).arrivingShare(FLOOR, scene.lights().get(0), 0, 0x1p-48, key);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5})
    void withNothingInBetweenAllLightArrives(int root) {
        assertEquals(1, share(root, 1, 1, 2));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5})
    void behindAWallNoLightArrives(int root) {
        assertEquals(0, share(root, 1, 1, 2, "pln 0 1 0 5 1"));
    }

    /** With less than a hundred bytes for each, a thread can have tens of thousands of lights. */
    @Test
    void aLightTakesLittleMemory() {
        PreparedScene prepared = Queries.prepared(SceneText.scene(HEAD), ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
        ThreadMXBean memory = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = memory.getThreadAllocatedBytes(Thread.currentThread().getId());
        SoftShadows shadows = new SampledShadows(prepared, 2, 20_000);
        long taken = memory.getThreadAllocatedBytes(Thread.currentThread().getId()) - before;
        assertEquals(0, shadows.rays());
        assertTrue(taken < 100 * 20_000, taken + " bytes");
    }

    @ParameterizedTest(name = "s = {0}")
    @CsvSource({"0, 1", "0.25, 0.75", "0.9, 0.1", "1, 0"})
    void theExercisesFormulaKeepsOneMinusSInTheShadow(double shadowIntensity, double expected) {
        assertEquals(expected, share(3, 1, shadowIntensity, 2, "pln 0 1 0 5 1"), 1e-15);
    }

    @Test
    void oneRayGoesToTheMiddleOfTheLight() {
        assertEquals(1, share(1, 1, 1, 2, "sph 0.2 5 0 0.19 1"));
        assertEquals(0, share(1, 1, 1, 2, "sph 0.2 5 0 0.21 1"));
    }

    @Test
    void aLightWithoutWidthCastsHardShadowsWhateverTheRoot() {
        assertEquals(1, share(7, 1, 1, 0, "sph 0.2 5 0 0.19 1"));
        assertEquals(0, share(7, 1, 1, 0, "sph 0.2 5 0 0.21 1"));
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 8})
    void theShareIsAMultipleOfOneOverTheNumberOfRays(int root) {
        double rays = share(root, 3, 1, 2, "sph 0.4 5 0 0.3 1") * root * root;
        assertEquals(Math.rint(rays), rays, 1e-12);
        assertTrue(rays > 0 && rays < root * root);
    }

    /**
     * A small ball well within the cone to the light hides the part of the square inside its shadow cone. In the
     * light's plane, at height 10, the cone around a ball of radius r at height 5 straight above the point is a disc
     * of radius R = 10 r / sqrt(25 - r r); it lies inside the square of width 2 for R below 1. The share hidden is
     * pi R R / 4.
     *
     * <p>Stratified samples have less variance than free ones, so with 400 keys of 64 rays the mean's standard error
     * is below sqrt(p (1 - p) / 25600). Five of them: a false alarm less than once in a million runs. The keys are
     * fixed, so the run is always the same.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.25, 0.45})
    void theMeanShareBehindABallIsThatOfItsShadowCone(double radius) {
        double disc = 10 * radius / Math.sqrt(25 - radius * radius);
        double hidden = Math.PI * disc * disc / 4;
        assertMean(1 - hidden, hidden, "sph 0 5 0 " + radius + " 1");
    }

    @Test
    void aTransparentBallHidesHalfOfWhatAnOpaqueOneDoes() {
        double disc = 10 * 0.4 / Math.sqrt(25 - 0.16);
        double hidden = Math.PI * disc * disc / 4;
        assertMean(1 - hidden / 2, hidden, "sph 0 5 0 0.4 2");
    }

    /**
     * The lower face at height 4 reaches from above the point to x = 4: in perspective it covers the half x > 0 of
     * the light; moved along z as well, a quarter. The border lies between two cells, so no sample is in doubt.
     */
    @ParameterizedTest
    @ValueSource(ints = {2, 4, 8})
    void aBoxHidesWhatItsLowerFaceCoversInPerspective(int root) {
        assertEquals(0.5, share(root, 1, 1, 2, "box 2 6 0 4 1"));
        assertEquals(0.75, share(root, 1, 1, 2, "box 2 6 2 4 1"));
        assertEquals(0.75, share(root, 1, 1, 2, "box 2 6 0 4 2"));
    }

    private static void assertMean(double expected, double hidden, String surface) {
        assertMean(expected, hidden, surface, "0 10 0");
    }

    private static void assertMean(double expected, double hidden, String surface, String position) {
        int keys = 400;
        int root = 8;
        Scene scene = SceneText.scene(HEAD + surface + "\nlgt " + position + " 1 1 1 1 1 2");
        PreparedScene prepared = Queries.prepared(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
        SoftShadows shadows = new SampledShadows(prepared, root, 1);
        double sum = 0;
        for (int i = 0; i < keys; i++) {
            sum += shadows.arrivingShare(FLOOR, scene.lights().get(0), 0, 0x1p-48, CounterRandom.bits(5, i));
        }
        double standardError = Math.sqrt(hidden * (1 - hidden) / ((double) keys * root * root));
        assertEquals(expected, sum / keys, 5 * standardError);
    }

    /** The square always faces the point, so a light 10 away in any direction is hidden as one straight above. */
    @ParameterizedTest
    @CsvSource({"6 8 0, 3 4 0", "0 6 -8, 0 3 -4", "4.8 6 6.4, 2.4 3 3.2", "-6.4 4.8 6, -3.2 2.4 3"})
    void theSquareFacesThePointFromEveryDirection(String light, String halfWay) {
        double disc = 10 * 0.4 / Math.sqrt(25 - 0.16);
        double hidden = Math.PI * disc * disc / 4;
        assertMean(1 - hidden, hidden, "sph " + halfWay + " 0.4 1", light);
    }

    /** Half way, 0.8 aside, is 1.6 beside the middle of the light: a radius of 0.09 stays clear of its corners, sqrt(2). */
    @ParameterizedTest
    @CsvSource({"0 10 0, 0.8 5 0", "6 8 0, 3 4 0.8", "0 6 -8, 0.8 3 -4"})
    void whatStandsBesideTheSquareHidesNothing(String light, String beside) {
        assertMean(1, 0, "sph " + beside + " 0.09 1", light);
    }

    /** Jitter of n cells a side errs by about n^-1.5: from 4 to 16 the spread must fall well below a half. */
    @Test
    void moreRaysMeanLessNoise() {
        assertTrue(spread(16) < 0.3 * spread(4));
        assertTrue(spread(4) > 0);
    }

    private static double spread(int root) {
        double sum = 0;
        double squares = 0;
        int keys = 200;
        for (int i = 0; i < keys; i++) {
            double share = share(root, CounterRandom.bits(6, i), 1, 2, "sph 0 5 0 0.3 1");
            sum += share;
            squares += share * share;
        }
        return Math.sqrt(squares / keys - sum / keys * (sum / keys));
    }

    private static double share(ShadowMethod method, double width, String... surfaces) {
        Scene scene = SceneText.scene(HEAD + String.join("\n", surfaces) + "\nlgt 0 10 0 1 1 1 1 1 " + width);
        PreparedScene prepared = Queries.prepared(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
        return method.shadows(prepared, 1, 1).arrivingShare(FLOOR, scene.lights().get(0), 0, 0x1p-48, 1);
    }

    @Test
    void aNamedRootStandsWhateverTheSceneSays() {
        double rays = 9 * share(ShadowMethod.Sampled.withRoot(3), 2, "sph 0.4 5 0 0.3 1");
        assertEquals(Math.rint(rays), rays, 1e-12);
        assertTrue(rays > 0 && rays < 9, rays + " of 9 rays");
    }

    /** The disc of {@link #theMeanShareBehindABallIsThatOfItsShadowCone}. */
    @Test
    void theExactShareBehindABallIsThatOfItsShadowCone() {
        double disc = 10 * 0.4 / Math.sqrt(25 - 0.16);
        assertEquals(1 - Math.PI * disc * disc / 4, share(new ShadowMethod.Exact(), 2, "sph 0 5 0 0.4 1"), 1e-12);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-30})
    void aLightWithoutWidthThatDoublesCouldTellCastsHardShadowsExactly(double width) {
        assertEquals(1, share(new ShadowMethod.Exact(), width, "sph 0.2 5 0 0.19 1"));
        assertEquals(0, share(new ShadowMethod.Exact(), width, "sph 0.2 5 0 0.21 1"));
    }

    @Test
    void behindAGlassWallTheExactShareIsItsTransparency() {
        assertEquals(0.5, share(new ShadowMethod.Exact(), 2, "pln 0 1 0 5 2"));
    }

    /**
     * 169 small balls half way, none behind another: more than exact shadows take on, so 16 x 16 rays are sent. Each ball
     * hides about the disc of its shadow cone, all together a fifth; five standard deviations of 256 rays are an eighth.
     */
    @Test
    void behindACrowdShadowRaysTakeOverFromExactShadows() {
        StringBuilder crowd = new StringBuilder();
        for (int i = -6; i <= 6; i++) {
            for (int k = -6; k <= 6; k++) {
                crowd.append("sph ").append(i / 13.0).append(" 5 ").append(k / 13.0).append(" 0.02 1\n");
            }
        }
        double share = share(new ShadowMethod.Exact(), 2, crowd.toString());
        assertEquals(Math.rint(256 * share), 256 * share, 1e-12);
        assertEquals(1 - 169 * Math.PI * 0.04 * 0.04 / 4, share, 0.125);
    }
}
