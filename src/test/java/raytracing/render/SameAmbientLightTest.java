package raytracing.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.ambient.AmbientScenes;
import raytracing.color.Color;
import raytracing.compiled.Shortcut;
import raytracing.film.Film;
import raytracing.scene.Scene;
import raytracing.shade.AmbientLight;

/** The estimate depends on the scene, the picture's shape and the seed, and on nothing else. */
class SameAmbientLightTest {
    private static final Scene SCENE = AmbientScenes.halfClosed();
    private static final RenderSettings SMALL = RenderSettings.DEFAULT.withSize(30, 20);

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 7, 64})
    void forEveryNumberOfThreads(int threads) {
        RendererTest.assertSamePixels(new Renderer(SCENE, SMALL.withWorkers(1, 16)).render(),
            new Renderer(SCENE, SMALL.withWorkers(threads, 16)).render());
    }

    @ParameterizedTest
    @EnumSource(Shortcut.class)
    void withoutAnyShortcut(Shortcut shortcut) {
        RendererTest.assertSamePixels(new Renderer(SCENE, SMALL).render(),
            new Renderer(SCENE, SMALL, EnumSet.complementOf(EnumSet.of(shortcut))).render());
    }

    @Test
    void whenAPixelIsReplayed() {
        Film film = new Renderer(SCENE, SMALL).render();
        assertEquals(film.get(7, 11), new Renderer(SCENE, SMALL).pixel(7, 11));
    }

    /** What is gathered at the places is the same; only how far apart the pixels lie is not. */
    @Test
    void forPicturesOfTheSameShape() {
        Color small = new Renderer(SCENE, SMALL.withSize(60, 40)).ambientLight().mean();
        Color large = new Renderer(SCENE, SMALL.withSize(120, 80)).ambientLight().mean();
        assertEquals(small.red(), large.red(), 1e-9);
        assertEquals(small.green(), large.green(), 1e-9);
        assertEquals(small.blue(), large.blue(), 1e-9);
    }

    /** What is looked at, at most: as many places as the picture has pixels, each along its longer edge. */
    @ParameterizedTest
    @CsvSource({"1, 1, 16", "4, 3, 16", "16, 5, 256", "5, 16, 256"})
    void butNotForTinyOnesWhichHaveNoMorePlacesThanPixels(int width, int height, int most) {
        AmbientLight light = new Renderer(SCENE, SMALL.withSize(width, height)).ambientLight();
        assertTrue(light.placeCount() > 0 && light.placeCount() <= most, light.placeCount() + " places");
    }

    @Test
    void butNotForOtherSeeds() {
        Color one = new Renderer(SCENE, SMALL).ambientLight().mean();
        Color other = new Renderer(SCENE, SMALL.withSeed(2)).ambientLight().mean();
        assertNotEquals(one, other);
        assertEquals(1, one.red() / other.red(), 0.05);
    }
}
