package raytracing;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.compiled.ShadowMode;
import raytracing.render.RenderSettings;

/**
 * The course's scenes, which are not ours to keep here, against two sets of pictures: those of an independent renderer
 * with the conventions of this one, and those that the course gave out, whose program had habits that README lists.
 * Skips, and says so, where the scenes are not beside the checkout.
 */
class CourseScenesTest {
    private static final Path SCENES = Path.of("..", "shared", "scenes");

    @BeforeEach
    void scenesAreThere() {
        boolean there = Files.isDirectory(SCENES);
        if (!there) {
            System.err.println("SKIPPED: the course's scenes are not in " + SCENES);
        }
        assumeTrue(there, "the course's scenes are not in " + SCENES);
    }

    private static PictureDifference difference(String scene, ShadowMode shadowMode, String expected)
            throws Exception {
        RenderSettings settings = RenderSettings.DEFAULT.withShadowMode(shadowMode);
        BufferedImage drawn = RayTracer.renderScene(
            RayTracer.parseScene(SCENES.resolve(scene + ".txt")), settings).toImage();
        return new PictureDifference(drawn, ImageIO.read(SCENES.resolve(expected).toFile()));
    }

    @ParameterizedTest
    @CsvSource({"Room1", "Room1_fish"})
    void hardShadowsAgreeWithAnIndependentRenderer(String scene) throws Exception {
        PictureDifference difference = difference(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT,
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
        PictureDifference difference = difference(scene, shadowMode, "expected/" + expected + ".png");
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
        PictureDifference difference = difference(scene, shadowMode, scene + ".png");
        assertTrue(difference.psnr() >= psnr, difference::toString);
    }
}
