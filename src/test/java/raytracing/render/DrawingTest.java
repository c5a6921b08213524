package raytracing.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.FutureTask;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.Patience;
import raytracing.SceneText;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.render.Cancellation.Leftovers;
import raytracing.scene.Scene;
import raytracing.shade.RayCounts;

class DrawingTest {
    private static final Scene SCENE = RendererTest.SCENE;
    private static final int WIDTH = 61;
    private static final int HEIGHT = 47;

    private static RenderSettings settings(int root) {
        return RenderSettings.DEFAULT.withSize(WIDTH, HEIGHT).withWorkers(2, 8)
            .withSampling(new PixelGrid(root, PixelGrid.Where.EDGES));
    }

    private static Drawing drawing(RenderSettings settings, int bandHeight, Cancellation cancellation,
                                   Leftovers leftovers, DrawingListener listener) {
        return new Drawing(Renderers.of(SCENE, settings), bandHeight, cancellation, leftovers, listener);
    }

    /** Begins at the top, on the left, in the middle; ends at the corner; is a single pixel. */
    @ParameterizedTest(name = "{0}, {1}, {2} x {3} with {4} x {4} rays")
    @CsvSource({"0, 0, 61, 20, 1", "0, 13, 61, 20, 3", "17, 9, 30, 21, 1", "17, 9, 30, 21, 3", "40, 30, 21, 17, 2",
        "33, 25, 1, 1, 3"})
    void aRegionHasThePixelsOfTheWhole(int x, int y, int width, int height, int root) {
        Film whole = Renderers.film(SCENE, settings(root));
        Region region = new Region(x, y, x + width, y + height);
        Film part = Renderers.film(SCENE, settings(root).withRegion(region));
        RendererTest.assertSamePixels(whole.part(x, y, width, height), part);
    }

    /** Ambient light is estimated from the whole picture. */
    @Test
    void aRegionHasTheAmbientLightOfTheWhole() {
        Scene room = SceneText.scene("cam 0 1 -3  0 1 0  0 1 0  1 2", "set 0.9 0.8 0.7 1 1",
            "mtl 0.5 0.7 0.9  0 0 0  0 0 0  1 0  0.5 0.7 0.9", "pln 0 1 0 0 1", "sph 0 1 1  1 1", "box 2 0.5 1  1 1");
        RenderSettings settings = RenderSettings.DEFAULT.withSize(40, 40);
        Film whole = Renderers.film(room, settings);
        Film part = Renderers.film(room, settings.withRegion(new Region(20, 10, 33, 40)));
        RendererTest.assertSamePixels(whole.part(20, 10, 13, 30), part);
    }

    @ParameterizedTest(name = "bands of {0} rows, {1} x {1} rays")
    @CsvSource({"1, 1", "16, 1", "46, 1", "1, 3", "16, 3", "47, 3"})
    void bandsTogetherAreThePicture(int bandHeight, int root) {
        Film whole = Renderers.film(SCENE, settings(root));
        Drawing drawing =
            drawing(settings(root), bandHeight, new Cancellation(), Leftovers.DISCARD, DrawingListener.NONE);
        for (int i = 0; i < drawing.count(); i++) {
            Film band = drawing.band(i);
            RendererTest.assertSamePixels(whole.part(0, i * bandHeight, WIDTH, band.height()), band);
        }
        assertEquals(1, drawing.progress().share());
    }

    /** A signal may come while a band is written into the file, which may take longer than a signal waits for nothing. */
    @Test
    void aPictureToBeKeptIsAwaitedBetweenItsBandsToo() throws Exception {
        Cancellation cancellation = new Cancellation();
        Drawing drawing = drawing(settings(1), 16, cancellation, Leftovers.KEEP, DrawingListener.NONE);
        drawing.band(0);
        FutureTask<Boolean> wait = new FutureTask<>(() -> cancellation.awaitEnd(1));
        Thread thread = new Thread(wait);
        thread.setDaemon(true);
        thread.start();
        Patience.await("wait without a limit", () -> wait.isDone() || thread.getState() == Thread.State.WAITING);
        cancellation.request();
        drawing.band(1);
        assertTrue(wait.get());
    }

