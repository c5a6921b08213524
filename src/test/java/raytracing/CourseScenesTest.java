package raytracing;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.trace.ShadowMode;

/** Holds our pictures of the course's scenes to both sets of pictures. Skips where they are missing. */
class CourseScenesTest {
    @BeforeEach
    void scenesAreThere() {
        Shared.require(Shared.SCENES);
    }

    @ParameterizedTest
    @CsvSource({"Room1", "Room1_fish"})
    void hardShadowsAgreeWithAnIndependentRenderer(String scene) throws Exception {
        PictureDifference difference = CourseScenes.difference(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT,
            "expected/" + scene + ".png");
        assertTrue(difference.psnr() >= 50, difference::toString);
        assertTrue(difference.shareOffByMoreThan(1) <= 0.001, difference::toString);
    }

    /** Pictures of N = 32 are nearly free of noise; what is left between them and ours is the noise of our N. */
    @ParameterizedTest
    @CsvSource({
        "Pool,    TRANSPARENT_SURFACES_PASS_LIGHT, Pool,           45",
        "Spheres, TRANSPARENT_SURFACES_PASS_LIGHT, Spheres,        47",
        "Spheres, ALL_SURFACES_STOP_LIGHT,         Spheres_opaque, 47",
    })
    void softShadowsAgreeWithAnIndependentRendererToTheirNoise(String scene, ShadowMode shadowMode, String expected,
                                                               double psnr) throws Exception {
        PictureDifference difference = CourseScenes.difference(scene, shadowMode, "expected/" + expected + ".png");
        assertTrue(difference.psnr() >= psnr, difference::toString);
        assertTrue(Math.abs(difference.mean()) < 0.1, difference::toString);
    }

    @ParameterizedTest
    @CsvSource({
        "Room1,      TRANSPARENT_SURFACES_PASS_LIGHT, 32",
        "Room1_fish, TRANSPARENT_SURFACES_PASS_LIGHT, 28.5",
        "Pool,       TRANSPARENT_SURFACES_PASS_LIGHT, 30",
        "Spheres,    ALL_SURFACES_STOP_LIGHT,         29",
    })
    void theCoursesOwnPicturesAreMetButForTheirHabits(String scene, ShadowMode shadowMode, double psnr)
            throws Exception {
        PictureDifference difference = CourseScenes.difference(scene, shadowMode, scene + ".png");
        assertTrue(difference.psnr() >= psnr, difference::toString);
    }
}
