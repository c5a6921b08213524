package raytracing.shade;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Collections;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.PictureDifference;
import raytracing.SceneText;
import raytracing.Steps;
import raytracing.ambient.AmbientLight;
import raytracing.color.MutableColor;
import raytracing.estimate.AmbientEstimate;
import raytracing.film.Film;
import raytracing.math.Vector;
import raytracing.parallel.ForkJoin;
import raytracing.scene.CameraRays;
import raytracing.scene.Scene;
import raytracing.shadow.ShadowMethod;
import raytracing.trace.PreparedScene;
import raytracing.trace.Queries;
import raytracing.trace.ShadowMode;

/** What leaving out negligible light does to whole pictures, with the same random numbers on both sides. */
class LeftOutLightTest {
    private static final int SIZE = 100;
    private static final int SIZE_OF_HALLS = 8;
    private static final Thoroughness ALL =
        new Thoroughness(0, Integer.MAX_VALUE / 2, Integer.MAX_VALUE, Double.POSITIVE_INFINITY);

    /** Up to eight times as many rays in halls of planes, and no estimate. */
    private static final Thoroughness MORE = new Thoroughness(0x1p-12, 1 << 12, 1 << 12, Double.POSITIVE_INFINITY);

    /** Root mean squares, in steps: of errors below a half that mostly round to the same step, and the largest. */
    private static final double ROUNDED = 0.5;
    private static final double MOST_IN_A_HALL = 2.5;

    @ParameterizedTest
    @MethodSource("raytracing.CommittedScenesTest#scenes")
    void noPixelDiffersByMoreThanOneStep(Path file) throws Exception {
        Scene scene = Steps.parseScene(file);
        PictureDifference difference = new PictureDifference(
            drawn(scene, SIZE, Thoroughness.OF_A_PICTURE).toImage(),
            drawn(scene, SIZE, ALL).toImage());
        assertTrue(difference.shareOffByMoreThan(1) == 0, difference::toString);
        assertTrue(difference.shareOffByMoreThan(0) <= 0.001, difference::toString);
    }

    /** Mirrors of glass around a lamp and a ball: planes that send on half of the light, or a fifth, and balls in balls. */
    static Stream<Arguments> halls() {
        return Stream.of(
            Arguments.of("planes that mirror half", planes(12, 0.5, 0.5, 7)),
            Arguments.of("planes that mirror a fifth", planes(12, 0.8, 0.2, 5)),
            Arguments.of("more planes", planes(20, 0.6, 0.4, 5)),
            Arguments.of("balls in balls", balls(40, 0.9, 0.1, 2)),
            Arguments.of("balls of mirrors in balls", balls(25, 0.6, 0.4, 3)));
    }

    private static Scene planes(int count, double transparency, double reflection, int reflections) {
        Random random = new Random(5);
        StringBuilder lines = new StringBuilder();
        for (int i = 0; i < count; i++) {
            Vector normal = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
            lines.append("pln ").append(normal.x()).append(' ').append(normal.y()).append(' ').append(normal.z()).append(' ')
                .append(-(2 + random.nextDouble()) * normal.length()).append(" 1\n");
        }
        return hall(transparency, reflection, reflections, lines + "sph 0 0 1 0.4 2\n");
    }

    private static Scene balls(int count, double transparency, double reflection, int reflections) {
        StringBuilder lines = new StringBuilder();
        for (int i = 1; i <= count; i++) {
            lines.append("sph 0 0 0.001 ").append(2.0 * i / count).append(" 1\n");
        }
        return hall(transparency, reflection, reflections, lines + "pln 0 1 0 -2.1 2\n");
    }

    private static Scene hall(double transparency, double reflection, int reflections, String surfaces) {
        String mirror = String.join(" ", Collections.nCopies(3, Double.toString(reflection)));
        return SceneText.scene("cam 0.3 0.2 -1.5  0 0 1  0 1 0  1 1\nset 0.05 0.1 0.15 1 " + reflections
            + "\nmtl 0.8 0.6 0.5 0.3 0.3 0.3 " + mirror + " 30 " + transparency
            + "\nmtl 0.5 0.3 0.2 0.3 0.3 0.3 0 0 0 30 0\nlgt 0.5 0.8 0 0.5 0.5 0.5 1 1 0\n" + surfaces);
    }

    /**
     * Beside the picture with all rays followed. With up to eight times as many rays, and the background for the others, the
     * error is larger, or both are lost in rounding.
     */
    @ParameterizedTest(name = "{0}")
    @MethodSource("halls")
    void aHallOfTransparentMirrorsComesNearToAllRaysFollowed(String name, Scene scene) {
        BufferedImage all = drawn(scene, SIZE_OF_HALLS, ALL).toImage();
        PictureDifference now = new PictureDifference(
            drawn(scene, SIZE_OF_HALLS, Thoroughness.OF_A_PICTURE).toImage(), all);
        PictureDifference before = new PictureDifference(drawn(scene, SIZE_OF_HALLS, MORE).toImage(), all);
        assertTrue(now.rootMeanSquare() < Math.max(before.rootMeanSquare(), ROUNDED), now + ", before " + before);
        assertTrue(now.rootMeanSquare() < MOST_IN_A_HALL, now::toString);
    }

    private static Film drawn(Scene scene, int size, Thoroughness thoroughness) {
        PreparedScene prepared = Queries.prepared(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
        AmbientLight ambientLight =
            AmbientEstimate.of(scene, prepared, size, size, 1, Double.POSITIVE_INFINITY, ForkJoin.sequential());
        Shader shader = new Shader(scene, prepared, ShadowMethod.OF_THE_SCENE, ambientLight, thoroughness,
            new VertexReservoir(VertexReservoir.Scattering.NONE));
        CameraRays rays = new CameraRays(scene.camera(), size, size);
        Film film = new Film(size, size);
        for (int y = 0; y < size; y++) {
            for (int x = 0; x < size; x++) {
                MutableColor light = shader.light(rays, x + 0.5, y + 0.5, (long) y * size + x);
                film.set(x, y, light.red(), light.green(), light.blue());
            }
        }
        return film;
    }
}