    @ParameterizedTest(name = "{0} x {1} with tiles of {2}: {3}")
    @CsvSource({"500, 500, 16, 500", "2048, 2048, 16, 2048", "2048, 2049, 16, 2048", "1000, 4194, 16, 4194",
        "3, 1398101, 16, 1398101", "3000, 3000, 16, 1392", "30000, 30000, 16, 128",
        "4194304, 7, 16, 1", "1000000, 7, 16, 4", "700000000, 2, 16, 1"})
    void aBandIsTheWholePictureOrWholeTilesWithinTheBound(int width, int height, int tileSize, int expected) {
        assertEquals(expected, Drawing.bandHeight(Region.whole(width, height), tileSize));
    }

    /** Cancels as soon as some tiles are finished, from the thread that finished them. */
    private static final class Impatient implements DrawingListener {
        private final Cancellation cancellation;
        private final AtomicInteger left;
        private final List<Region> shown = new ArrayList<>();

        Impatient(Cancellation cancellation, int tiles) {
            this.cancellation = cancellation;
            left = new AtomicInteger(tiles);
        }

        @Override
        public synchronized void showTile(Region tile, Film film, Region filmed) {
            shown.add(tile);
            if (left.decrementAndGet() == 0) {
                cancellation.request();
            }
        }
    }

    @Test
    void aCancelledDrawingHasNoPicture() {
        Cancellation cancellation = new Cancellation();
        Drawing drawing = drawing(settings(1), HEIGHT, cancellation, Leftovers.DISCARD, new Impatient(cancellation, 3));
        assertThrows(CancelledException.class, () -> drawing.band(0));
        assertTrue(drawing.progress().share() > 0 && drawing.progress().share() < 1);
    }

