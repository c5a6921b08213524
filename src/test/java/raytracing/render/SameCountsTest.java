package raytracing.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.SceneText;
import raytracing.render.Cancellation.Leftovers;
import raytracing.render.PixelGrid.Where;
import raytracing.scene.Scene;
import raytracing.shade.RayCounts;
import raytracing.shadow.ShadowMethod;

/** How many rays a picture takes depends on the picture, not on the threads that draw it, or on chance. */
class SameCountsTest {
    private static final int SIZE = 48;
    private static final int TILE = 8;
    private static final int LARGE_TILE = 16;

    /** So many balls of plaster, mirror and glass on a floor, under two wide lamps; from 48 on, a hierarchy finds them. */
    private static Scene crowd(int balls) {
        StringBuilder lines = new StringBuilder("""
            cam 0 4 -9  0 0.5 0  0 1 0  1 1
            set 0.3 0.5 0.9  3 4
            mtl 0.7 0.6 0.5  0 0 0  0 0 0  1 0  0.7 0.6 0.5
            mtl 0.2 0.2 0.2  0.5 0.5 0.5  0.7 0.7 0.7  20 0
            mtl 0.1 0.3 0.2  0.5 0.5 0.5  0.1 0.1 0.1  20 0.7
            pln 0 1 0  0  1
            lgt 6 8 -3  1 0.9 0.8  1 1 2
            lgt -7 5 2  0.4 0.5 0.8  1 0.8 3
            """);
        Random random = new Random(1);
        for (int i = 0; i < balls; i++) {
            lines.append(String.format("sph %.3f %.3f %.3f  %.3f  %d%n", 8 * random.nextDouble() - 4,
                2 * random.nextDouble(), 6 * random.nextDouble() - 3, 0.1 + 0.3 * random.nextDouble(), 1 + i % 3));
        }
        return SceneText.scene(lines.toString());
    }

    private record Picture(String name, Scene scene, RenderSettings settings) {
        @Override
        public String toString() {
            return name;
        }

        /** All that {@code --stats} counts while it draws, in two bands. */
        List<Object> figures(int threads) {
            RenderSettings these = settings.withWorkers(threads, TILE);
            Renderer renderer = Renderers.of(scene, these);
            Drawing drawing =
                new Drawing(renderer, 32, new Cancellation(), Leftovers.DISCARD, DrawingListener.NONE);
            drawing.band(0);
            drawing.band(1);
            return List.of(drawing.counts(), drawing.progress().refined(), renderer.ambientLight().pathCount());
        }
    }

    static Stream<Picture> pictures() {
        RenderSettings settings = RenderSettings.DEFAULT.withSize(SIZE, SIZE);
        return Stream.of(
            new Picture("balls one by one", crowd(40), settings),
            new Picture("a hierarchy of balls", crowd(150), settings),
            new Picture("smooth edges", crowd(150), settings.withSampling(new PixelGrid(2, Where.EDGES))),
            new Picture("many rays everywhere", crowd(150), settings.withSampling(new PixelGrid(2, Where.EVERYWHERE))),
            new Picture("exact shadows", crowd(150), settings.withShadowMethod(new ShadowMethod.Exact())),
            new Picture("many shadow rays", crowd(150), settings.withShadowMethod(ShadowMethod.Sampled.withRoot(5))),
            new Picture("hard shadows", crowd(150), settings.withShadowMethod(ShadowMethod.Sampled.withRoot(1))));
    }

    @ParameterizedTest
    @MethodSource("pictures")
    void everyNumberOfThreadsCountsTheSame(Picture picture) {
        List<Object> expected = picture.figures(1);
        for (int threads : new int[] {2, 2, 3, 8}) {
            assertEquals(expected, picture.figures(threads), threads + " threads");
        }
    }

    /** A thread that has just drawn other tiles takes as many rays for a tile as one that begins with it. */
    @Test
    void aTileTakesTheSameWhateverWasDrawnBefore() {
        Scene scene = crowd(300);
        RenderSettings settings = RenderSettings.DEFAULT.withSize(SIZE, SIZE).withWorkers(1, LARGE_TILE);
        RayCounts sum = RayCounts.NONE;
        for (int y = 0; y < SIZE; y += LARGE_TILE) {
            for (int x = 0; x < SIZE; x += LARGE_TILE) {
                sum = sum.plus(counts(scene, settings.withRegion(new Region(x, y, x + LARGE_TILE, y + LARGE_TILE))));
            }
        }
        RayCounts whole = counts(scene, settings);
        assertEquals(sum, whole);
        assertTrue(whole.lightsSettled() > 0 && whole.mirrored() > 0, whole.toString());
    }

    private static RayCounts counts(Scene scene, RenderSettings settings) {
        Drawing drawing =
            new Drawing(Renderers.of(scene, settings), new Cancellation(), Leftovers.DISCARD, DrawingListener.NONE);
        drawing.band(0);
        return drawing.counts();
    }
}
