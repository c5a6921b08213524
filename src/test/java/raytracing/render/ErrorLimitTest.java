package raytracing.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.SceneText;
import raytracing.film.Film;
import raytracing.scene.Scene;
import raytracing.shadow.ShadowMethod;

/** Pictures under an error limit. In most a black thing stands before a sky of one colour, and there is no lamp. */
class ErrorLimitTest {
    private static final double STEP = 1 / 255.0;

    /** The eye is 1 away from a screen 2 wide. */
    private static final String EYE = "cam 0 0 0  0 0 1  0 1 0  1 2";
    private static final String BLACK = "mtl 0 0 0  0 0 0  0 0 0  1 0";

    private static RenderSettings settings(int size, double steps) {
        return RenderSettings.DEFAULT.withSize(size, size).withShadowMethod(new ShadowMethod.Exact())
            .withSampling(new ErrorLimit(steps));
    }

    private static Film film(Scene scene, int size, double steps) {
        return Renderers.film(scene, settings(size, steps));
    }

    private static ErrorTally errors(Scene scene, RenderSettings settings) {
        Drawing drawing = new Drawing(Renderers.of(scene, settings), new Cancellation(), Cancellation.Leftovers.DISCARD,
            DrawingListener.NONE);
        drawing.band(0);
        return drawing.errors();
    }

    /** Balls of plaster, mirror and glass on a floor, under a wide lamp and one that casts hard shadows. */
    private static Scene mixed() {
        StringBuilder lines = new StringBuilder("""
            cam 0 4 -9  0 0.5 0  0 1 0  1 1
            set 0.3 0.5 0.9  3 4
            mtl 0.7 0.6 0.5  0 0 0  0 0 0  1 0
            mtl 0.2 0.2 0.2  0.5 0.5 0.5  0.7 0.7 0.7  90 0
            mtl 0.1 0.3 0.2  0.5 0.5 0.5  0.1 0.1 0.1  20 0.7
            pln 0 1 0  0  1
            box -1.5 0.5 2  1  2
            lgt 6 8 -3  1 0.9 0.8  1 1 2
            lgt -7 5 2  0.4 0.5 0.8  1 0.8 0
            """);
        Random random = new Random(1);
        for (int i = 0; i < 12; i++) {
            lines.append(String.format("sph %.3f %.3f %.3f  %.3f  %d%n", 6 * random.nextDouble() - 3,
                2 * random.nextDouble(), 5 * random.nextDouble() - 2, 0.1 + 0.3 * random.nextDouble(), 1 + i % 3));
        }
        return SceneText.scene(lines.toString());
    }

    /** A black wall covers a share of one column of pixels: the sky's share of them is right to the limit. */
    @ParameterizedTest(name = "{0} of the pixel, {1} steps")
    @CsvSource({"0.5, 1", "0.3, 1", "0.03, 1", "0.97, 1", "0.3, 0.25", "0.01, 0.25", "0.62, 8"})
    void theEdgeOfAFaceCoversItsPixelsToTheLimit(double share, double steps) {
        int size = 10;
        double edge = -1 + (7 + share) * 2 / size;
        Scene scene = SceneText.scene(EYE, "set 0.9 0.9 0.9 1 1", BLACK, "box " + (edge - 8) + " 0 9  16 1");
        Film film = film(scene, size, steps);
        for (int y = 0; y < size; y++) {
            assertEquals(0, film.get(6, y).green());
            assertEquals(0.9 * (1 - share), film.get(7, y).green(), 2 * steps * STEP);
            assertEquals(0.9, film.get(8, y).green(), 1e-12);
        }
    }

    /** The same wall of two triangles, whose common edge is not seen. */
    @ParameterizedTest(name = "{0} of the pixel, {1} steps")
    @CsvSource({"0.5, 1", "0.03, 1", "0.3, 0.25", "0.62, 8"})
    void theEdgeOfATriangleCoversItsPixelsToTheLimit(double share, double steps) {
        int size = 10;
        double edge = -1 + (7 + share) * 2 / size;
        Scene scene = SceneText.scene(EYE, "set 0.9 0.9 0.9 1 1", BLACK,
            "trg -9 -9 1  " + edge + " -9 1  " + edge + " 9 1  1", "trg -9 -9 1  " + edge + " 9 1  -9 9 1  1");
        Film film = film(scene, size, steps);
        for (int y = 0; y < size; y++) {
            for (int x = 0; x < 7; x++) {
                assertEquals(0, film.get(x, y).green());
            }
            assertEquals(0.9 * (1 - share), film.get(7, y).green(), 2 * steps * STEP);
            assertEquals(0.9, film.get(8, y).green(), 1e-12);
        }
    }

