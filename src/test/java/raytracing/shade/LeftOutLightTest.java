package raytracing.shade;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.PictureDifference;
import raytracing.Steps;
import raytracing.ambient.AmbientLight;
import raytracing.color.MutableColor;
import raytracing.estimate.AmbientEstimate;
import raytracing.film.Film;
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

    @ParameterizedTest
    @MethodSource("raytracing.CommittedScenesTest#scenes")
    void noPixelDiffersByMoreThanOneStep(Path file) throws Exception {
        Scene scene = Steps.parseScene(file);
        PictureDifference difference = new PictureDifference(
            drawn(scene, Shader.NEGLIGIBLE_WEIGHT).toImage(), drawn(scene, 0).toImage());
        assertTrue(difference.shareOffByMoreThan(1) == 0, difference::toString);
        assertTrue(difference.shareOffByMoreThan(0) <= 0.001, difference::toString);
    }

    private static Film drawn(Scene scene, double negligibleWeight) {
        PreparedScene prepared = Queries.prepared(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
        AmbientLight ambientLight =
            AmbientEstimate.of(scene, prepared, SIZE, SIZE, 1, Double.POSITIVE_INFINITY, ForkJoin.sequential());
        Shader shader = new Shader(scene, prepared, ShadowMethod.OF_THE_SCENE, ambientLight, negligibleWeight,
            Shader.MOST_SURFACES, new VertexReservoir(VertexReservoir.Scattering.NONE));
        CameraRays rays = new CameraRays(scene.camera(), SIZE, SIZE);
        Film film = new Film(SIZE, SIZE);
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x++) {
                MutableColor light = shader.light(rays, x + 0.5, y + 0.5, (long) y * SIZE + x);
                film.set(x, y, light.red(), light.green(), light.blue());
            }
        }
        return film;
    }
}