    /** With smooth edges, nothing is finished in the first pass. */
    @ParameterizedTest
    @CsvSource({"1, 5", "3, 53"})
    void whatIsKeptIsRightAndTheRestIsGaps(int root, int tilesShown) {
        Film whole = Renderers.film(SCENE, settings(root));
        Cancellation cancellation = new Cancellation();
        Impatient listener = new Impatient(cancellation, tilesShown);
        Drawing drawing = drawing(settings(root), HEIGHT, cancellation, Leftovers.KEEP, listener);
        Film film = drawing.band(0);
        assertTrue(drawing.isPartial());
        assertTrue(film.hasGaps());
        int kept = 0;
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                if (!film.isGap(x, y)) {
                    assertEquals(whole.get(x, y), film.get(x, y));
                    kept++;
                } else {
                    assertEquals(SCENE.settings().background(), film.get(x, y));
                }
            }
        }
        assertTrue(kept > 0 && kept < WIDTH * HEIGHT, "pixels kept: " + kept);
    }

    @Test
    void theFirstPassOfSmoothEdgesFinishesNothing() {
        Cancellation cancellation = new Cancellation();
        Drawing drawing = drawing(settings(3), HEIGHT, cancellation, Leftovers.KEEP, new Impatient(cancellation, 5));
        assertThrows(CancelledException.class, () -> drawing.band(0));
    }

    @Test
    void bandsAfterTheCancelledOneAreGapsOnly() {
        Cancellation cancellation = new Cancellation();
        // One thread, so that the tiles are finished in their order, the one at the corner first.
        Drawing drawing = drawing(settings(1).withWorkers(1, 8), 16, cancellation, Leftovers.KEEP,
            new Impatient(cancellation, 12));
        assertFalse(drawing.band(0).isGap(0, 0));
        drawing.band(1);
        Film last = drawing.band(2);
        assertTrue(last.isGap(0, 0) && last.isGap(WIDTH - 1, last.height() - 1));
    }

    @Test
    void aCancellationAfterTheLastTileComesTooLate() {
        Cancellation cancellation = new Cancellation();
        Drawing drawing = drawing(settings(1), HEIGHT, cancellation, Leftovers.DISCARD, DrawingListener.NONE);
        Film film = drawing.band(0);
        cancellation.request();
        assertFalse(film.hasGaps() || drawing.isPartial());
    }

    /** The answer to a signal must not wait for pixels of any length. */
    @Test
    void aSlowPixelIsNotWaitedFor() {
        CountDownLatch endOfTest = new CountDownLatch(1);
        Cancellation cancellation = new Cancellation();
        DrawingListener asleep = new DrawingListener() {
            @Override
            public void showTile(Region tile, Film film, Region filmed) {
                cancellation.request();
                await(endOfTest);
            }
        };
        Drawing drawing = drawing(settings(1).withWorkers(1, 8), HEIGHT, cancellation, Leftovers.DISCARD, asleep);
        assertThrows(CancelledException.class, () -> drawing.band(0));
        endOfTest.countDown();
    }

    /** Also those of a thread that is not waited for. */
    @Test
    void aStoppedPictureCountsTheRaysOfItsFinishedTiles() {
        CountDownLatch endOfTest = new CountDownLatch(1);
        Cancellation cancellation = new Cancellation();
        List<Region> shown = new ArrayList<>();
        DrawingListener asleep = new DrawingListener() {
            @Override
            public void showTile(Region tile, Film film, Region filmed) {
                shown.add(tile);
                if (shown.size() == 3) {
                    cancellation.request();
                    await(endOfTest);
                }
            }
        };
        Drawing drawing = drawing(settings(1).withWorkers(1, 8), HEIGHT, cancellation, Leftovers.KEEP, asleep);
        drawing.band(0);
        endOfTest.countDown();
        long pixels = shown.stream().mapToLong(Region::pixelCount).sum();
        assertEquals(pixels, drawing.counts().eye());
        assertEquals(pixels, drawing.progress().finished());
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException unexpected) {
            throw new AssertionError(unexpected);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void aListenerIsShownEveryPixelAsItIsInTheEnd(int root) {
        Film shown = new Film(WIDTH, HEIGHT);
        DrawingListener copying = new DrawingListener() {
            @Override
            public int[] coarseLooks() {
                return new int[] {16, 4};
            }

            @Override
            public synchronized void showSquare(Region square, Color light) {
                shown.set(square.left(), square.top(), light.red(), light.green(), light.blue());
            }

            @Override
            public synchronized void showTile(Region tile, Film film, Region filmed) {
                for (int y = tile.top(); y < tile.bottom(); y++) {
                    for (int x = tile.left(); x < tile.right(); x++) {
                        Color light = film.get(x - filmed.left(), y - filmed.top());
                        shown.set(x, y, light.red(), light.green(), light.blue());
                    }
                }
            }
        };
        Drawing drawing = drawing(settings(root), 16, new Cancellation(), Leftovers.DISCARD, copying);
        for (int i = 0; i < drawing.count(); i++) {
            drawing.band(i);
        }
        RendererTest.assertSamePixels(Renderers.film(SCENE, settings(root)), shown);
    }

    /** Every square of a coarse look is a pixel in its middle. */
    @Test
    void coarseLooksShowPixelsOfThePicture() {
        Renderer renderer = Renderers.of(SCENE, settings(1));
        List<Region> squares = new ArrayList<>();
        DrawingListener checking = new DrawingListener() {
            @Override
            public int[] coarseLooks() {
                return new int[] {16};
            }

            @Override
            public synchronized void showSquare(Region square, Color light) {
                squares.add(square);
                assertEquals(Renderers.pixel(renderer, (square.left() + square.right()) / 2,
                    (square.top() + square.bottom()) / 2), light);
            }

            @Override
            public void showTile(Region tile, Film film, Region filmed) {
                // looked at elsewhere
            }
        };
        drawing(settings(1), HEIGHT, new Cancellation(), Leftovers.DISCARD, checking).band(0);
        assertEquals(4 * 3, squares.size());
    }

    /** A floor seen everywhere, one light with 3 x 3 rays and a hard one: numbers that follow from the scene. */
    @Test
    void raysAreCounted() {
        Scene scene = SceneText.scene("cam 0 5 0  0 0 0  0 0 1  1 0.1", "set 0 0 0 3 5",
            "mtl 1 1 1  0 0 0  0.5 0.5 0.5  1 0", "pln 0 1 0 0 1", "sph 0 2 0 0.001 1",
            "lgt 0 5 0.5  1 1 1  1 1 0", "lgt 0 -5 0  1 1 1  1 1 1", "lgt 0 9 0  1 1 1  1 0 1");
        RenderSettings settings = RenderSettings.DEFAULT.withSize(10, 10);
        Renderer renderer = Renderers.of(scene, settings);
        Drawing drawing = new Drawing(renderer, new Cancellation(), Leftovers.DISCARD, DrawingListener.NONE);
        drawing.band(0);
        RayCounts counts = drawing.counts();
        assertEquals(100, counts.eye());
        assertEquals(100, counts.mirrored(), "each meets the floor once, and the sky after that");
        assertEquals(0, counts.mirroredLeftOut());
        assertEquals(100, counts.surfacesMet());
        assertEquals(300, counts.lightsAtPoints());
        assertEquals(200, counts.shadowQueries(), "the second light is below the floor");
        assertEquals(100, counts.lightsSettled(), "the third light casts no shadow");
        assertEquals(100, counts.shadowRays());
        assertEquals(0, counts.shadowAreas());
    }
}
