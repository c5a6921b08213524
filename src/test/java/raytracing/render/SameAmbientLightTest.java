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
import raytracing.ambient.AmbientLight;
import raytracing.color.Color;
import raytracing.estimate.AmbientScenes;
import raytracing.film.Film;
import raytracing.scene.Scene;
import raytracing.trace.Shortcut;

/** The estimate depends on the scene, the picture's shape and the seed, and on nothing else. */
class SameAmbientLightTest {
    private static final Scene SCENE = AmbientScenes.halfClosed();
    private static final RenderSettings SMALL = RenderSettings.DEFAULT.withSize(30, 20);

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 7, 64})
    void forEveryNumberOfThreads(int threads) {
        RendererTest.assertSamePixels(Renderers.film(SCENE, SMALL.withWorkers(1, 16)),
            Renderers.film(SCENE, SMALL.withWorkers(threads, 16)));
    }

    @ParameterizedTest
    @EnumSource(Shortcut.class)
    void withoutAnyShortcut(Shortcut shortcut) {
        RendererTest.assertSamePixels(Renderers.film(SCENE, SMALL),
            Renderers.film(Renderers.withShortcuts(SCENE, SMALL, EnumSet.complementOf(EnumSet.of(shortcut)))));
    }

    @Test
    void whenAPixelIsReplayed() {
        Film film = Renderers.film(SCENE, SMALL);
        assertEquals(film.get(7, 11), Renderers.pixel(Renderers.of(SCENE, SMALL), 7, 11));
    }

    /** What is gathered at the places is the same; only how far apart the pixels lie is not. */
    @Test
    void forPicturesOfTheSameShape() {
        Color small = Renderers.of(SCENE, SMALL.withSize(90, 60)).ambientLight().mean();
        Color large = Renderers.of(SCENE, SMALL.withSize(180, 120)).ambientLight().mean();
        assertEquals(small.red(), large.red(), 1e-9);
        assertEquals(small.green(), large.green(), 1e-9);
        assertEquals(small.blue(), large.blue(), 1e-9);
    }

    /** What is looked at, at most: as many places as the picture has pixels, each along its longer edge. */
    @ParameterizedTest
    @CsvSource({"1, 1, 16", "4, 3, 16", "16, 5, 256", "5, 16, 256"})
    void butNotForTinyOnesWhichHaveNoMorePlacesThanPixels(int width, int height, int most) {
        AmbientLight light = Renderers.of(SCENE, SMALL.withSize(width, height)).ambientLight();
        assertTrue(light.recordCount() > 0 && light.recordCount() <= most, light.recordCount() + " places");
    }

    @Test
    void butNotForOtherSeeds() {
        Color one = Renderers.of(SCENE, SMALL).ambientLight().mean();
        Color other = Renderers.of(SCENE, SMALL.withSeed(2)).ambientLight().mean();
        assertNotEquals(one, other);
        assertEquals(1, one.red() / other.red(), 0.05);
    }
}