    /** A triangle as large as a twentieth of a pixel, that no first ray meets: half of a square, face on. */
    @ParameterizedTest(name = "at {0}, {1} of a pixel")
    @CsvSource({"0.2, 0.3", "0.7, 0.9", "0.4, 0.6", "0.25, 0.75"})
    void aTinyTriangleThatNoFirstRayMeetsIsSeen(double right, double down) {
        int size = 10;
        double pixel = 2.0 / size;
        double edge = 0.1 * pixel;
        double x = -1 + (4 + right) * pixel;
        double y = 1 - (5 + down) * pixel;
        Scene scene = SceneText.scene(EYE, "set 1 1 1 1 1", BLACK, "trg " + x + " " + y + " 1  " + (x + edge) + " " + y + " 1  "
            + x + " " + (y + edge) + " 1  1");
        Film film = film(scene, size, 1);
        double dark = 0;
        for (int row = 4; row < 8; row++) {
            for (int column = 3; column < 7; column++) {
                dark += 1 - film.get(column, row).green();
            }
        }
        assertEquals(0.1 * 0.1 / 2, dark, 1.0 * STEP);
    }

    /** Each ray's light is cut off at white: half of the pixel is sky, 50 times as bright, and the pixel is half white. */
    @Test
    void lightIsCutOffAtWhiteBeforeTheMean() {
        double edge = -1 + 7.5 * 2 / 10;
        Scene scene = SceneText.scene(EYE, "set 50 50 50 1 1", BLACK, "box " + (edge - 8) + " 0 9  16 1");
        assertEquals(0.5, film(scene, 10, 1).get(7, 5).green(), 2 * STEP);
    }

    /**
     * A ball of a twentieth of a pixel covers 2 steps of it. No first ray meets it, wherever it is, and yet it is seen: all of
     * its light is in the pixels around it.
     */
    @ParameterizedTest(name = "at {0}, {1} of a pixel")
    @CsvSource({"0.2, 0.3", "0.7, 0.9", "0.95, 0.1", "0.4, 0.6", "0.99, 0.99", "0.25, 0.75"})
    void aSpeckThatNoFirstRayMeetsIsSeen(double right, double down) {
        int size = 10;
        double pixel = 2.0 / size;
        double radius = 0.05 * pixel;
        double x = -1 + (4 + right) * pixel;
        double y = 1 - (5 + down) * pixel;
        Scene scene = SceneText.scene(EYE, "set 1 1 1 1 1", BLACK,
            "sph " + 100 * x + " " + 100 * y + " 100 " + 100 * radius + " 1");
        Film film = film(scene, size, 1);
        double dark = 0;
        for (int row = 4; row < 8; row++) {
            for (int column = 3; column < 7; column++) {
                dark += 1 - film.get(column, row).green();
            }
        }
        double stretched = Math.pow(1 + x * x + y * y, 1.5);     // a small disc's image on the screen, away from its middle
        assertEquals(Math.PI * 0.05 * 0.05, dark / stretched, 1.0 * STEP);
    }

    /** The same speck behind a wall of glass, which has no edge in the picture. */
    @Test
    void aSpeckBehindGlassIsSeen() {
        Scene scene = SceneText.scene(EYE, "set 1 1 1 1 1", BLACK, "mtl 0 0 0  0 0 0  0 0 0  1 0.9",
            "pln 0 0 1  50  2", "sph 7 5 100  0.6  1");
        Film film = film(scene, 11, 0.5);
        double least = 1;
        for (int y = 0; y < 11; y++) {
            for (int x = 0; x < 11; x++) {
                least = Math.min(least, film.get(x, y).green());
            }
        }
        assertTrue(least < 0.9 - 0.5 * STEP, "darkest pixel " + least);
    }

    static Stream<RenderSettings> otherWorkers() {
        RenderSettings settings = settings(40, 2);
        return Stream.of(settings.withWorkers(1, 16), settings.withWorkers(3, 7), settings.withWorkers(64, 5),
            settings.withWorkers(2, 40));
    }

    @ParameterizedTest
    @MethodSource("otherWorkers")
    void threadsAndTilesChangeNoBit(RenderSettings settings) {
        Scene scene = mixed();
        assertSame(film(scene, 40, 2), Renderers.film(scene, settings), 0, 0);
    }

    /** Rectangles at the border and inside, one of them a single pixel: a pixel may be drawn again alone. */
    @ParameterizedTest
    @CsvSource({"0, 0, 40, 17", "11, 13, 12, 14", "39, 39, 40, 40", "16, 16, 32, 32", "0, 20, 1, 21", "7, 3, 38, 33"})
    void aRegionHasThePixelsOfTheWholePicture(int left, int top, int right, int bottom) {
        Scene scene = mixed();
        Film part = Renderers.film(scene, settings(40, 2).withRegion(new Region(left, top, right, bottom)));
        assertSame(film(scene, 40, 2), part, left, top);
    }

