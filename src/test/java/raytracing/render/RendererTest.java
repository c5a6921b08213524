package raytracing.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.SceneText;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.math.Vector;
import raytracing.scene.Camera;
import raytracing.scene.Material;
import raytracing.scene.Pinhole;
import raytracing.scene.Scene;
import raytracing.surface.Sphere;

class RendererTest {
    /** Soft shadows, a mirror and a transparent ball: everything that draws random numbers. */
    static final Scene SCENE = SceneText.scene(
        "cam 0 2 -6   0 0 0   0 1 0   1 1",
        "set 0.2 0.3 0.4   3 4",
        "mtl 0.8 0.8 0.8   0 0 0         0 0 0         1  0",
        "mtl 0.9 0.2 0.2   0.5 0.5 0.5   0.3 0.3 0.3   20 0.6",
        "mtl 0.1 0.1 0.1   0.5 0.5 0.5   0.8 0.8 0.8   50 0",
        "pln 0 1 0  -1  1",
        "sph -0.6 0 0  1  2",
        "sph 0.9 0 0.5  1  3",
        "lgt 3 5 -3   0.6 0.6 0.6   1 0.9 2",
        "lgt -4 6 -1  0.4 0.4 0.4   1 0.7 1");
    private static final RenderSettings SMALL = RenderSettings.DEFAULT.withSize(61, 47);

    static void assertSamePixels(Film expected, Film found) {
        for (int y = 0; y < expected.height(); y++) {
            for (int x = 0; x < expected.width(); x++) {
                assertEquals(expected.get(x, y), found.get(x, y), "pixel " + x + ", " + y);
            }
        }
    }

    @ParameterizedTest(name = "{0} threads, tiles of {1}")
    @CsvSource({"1, 16", "2, 16", "3, 1", "2, 7", "7, 61", "4, 1000", "64, 5"})
    void thePictureIsTheSameForEveryNumberOfThreadsAndEveryTileSize(int threads, int tileSize) {
        assertSamePixels(Renderers.film(SCENE, SMALL.withWorkers(1, 61)),
            Renderers.film(SCENE, SMALL.withWorkers(threads, tileSize)));
    }

    /** One of two tiles is all sky, so one of two threads is long done when the other is not. */
    @ParameterizedTest(name = "{0}")
    @CsvSource({"the floor is below, 1", "the floor is above, -1"})
    void theFilmIsHandedOutOnlyWhenEveryThreadIsDone(String why, int up) {
        Scene scene = SceneText.scene("cam 0 1 0  0 1 9  0 " + up + " 0  1 2", "set 0.5 0.5 0.5 60 1",
            "mtl 1 1 1 0 0 0 0 0 0 1 0", "pln 0 1 0 0 1", "lgt 0 9 9 1 1 1 1 1 1");
        RenderSettings oneColumn = RenderSettings.DEFAULT.withSize(32, 64);
        assertSamePixels(Renderers.film(scene, oneColumn.withWorkers(1, 32)),
            Renderers.film(scene, oneColumn.withWorkers(2, 32)));
    }

    @Test
    void anyPixelCanBeReplayed() {
        Renderer renderer = Renderers.of(SCENE, SMALL);
        Film film = Renderers.film(renderer);
        assertEquals(film.get(30, 40), Renderers.pixel(renderer, 30, 40));
        assertEquals(film.get(0, 0), Renderers.pixel(renderer, 0, 0));
    }

    @Test
    void anotherSeedGivesOtherShadowsAndNothingElse() {
        Film one = Renderers.film(SCENE, SMALL);
        Film other = Renderers.film(SCENE, SMALL.withSeed(2));
        int penumbra = 0;
        for (int y = 0; y < one.height(); y++) {
            for (int x = 0; x < one.width(); x++) {
                penumbra += one.get(x, y).equals(other.get(x, y)) ? 0 : 1;
            }
        }
        assertTrue(penumbra > 100, "pixels that differ: " + penumbra);
        assertEquals(one.get(0, 0), other.get(0, 0), "the background has no shadows");
    }

    /** A scene that no parser would make: its sphere has no reflection colour, not even black. */
    @Test
    void aFailureNamesItsPixel() {
        Camera camera = new Camera(new Vector(0, 0, -5), Vector.ZERO, new Vector(0, 1, 0), 1, 1, new Pinhole());
        Material incomplete = new Material(Color.BLACK, Color.BLACK, null, 1, 0, Color.BLACK);
        Scene broken = new Scene(camera, SCENE.settings(), List.of(incomplete),
            List.of(new Sphere(Vector.ZERO, 0.1, 0)), List.of());
        IllegalStateException failure = assertThrows(IllegalStateException.class,
            () -> Renderers.film(broken, RenderSettings.DEFAULT.withSize(5, 5).withWorkers(2, 2)));
        assertTrue(failure.getMessage().startsWith("pixel 2, 2: "), failure.getMessage());
    }
}
