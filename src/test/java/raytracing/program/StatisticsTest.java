package raytracing.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import org.junit.jupiter.api.Test;
import raytracing.SceneText;
import raytracing.film.Film;
import raytracing.render.Cancellation;
import raytracing.render.Drawing;
import raytracing.render.DrawingListener;
import raytracing.render.ErrorLimit;
import raytracing.render.PixelGrid;
import raytracing.render.Region;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.render.Renderers;
import raytracing.scene.Scene;

class StatisticsTest {
    private static final Scene SCENE = SceneText.scene("cam 0 1 -3  0 0 0  0 1 0  1 1", "set 0.2 0.5 1  3 4",
        "mtl 0.5 0.5 0.5  0 0 0  0.5 0.5 0.5  1 0", "mtl 0 0 0  0 0 0  0.9 0.9 0.9  1 0", "pln 0 1 0  0  1",
        "sph 0 0.5 0  0.5  2", "lgt 0 9 0  1 1 1  1 1 2");
    private static final RenderSettings SETTINGS = RenderSettings.DEFAULT.withSize(32, 24).withWorkers(1, 8);
    private static final int TILES = 4 * 3;

    private static JsonObject statistics(Scene scene, RenderSettings settings, Cancellation cancellation,
                                         DrawingListener listener) {
        Renderer renderer = Renderers.of(scene, settings);
        Drawing drawing = new Drawing(renderer, cancellation, Cancellation.Leftovers.KEEP, listener);
        drawing.band(0);
        return JsonParser.parseString(new Statistics("scene.txt", scene, settings, renderer, drawing,
            new Statistics.Times(1, 2, 3)).json()).getAsJsonObject();
    }

    private static JsonObject statistics(RenderSettings settings) {
        return statistics(SCENE, settings, new Cancellation(), DrawingListener.NONE);
    }

    /** Stops the drawing when this tile is shown, counted from 1. */
    private static JsonObject stoppedAt(int tile, RenderSettings settings) {
        Cancellation cancellation = new Cancellation();
        return statistics(SCENE, settings, cancellation, new DrawingListener() {
            private int shown;

            @Override
            public void showTile(Region drawn, Film film, Region filmed) {
                if (++shown == tile) {
                    cancellation.request();
                }
            }
        });
    }

    @Test
    void ofAFinishedPictureAllIsDrawn() {
        assertEquals("1.0", statistics(SETTINGS).getAsJsonObject("picture").get("share_drawn").toString());
    }

    @Test
    void ofAStoppedPictureTheShareOfItsPixelsIsDrawn() {
        JsonObject statistics = stoppedAt(3, SETTINGS);
        assertEquals(3.0 / TILES, statistics.getAsJsonObject("picture").get("share_drawn").getAsDouble());
        assertEquals(3 * 64, statistics.getAsJsonObject("rays").get("from_the_eye").getAsLong());
    }

    /** One ray in every pixel is most of the work, and finishes none. */
    @Test
    void withSmoothEdgesAPixelIsDrawnAfterTheSecondPass() {
        JsonObject statistics =
            stoppedAt(TILES + 3, SETTINGS.withSampling(new PixelGrid(2, PixelGrid.Where.EDGES)));
        assertEquals(3.0 / TILES, statistics.getAsJsonObject("picture").get("share_drawn").getAsDouble());
    }

    @Test
    void underAnErrorLimitPixelsAreCountedByTheirRays() {
        JsonObject error = statistics(SETTINGS.withSampling(new ErrorLimit(2))).getAsJsonObject("error");
        assertEquals(2, error.get("limit").getAsDouble());
        long pixels = error.get("pixels_with_1_ray").getAsLong();
        for (int rays = 4; rays <= 4096; rays *= 2) {
            pixels += error.get("pixels_with_" + rays + "_rays").getAsLong();
        }
        assertEquals(32 * 24, pixels);
        double estimate = error.get("estimate").getAsDouble();
        assertTrue(estimate > 0 && estimate <= error.get("largest_estimate").getAsDouble(), error.toString());
        assertTrue(error.get("largest_estimate").getAsDouble() <= 2, error.toString());
    }

    @Test
    void withoutAnErrorLimitNoErrorIsClaimed() {
        assertFalse(statistics(SETTINGS).has("error"));
    }

    /** The lamp is beside the eye: the mirror faces it everywhere, and has no colour of its own. */
    @Test
    void aMirrorShowsNoLightOfALamp() {
        Scene mirror = SceneText.scene("cam 0 0 -3  0 0 0  0 1 0  1 1", "set 0 0 0  3 4",
            "mtl 0 0 0  0 0 0  0.9 0.9 0.9  1 0", "sph 0 0 0  0.5  1", "lgt 0 0 -3.1  1 1 1  1 1 2");
        JsonObject culled = statistics(mirror, SETTINGS, new Cancellation(), DrawingListener.NONE).getAsJsonObject("culled");
        assertEquals(1, culled.get("lights_that_a_surface_does_not_show").getAsDouble());
    }
}
