package raytracing.shade;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.SceneText;
import raytracing.ambient.AmbientLight;
import raytracing.color.Color;
import raytracing.scene.CameraRays;
import raytracing.scene.Scene;
import raytracing.shadow.ShadowMethod;
import raytracing.surface.RayRecord;
import raytracing.trace.PreparedScene;
import raytracing.trace.Queries;
import raytracing.trace.ShadowMode;

/** Every expected value is derived by hand from SPEC's formula; the derivation is the test's last remark. */
class ShaderTest {
    private static final String CAM = "cam 0 0 -5 0 0 0 0 1 0 1 1";
    private static final String SET = "set 0.1 0.2 0.4   1 10";
    private static final String WHITE_LIGHT = " 1 1 1 ";

    private static Color light(String... lines) {
        return lightSeenBy(CAM, lines);
    }

    /** What a camera sees in the middle of its picture. */
    private static Color lightSeenBy(String camera, String... lines) {
        Scene scene = scene(camera, lines);
        return light(scene, new Shader(scene, prepared(scene), ShadowMethod.OF_THE_SCENE, AmbientLight.NONE));
    }

    /** With nothing left out: for tests whose light comes from far down a chain of reflections. */
    private static Color allLight(String... lines) {
        Scene scene = scene(CAM, lines);
        return light(scene, new Shader(scene, prepared(scene), ShadowMethod.OF_THE_SCENE, AmbientLight.NONE,
            new Thoroughness(0, 1 << 12, 1 << 8, Double.POSITIVE_INFINITY),
            new VertexReservoir(VertexReservoir.Scattering.NONE)));
    }

    private static Color light(Scene scene, Shader shader) {
        return shader.light(new CameraRays(scene.camera(), 1, 1), 0.5, 0.5, 1).toColor();
    }

    private static Scene scene(String camera, String... lines) {
        return SceneText.scene(camera + "\n" + String.join("\n", lines));
    }