    private static void assertSame(Film whole, Film part, int left, int top) {
        for (int y = 0; y < part.height(); y++) {
            for (int x = 0; x < part.width(); x++) {
                assertEquals(whole.get(left + x, top + y), part.get(x, y), (left + x) + ", " + (top + y));
            }
        }
    }

    @Test
    void bandsChangeNoBit() {
        Scene scene = mixed();
        Film whole = film(scene, 40, 2);
        Drawing drawing = new Drawing(Renderers.of(scene, settings(40, 2)), 13, new Cancellation(),
            Cancellation.Leftovers.DISCARD, DrawingListener.NONE);
        for (int band = 0; band < drawing.count(); band++) {
            Film part = drawing.band(band);
            for (int y = 0; y < part.height(); y++) {
                for (int x = 0; x < part.width(); x++) {
                    assertEquals(whole.get(x, 13 * band + y), part.get(x, y));
                }
            }
        }
    }

    /** The first rays of 42 x 42 pixels take 36 tiles; then a pixel is final, or a gap. */
    @Test
    void whatAStoppedPictureKeepsIsFinal() {
        Scene scene = mixed();
        Film whole = film(scene, 40, 2);
        Cancellation cancellation = new Cancellation();
        Drawing drawing = new Drawing(Renderers.of(scene, settings(40, 2).withWorkers(1, 8)), cancellation,
            Cancellation.Leftovers.KEEP, new DrawingListener() {
                private int shown;

                @Override
                public void showTile(Region tile, Film film, Region filmed) {
                    if (++shown == 36 + 5) {
                        cancellation.request();
                    }
                }
            });
        Film kept = drawing.band(0);
        int finished = 0;
        for (int i = 0; i < 1600; i++) {
            if (!kept.isGap(i % 40, i / 40)) {
                assertEquals(whole.get(i % 40, i / 40), kept.get(i % 40, i / 40), i % 40 + ", " + i / 40);
                finished++;
            }
        }
        assertEquals(5 * 64, finished);
        assertTrue(drawing.isPartial());
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5})
    void theTallyIsTheSameForAnyThreads(int threads) {
        ErrorTally expected = errors(mixed(), settings(40, 2).withWorkers(4, 16));
        ErrorTally tally = errors(mixed(), settings(40, 2).withWorkers(threads, 6));
        assertEquals(expected.error(), tally.error());
        assertEquals(expected.largest(), tally.largest());
        for (int level = 0; level < ErrorTally.levels(); level++) {
            assertEquals(expected.pixelsAt(level), tally.pixelsAt(level), ErrorTally.rays(level) + " rays");
        }
    }

    @Test
    void aSmallerLimitTakesMoreRaysAndLeavesASmallerError() {
        ErrorTally coarse = errors(mixed(), settings(40, 4));
        ErrorTally fine = errors(mixed(), settings(40, 0.5));
        assertTrue(fine.furtherRays() > 4 * coarse.furtherRays(), coarse.furtherRays() + ", " + fine.furtherRays());
        assertTrue(fine.error() < 0.5 && coarse.error() < 4 && fine.error() < coarse.error() / 3,
            coarse.error() + ", " + fine.error());
    }

    /** One colour needs one ray for each pixel, and has no error. */
    @Test
    void aPictureOfOneColourTakesOneRayForEachPixel() {
        ErrorTally tally = errors(SceneText.scene(EYE, "set 0.3 0.4 0.5 1 1", BLACK, "sph 0 0 -9 1 1"), settings(20, 1));
        assertEquals(400, tally.pixelsAt(0));
        assertEquals(0, tally.refined());
        assertEquals(0, tally.error());
    }

    /** Sampled shadows are noisy, so their pixels get more rays than exact ones. */
    @Test
    void noiseOfShadowsCountsAsError() {
        Scene scene = SceneText.scene("cam 0 4 -9  0 0.5 0  0 1 0  1 1", "set 0 0 0  2 1", "mtl 0.8 0.8 0.8  0 0 0  0 0 0  1 0",
            "pln 0 1 0  0  1", "sph 0 1 0  1  1", "lgt 3 7 -2  1 1 1  1 1 4");
        RenderSettings exact = settings(30, 2);
        RenderSettings sampled = exact.withShadowMethod(ShadowMethod.OF_THE_SCENE);
        long noisyRays = errors(scene, sampled).furtherRays();
        long cleanRays = errors(scene, exact).furtherRays();
        assertTrue(noisyRays > 1.1 * cleanRays, noisyRays + " rays with noise, " + cleanRays + " without");
        Film noisy = Renderers.film(scene, sampled);
        Film clean = Renderers.film(scene, exact);
        double squares = 0;
        for (int i = 0; i < 900; i++) {
            double difference = (noisy.get(i % 30, i / 30).green() - clean.get(i % 30, i / 30).green()) / STEP;
            squares += difference * difference;
        }
        assertTrue(Math.sqrt(squares / 900) < 2, "RMS of the difference " + Math.sqrt(squares / 900));
    }
}
