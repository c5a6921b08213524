package raytracing.render;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.render.PixelGrid.Where;

class ProgressTest {
    private static final long PIXELS = 1000;

    @Test
    void withOneRayItIsTheShareOfThePixels() {
        Progress progress = new Progress(PIXELS, PixelGrid.ONE_RAY);
        assertEquals(0, progress.share());
        progress.addFirstRays(250);
        assertEquals(0.25, progress.share());
        assertEquals(250, progress.finished());
    }

    /** 1000 rays of the first pass; 16 for each of the tenth that is refined, of which half is done: 1800 of 2600. */
    @Test
    void withSmoothEdgesItIsTheShareOfTheRaysThatAreExpected() {
        Progress progress = new Progress(PIXELS, new PixelGrid(4, Where.EDGES));
        progress.addFirstRays(PIXELS);
        progress.addSmoothed(500, 50, 16 * 50);
        assertEquals(1800.0 / 2600, progress.share(), 1e-15);
        assertEquals(500, progress.finished());
        assertEquals(50, progress.refined());
    }

    @Test
    void beforeTheFirstEdgeATypicalShareOfThemIsExpected() {
        Progress progress = new Progress(PIXELS, new PixelGrid(2, Where.EDGES));
        progress.addFirstRays(500);
        assertEquals(500.0 / (1000 + 4 * 150), progress.share(), 1e-15);
    }

    @Test
    void everywhereThereIsNoFirstPass() {
        Progress progress = new Progress(PIXELS, new PixelGrid(3, Where.EVERYWHERE));
        progress.addSmoothed(400, 400, 9 * 400);
        assertEquals(0.4, progress.share(), 1e-15);
    }

    /** Exactly: 29,250 edges, as a share of all pixels and back again, are a few less by rounding. */
    @ParameterizedTest
    @ValueSource(longs = {0, 1, 123, 29_250, 64_000, 250_000})
    void atTheEndItIsOne(long edges) {
        Progress progress = new Progress(250_000, new PixelGrid(3, Where.EDGES));
        progress.addFirstRays(250_000);
        progress.addSmoothed(250_000, edges, 9 * edges);
        assertEquals(1, progress.share());
    }
}