    private static PreparedScene prepared(Scene scene) {
        return Queries.prepared(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
    }

    private static void assertColor(double red, double green, double blue, Color found) {
        assertEquals(red, found.red(), 1e-14);
        assertEquals(green, found.green(), 1e-14);
        assertEquals(blue, found.blue(), 1e-14);
    }

    @Test
    void aRayThatMeetsNothingSeesTheBackground() {
        assertColor(0.1, 0.2, 0.4, light(SET));
    }

    @Test
    void aSurfaceWithoutLightIsBlack() {
        assertColor(0, 0, 0, light(SET, "mtl 1 1 1  1 1 1  0 0 0  10 0", "pln 0 0 1 0 1"));
    }

    /** The light stands at the eye's height, 45 degrees aside: N.L = sqrt(1/2), so Kd light N.L. */
    @Test
    void diffuseLightFallsWithTheCosine() {
        Color found = light(SET, "mtl 0.5 1 0.25  0 0 0  0 0 0  1 0", "pln 0 0 1 0 1",
            "lgt 5 0 -5  1 0.5 2  1 1 0");
        assertColor(0.5 * Math.sqrt(0.5), 0.5 * Math.sqrt(0.5), 0.5 * Math.sqrt(0.5), found);
    }

    /** N.L = cos 60 = 1/2; the mirror image of L is 60 degrees from the eye: R.V = 1/2, squared 1/4, times 0.8, 0.5. */
    @Test
    void highlightsFallWithThePowerOfTheCosineToTheMirrorImage() {
        double height = 5 / Math.tan(Math.toRadians(30));
        Color found = light(SET, "mtl 0.2 0.2 0.2  0.8 0.4 0  0 0 0  2 0", "pln 0 0 1 0 1",
            "lgt 0 " + height + " -5 " + WHITE_LIGHT + " 0.5 1 0");
        assertColor(0.1 + 0.1, 0.1 + 0.05, 0.1, found);
    }

    @Test
    void lightsAddUp() {
        Color found = light(SET, "mtl 0.5 0.5 0.5  0 0 0  0 0 0  1 0", "pln 0 0 1 0 1",
            "lgt 0 0 -5  1 0 0  1 1 0", "lgt 0 0 -9  0 1 0  1 1 0", "lgt 0 0 -1  0 0.5 0.5  1 1 0");
        assertColor(0.5, 0.75, 0.25, found);
    }

    /** The course's program forgot the max of both terms: negative light, and even exponents that shine from behind. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4})
    void aLightBehindTheSurfaceGivesNeitherDiffuseNorSpecularLight(int exponent) {
        Color found = light(SET, "mtl 1 1 1  1 1 1  0 0 0  " + exponent + " 0", "pln 0 0 1 0 1",
            "lgt 0 0 7" + WHITE_LIGHT + "1 0 0");
        assertColor(0, 0, 0, found);
    }

    /** The mirror image points 120 degrees from the eye: a negative cosine counts as 0, and 0^0 is 1. */
    @ParameterizedTest
    @CsvSource({"2, 0", "1, 0", "0, 1"})
    void aMirrorImageTurnedAwayFromTheEyeShowsNoHighlight(double exponent, double expected) {
        String grazing = "cam " + -Math.sqrt(3) + " 0 -1  0 0 0  0 1 0  1 1";
        double sine = Math.sqrt(3) / 2;      // light on the eye's side, as flat as the eye: R.V = -cos 60
        Color found = lightSeenBy(grazing, SET, "mtl 0 0 0  1 1 1  0 0 0 " + exponent + " 0", "pln 0 0 1 0 1",
            "lgt " + -9 * sine + " 0 -4.5 " + WHITE_LIGHT + " 1 1 0");
        assertColor(expected, expected, expected, found);
    }

    @Test
    void aLightExactlyAtTheShadedPointLightsNothing() {
        Color found = light(SET, "mtl 1 1 1  1 1 1  0 0 0  2 0", "pln 0 0 1 0 1",
            "lgt 0 0 0" + WHITE_LIGHT + "1 1 1");
        assertColor(0, 0, 0, found);
    }

    /** Intensity = (1 - s) + s * share, and a hidden light's share is 0. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.25, 0.9, 1})
    void aHiddenLightIsMultipliedByOneMinusItsShadowIntensity(double shadow) {
        Color found = light(SET, "mtl 1 1 1  0 0 0  0 0 0  1 0", "pln 0 0 1 0 1", "sph 0 5 -5 0.5 1",
            "lgt 0 10 -10" + WHITE_LIGHT + "1 " + shadow + " 0");
        double facing = Math.sqrt(0.5);
        assertColor((1 - shadow) * facing, (1 - shadow) * facing, (1 - shadow) * facing, found);
    }

    /** Two opaque balls in line: the exercise does not accumulate shadow intensity. */
    @Test
    void severalOccludersCastNoDeeperShadowThanOne() {
        Color found = light(SET, "mtl 1 1 1  0 0 0  0 0 0  1 0", "pln 0 0 1 0 1", "sph 0 5 -5 0.5 1",
            "sph 0 7 -7 0.5 1", "lgt 0 10 -10" + WHITE_LIGHT + "1 0.5 0");
        assertColor(0.5 * Math.sqrt(0.5), 0.5 * Math.sqrt(0.5), 0.5 * Math.sqrt(0.5), found);
    }

    /** Two glass balls in line let through 0.5 * 0.25; s = 0.8: 0.2 + 0.8 * 0.125 = 0.3. */
    @Test
    void lightThroughTransparentSurfacesIsWeakenedByEach() {
        Color found = light(SET, "mtl 1 1 1  0 0 0  0 0 0  1 0", "mtl 0 0 0  0 0 0  0 0 0  1 0.5",
            "mtl 0 0 0  0 0 0  0 0 0  1 0.25", "pln 0 0 1 0 1", "sph 0 5 -5 0.5 2", "box 0 7 -7 0.5 3",
            "lgt 0 10 -10" + WHITE_LIGHT + "1 0.8 0");
        assertColor(0.3 * Math.sqrt(0.5), 0.3 * Math.sqrt(0.5), 0.3 * Math.sqrt(0.5), found);
    }

    /** behind * 0.75 + lit * 0.25, with a light at the eye: N.L = 1 on both. */
    @Test
    void aTransparentSurfaceMixesItsColourWithWhatIsBehind() {
        Color found = light(SET, "mtl 1 0 0  0 0 0  0 0 0  1 0.75", "mtl 0 1 1  0 0 0  0 0 0  1 0",
            "sph 0 0 0 1 1", "pln 0 0 1 3 2", "lgt 0 0 -5" + WHITE_LIGHT + "1 0 0");
        assertColor(0.25, 0.75, 0.75, found);
    }

    /** One half for every surface that the straight ray meets; the far wall of each would make it an eighth or less. */
    @ParameterizedTest
    @ValueSource(strings = {"sph 0 0 0 1 1", "box 0 0 0 2 1"})
    void aTransparentBodyCountsOnceAlongAStraightRay(String body) {
        Color found = light("set 1 1 1 1 1", "mtl 0 0 0  0 0 0  0 0 0  1 0.5", body);
        assertColor(0.5, 0.5, 0.5, found);
    }

    @Test
    void nestedTransparentBodiesCountOnceEach() {
        Color found = light("set 1 1 1 1 1", "mtl 0 0 0  0 0 0  0 0 0  1 0.5",
            "sph 0 0 0 1 1", "sph 0 0 0 2 1", "sph 0 0 0 3 1", "box 0 0 0 1 1");
        assertColor(1 / 16.0, 1 / 16.0, 1 / 16.0, found);
    }

    /**
     * Two coincident glass planes in the same penumbra, one red, one green: their shares of light would be equal if
     * they used the same random numbers, and then red, with weight 1/2, would be twice green, with weight 1/4.
     */
    @Test
    void everySurfaceAlongARayHasRandomNumbersOfItsOwn() {
        Color found = light("set 0 0 0 8 1", "mtl 1 0 0  0 0 0  0 0 0  1 0.5", "mtl 0 1 0  0 0 0  0 0 0  1 0.5",
            "mtl 0 0 0  0 0 0  0 0 0  1 0", "pln 0 0 1 0 1", "pln 0 0 1 0 2", "sph 0.3 0 -7 0.4 3",
            "lgt 0 0 -9" + WHITE_LIGHT + "1 1 2");
        assertTrue(found.red() > 0.1 && found.red() < 0.45, "no penumbra");
        assertTrue(Math.abs(found.red() - 2 * found.green()) > 0.005, found::toString);
    }

    /** Fully transparent with mirror colour 0.25: what is behind, 1 of the background, plus 0.25 of it mirrored. */
    @Test
    void reflectionIsAddedAfterTransparency() {
        Color found = light(SET, "mtl 0 0 0  0 0 0  0.25 0.25 0.25  1 1", "sph 0 0 0 1 1");
        assertColor(1.25 * 0.1, 1.25 * 0.2, 1.25 * 0.4, found);
    }

    /** The mirror at z = 0 shows the wall at z = -9 behind the eye, lit from the eye: N.L = 1. */
    @Test
    void aMirrorShowsWhatIsBehindTheEye() {
        Color found = light(SET, "mtl 0 0 0  0 0 0  0.5 0.5 1  1 0", "mtl 1 0.5 0.25  0 0 0  0 0 0  1 0",
            "pln 0 0 1 0 1", "pln 0 0 1 -9 2", "lgt 0 0 -5" + WHITE_LIGHT + "1 1 0");
        assertColor(0.5, 0.25, 0.25, found);
    }

    /**
     * Between two mirrors of 1/2 that shine with 1 themselves: 1 + 1/2 + ... + 1/2^M, then 1/2^(M+1) of the background,
     * as if the surface of reflection M + 1 did not exist.
     */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 10, 40, 1000})
    void theRecursionLimitReplacesTheNextMirroredRayByTheBackground(int most) {
        double background = 3;
        Color found = allLight("set 3 3 3 1 " + most, "mtl 1 1 1  0 0 0  0.5 0.5 0.5  1 0", "pln 0 0 1 0 1",
            "pln 0 0 1 -9 1", "lgt 0 0 -5" + WHITE_LIGHT + "1 1 0");
        double shining = 2 - Math.scalb(1.0, -most);
        double expected = shining + Math.scalb(background, -most - 1);
        assertColor(expected, expected, expected, found);
    }

    /** Along a single chain of mirrors only one ray is ever left out: light of at most 3 times a negligible weight. */
    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.5, 0.9})
    void leavingOutNegligibleLightChangesLessThanItsWeight(double mirror) {
        String material = "mtl 1 1 1  0 0 0  " + (mirror + " ").repeat(3) + " 1 0";
        String[] lines = {"set 3 3 3 1 1000", material, "pln 0 0 1 0 1", "pln 0 0 1 -9 1",
            "lgt 0 0 -5 2 2 2 1 1 0"};
        double all = allLight(lines).red();
        double without = light(lines).red();
        double ahead = 2 / (1 - mirror);     // what the chain shines with from any mirror on, with no end
        assertEquals(all, without, Thoroughness.OF_A_PICTURE.negligibleWeight() * Math.abs(ahead - 3));
        assertTrue(all != without, "nothing was left out");
    }

    /** From the middle of a mirrored ball every ray comes straight back, M times, then sees the background. */
    @ParameterizedTest
    @ValueSource(strings = {"sph 0 0 0 2 1", "box 0 0 0 4 1"})
    void aMirroredBodyReflectsItselfFromInside(String body) {
        Color found = lightSeenBy("cam 0 0 0  0 0 1  0 1 0  1 1", "set 1 1 1 1 3", "mtl 0 0 0  0 0 0  0.5 0.5 0.5  1 0", body);
        assertColor(1 / 16.0, 1 / 16.0, 1 / 16.0, found);
    }

    @Test
    void hugeAndTinyColoursAreMultipliedLikeAnyOthers() {
        Color found = light(SET, "mtl 1e200 0 1e-200  0 0 0  0 0 0  1 0", "pln 0 0 1 0 1",
            "lgt 0 0 -5 1e100 1 1e-100  1 1 0");
        assertEquals(1e300, found.red(), 1e286);
        assertEquals(0, found.green());
        assertEquals(1e-300, found.blue(), 1e-314);
    }

    @Test
    void coloursWhoseProductIsBeyondEveryDoubleLeaveTheOtherChannelsAlone() {
        Color found = light(SET, "mtl 1e300 0 0.5  0 0 0  1e300 1 0  1 0", "pln 0 0 1 0 1",
            "lgt 0 0 -5 1e300 1e300 1  1 1 0");
        assertEquals(new Color(Double.MAX_VALUE, 0.2, 0.5), found);
    }

    /**
     * Every ray splits at each of 20 mirroring glass balls, so 20^10 rays would be followed without a limit. The balls
     * are black, so all the light there is comes from the background, by weights that add up the same whatever is left
     * out: everything passes (1), and whatever is mirrored (1 at each first wall) adds to it.
     */
    @Test
    void aHallOfTransparentMirrorsEnds() {
        StringBuilder balls = new StringBuilder("mtl 0 0 0  0 0 0  1 1 1  1 1\n");
        for (int i = 1; i <= 20; i++) {
            balls.append("sph 0 0 0 ").append(i / 4.1).append(" 1\n");
        }
        Color found = light("set 0.25 0.5 1 1 10", balls.toString());
        assertEquals(2 * found.red(), found.green(), 1e-9 * found.green());
        assertTrue(found.red() > 0.25 * 20);
    }

    /**
     * One ray passes many balls, each mirrors half of what comes from the front, and none of the mirrored rays is followed:
     * where nothing is estimated, half of the background stands for each.
     */
    @Test
    void theBackgroundStandsForEveryRayThatIsLeftOut() {
        int count = 1000;
        StringBuilder balls = new StringBuilder("mtl 0 0 0  0 0 0  0.5 0.5 0.5  1 1\n");
        for (int i = 1; i <= count; i++) {
            balls.append("sph 0 0 ").append(4 * i).append(" 1 1\n");
        }
        Scene scene = scene(CAM, "set 0.25 0.5 1 1 10", balls.toString());
        Color found = light(scene, new Shader(scene, prepared(scene), ShadowMethod.OF_THE_SCENE, AmbientLight.NONE,
            new Thoroughness(0, 0, 0, Double.POSITIVE_INFINITY), new VertexReservoir(VertexReservoir.Scattering.NONE)));
        assertColor(0.25 * (1 + count / 2.0), 0.5 * (1 + count / 2.0), 1 + count / 2.0, found);
    }

    @Test
    void aShaderForgetsTheRayBefore() {
        Scene scene = scene(CAM, SET, "mtl 0.5 0.5 0.5  0 0 0  0.5 0.5 0.5  1 0.5", "sph 0 0 0 1 1",
            "lgt 0 0 -5" + WHITE_LIGHT + "1 1 0");
        Shader shader = new Shader(scene, prepared(scene), ShadowMethod.OF_THE_SCENE, AmbientLight.NONE);
        Color first = light(scene, shader);
        assertEquals(first, light(scene, shader));
    }

    /** A lamp far away in the plane, as nearly as doubles can say so, is above or below it by their rounding alone. */
    @Test
    void aLampInThePlaneOfASurfaceDoesNotShineOnIt() {
        SplittableRandom random = new SplittableRandom(51);
        for (int i = 0; i < 200; i++) {
            double x = random.nextDouble(-1e6, 1e6);
            double y = random.nextDouble(-1e6, 1e6);
            Color found = light(SET, "mtl 1 1 1  1 1 1  0 0 0  0 0", "pln 0.1 0.2 0.3  0.07 1",
                "lgt " + x + " " + y + " " + (0.07 - 0.1 * x - 0.2 * y) / 0.3 + WHITE_LIGHT + "1 0 0");
            assertEquals(Color.BLACK, found);
        }
    }

    private static Color lightInAmbientLight(Color ambientLight, String... lines) {
        Scene scene = scene(CAM, lines);
        return light(scene,
            new Shader(scene, prepared(scene), ShadowMethod.OF_THE_SCENE, AmbientLight.even(ambientLight)));
    }

    /** Diffuse 0.5 of a light of 1 straight ahead, and ambient times the room's light. */
    @Test
    void ambientColourTimesTheRoomsLightIsAddedToDiffuseLight() {
        Color found = lightInAmbientLight(new Color(0.5, 1, 2), SET, "mtl 0.5 0.5 0.5  0 0 0  0 0 0  1 0  0.2 0.4 0",
            "pln 0 0 1 0 1", "lgt 0 0 -5" + WHITE_LIGHT + "1 1 0");
        assertColor(0.5 + 0.1, 0.5 + 0.4, 0.5, found);
    }

    @Test
    void theAmbientScaleMultipliesTheRoomsLight() {
        Color found = lightInAmbientLight(Color.WHITE, "set 0 0 0 1 1  2.5", "mtl 0 0 0  0 0 0  0 0 0  1 0  0.1 0.2 0.4",
            "pln 0 0 1 0 1");
        assertColor(0.25, 0.5, 1, found);
    }

    /** (1 - 0.75) times 0.4, and 0.75 of the background. */
    @Test
    void whatIsTransparentShowsLessAmbientLight() {
        Color found = lightInAmbientLight(Color.WHITE, "set 1 0 0 1 1", "mtl 0 0 0  0 0 0  0 0 0  1 0.75  0.4 0.4 0.4",
            "pln 0 0 1 0 1");
        assertColor(0.75 + 0.1, 0.1, 0.1, found);
    }

    @Test
    void ambientLightIsSeenInMirrors() {
        Color found = lightInAmbientLight(Color.WHITE, SET, "mtl 0 0 0  0 0 0  0.5 0.5 0.5  1 0",
            "mtl 0 0 0  0 0 0  0 0 0  1 0  0.2 0.4 0.8", "pln 0 0 1 0 1", "pln 0 0 1 -9 2");
        assertColor(0.1, 0.2, 0.4, found);
    }

    private static long fingerprint(double x, double y, String... lines) {
        Scene scene = scene("cam " + x + " " + y + " -5  " + x + " " + y + " 0  0 1 0  1 1\n" + SET, lines);
        Shader shader = new Shader(scene, prepared(scene), ShadowMethod.OF_THE_SCENE, AmbientLight.NONE);
        light(scene, shader);
        return shader.fingerprint();
    }

    /** A mirror and glass before a wall, and a ball behind the eye; the ray goes along z. */
    private static final String[] MIRROR_AND_GLASS = {
        "mtl 0 0 0  0 0 0  0.5 0.5 0.5  1 0.5", "mtl 1 1 1  0 0 0  0 0 0  1 0",
        "box 0 0 0  2 1", "sph 0 0 3  0.5 2", "sph 0 0 -9  0.5 2", "pln 0 0 1  9 2"};

    @Test
    void raysThatMeetTheSameSurfacesHaveTheSameFingerprint() {
        assertEquals(fingerprint(0, 0, MIRROR_AND_GLASS), fingerprint(0.1, -0.2, MIRROR_AND_GLASS));
        assertEquals(fingerprint(0.6, 0, MIRROR_AND_GLASS), fingerprint(-0.7, 0.9, MIRROR_AND_GLASS));
        assertEquals(fingerprint(2, 0, MIRROR_AND_GLASS), fingerprint(3, 4, MIRROR_AND_GLASS));
    }

    /** Only the wall; glass before it; and with the balls behind the glass and in the mirror. */
    @Test
    void raysThatMeetOtherSurfacesHaveAnotherFingerprint() {
        long wall = fingerprint(2, 0, MIRROR_AND_GLASS);
        long glass = fingerprint(0.6, 0, MIRROR_AND_GLASS);
        long balls = fingerprint(0, 0, MIRROR_AND_GLASS);
        assertEquals(3, Stream.of(wall, glass, balls).distinct().count());
    }

    @ParameterizedTest
    @ValueSource(strings = {"sph 0 0 3  0.5 2", "sph 0 0 -9  0.5 2"})
    void whatIsSeenThroughGlassOrInAMirrorAloneChangesTheFingerprint(String ball) {
        String[] scene = {MIRROR_AND_GLASS[0], MIRROR_AND_GLASS[1], "box 0 0 0  2 1", ball};
        assertNotEquals(fingerprint(0, 0, scene), fingerprint(0.6, 0, scene));
    }

    @Test
    void twoBallsOfOneMaterialHaveDifferentFingerprints() {
        String[] twins = {"mtl 1 1 1  0 0 0  0 0 0  1 0", "sph -2 0 0 1 1", "sph 2 0 0 1 1"};
        assertNotEquals(fingerprint(-2, 0, twins), fingerprint(2, 0, twins));
    }

    /** Both rays meet the box and then a ball, one straight on and one mirrored. */
    @Test
    void itMattersWhichRayMeetsASurface() {
        String[] behind = {MIRROR_AND_GLASS[0], MIRROR_AND_GLASS[1], "box 0 0 0  2 1", "sph 0 0 3  0.5 2"};
        String[] mirrored = {MIRROR_AND_GLASS[0], MIRROR_AND_GLASS[1], "box 0 0 0  2 1", "sph 0 0 -9  0.5 2"};
        assertNotEquals(fingerprint(0, 0, behind), fingerprint(0, 0, mirrored));
    }

    @Test
    void clearGlassBeforeTheSkyHasAnotherFingerprintThanTheSky() {
        assertNotEquals(fingerprint(0, 0), fingerprint(0, 0, "mtl 0 0 0  0 0 0  0 0 0  1 1", "box 0 0 0  2 1"));
    }

    @Test
    void theSkyHasAnotherFingerprintThanTheBlackBesideALens() {
        Scene scene = SceneText.scene("cam 0 0 0  0 0 1  0 1 0  0.1 2 true 0", "set 0 0 0  1 1");
        Shader shader = new Shader(scene, prepared(scene), ShadowMethod.OF_THE_SCENE, AmbientLight.NONE);
        CameraRays rays = new CameraRays(scene.camera(), 100, 100);
        shader.light(rays, 50, 50, 1);
        long sky = shader.fingerprint();
        shader.light(rays, 1, 1, 1);
        assertNotEquals(sky, shader.fingerprint());
    }
}
