package raytracing.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.PictureDifference;
import raytracing.SceneText;
import raytracing.Steps;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.render.PixelGrid.Where;
import raytracing.scene.Scene;

/**
 * Pictures with N x N rays at edges. Many show black things before a sky of one colour, without a lamp: then the light
 * of a pixel is the sky's times the share of the pixel that is sky. Screens are 1 away from the eye and 2 wide.
 */
class SmoothEdgesTest {
    private static final int SIZE = 10;
    private static final String EYE = "cam 0 0 0  0 0 1  0 1 0  1 2";
    private static final String BLACK = "mtl 0 0 0  0 0 0  0 0 0  1 0";
    private static final double ROUNDING = 1e-12;

    private static RenderSettings settings(int size, int root, Where where) {
        return RenderSettings.DEFAULT.withSize(size, size).withSampling(new PixelGrid(root, where));
    }

    private static Rendering smooth(Scene scene, int size, int root) {
        return Rendering.of(Renderers.of(scene, settings(size, root, Where.EDGES)));
    }

    private static Film everywhere(Scene scene, int size, int root) {
        return Renderers.film(scene, settings(size, root, Where.EVERYWHERE));
    }

    private static Film oneRay(Scene scene, int size) {
        return Renderers.film(scene, RenderSettings.DEFAULT.withSize(size, size));
    }

    /**
     * The face of a large black cube lies in the screen. On its left it fills seven columns of pixels and a share of the
     * eighth, and all rows. The cube's other faces are hidden behind this one.
     */
    private static Scene wall(String up, double share, double sky) {
        double edge = -1 + (7 + share) * 2 / SIZE;
        return SceneText.scene("cam 0 0 0  0 0 1 " + up + " 1 2", "set " + (sky + " ").repeat(3) + "1 1", BLACK,
            "box " + (edge - 8) + " 0 9  16 1");
    }

    @ParameterizedTest(name = "N = {0}, {1} of the pixel")
    @CsvSource({"2, 0.3", "2, 0.77", "3, 0.1", "4, 0.5", "4, 0.3", "8, 0.03", "8, 0.61"})
    void theEdgeOfAFaceCoversItsPixelsToHalfARay(int root, double share) {
        Film film = smooth(wall("0 1 0", share, 0.5), SIZE, root).film();
        for (int y = 0; y < SIZE; y++) {
            assertEquals(0, film.get(6, y).green());
            assertEquals(0.5 * (1 - share), film.get(7, y).green(), 0.5 / (2 * root * root) + ROUNDING);
            assertEquals(0.5, film.get(8, y).green());
        }
    }

    @ParameterizedTest(name = "N = {0}, {1} of the pixel")
    @CsvSource({"2, 0.3", "2, 0.77", "3, 0.1", "4, 0.5", "4, 0.3", "8, 0.03", "8, 0.61"})
    void anEdgeThatLiesAcrossDoesToo(int root, double share) {
        Film film = smooth(wall("1 0 0", share, 0.5), SIZE, root).film();
        for (int x = 0; x < SIZE; x++) {
            assertEquals(0.5 * (1 - share), film.get(x, 2).green(), 0.5 / (2 * root * root) + ROUNDING);
        }
    }

    /** The same wall of two triangles, whose common edge is not seen. */
    @ParameterizedTest(name = "N = {0}, {1} of the pixel")
    @CsvSource({"2, 0.3", "3, 0.1", "4, 0.5", "8, 0.61"})
    void theEdgeOfATriangleDoesToo(int root, double share) {
        double edge = -1 + (7 + share) * 2 / SIZE;
        Scene scene = SceneText.scene(EYE, "set 0.5 0.5 0.5 1 1", BLACK,
            "trg -9 -9 1  " + edge + " -9 1  " + edge + " 9 1  1", "trg -9 -9 1  " + edge + " 9 1  -9 9 1  1");
        Film film = smooth(scene, SIZE, root).film();
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < 7; x++) {
                assertEquals(0, film.get(x, y).green());
            }
            assertEquals(0.5 * (1 - share), film.get(7, y).green(), 0.5 / (2 * root * root) + ROUNDING);
            assertEquals(0.5, film.get(8, y).green());
        }
    }

    /** The sky is 50 times as bright as white, and the pixel still 0.7: a mean of 50 and 0 would be white. */
    @Test
    void lightIsCutOffAtWhiteBeforeTheMean() {
        Film film = smooth(wall("0 1 0", 0.3, 50), SIZE, 4).film();
        assertEquals(0.7, film.get(7, 5).green(), 1 / 32.0);
    }

    /**
     * The horizon of a black plane that leans to the side by an angle is a straight line across the picture. In a
     * column of pixels its height runs evenly from h to h', and the share of a pixel below it is the mean of
     * min(max(height, 0), 1): (F(h') - F(h)) / (h' - h), where F is the antiderivative. Measured: 0.019 to 0.041.
     */
    @ParameterizedTest(name = "{0} degrees")
    @ValueSource(doubles = {3, 10, 20, 30, 40, 44.5})
    void slantedEdgesOfFourByFourRaysAreTrueToATwentyFourthOfAPixel(double degrees) {
        int size = 100;
        double slope = Math.tan(Math.toRadians(degrees));
        double rise = 0.01234;
        Scene scene = SceneText.scene(EYE, "set 1 1 1 1 1", BLACK, "pln " + slope + " -1 " + rise + "  1 1");
        Film film = smooth(scene, size, 4).film();
        double squares = 0;
        int partial = 0;
        for (int y = 0; y < size; y++) {
            for (int x = 0; x < size; x++) {
                double left = (slope * (x * 2.0 / size - 1) + rise) * size / 2 - (size / 2.0 - y - 1);
                double below = (antiderivative(left + slope) - antiderivative(left)) / slope;
                double error = film.get(x, y).green() - (1 - below);
                squares += error * error;
                partial += below > ROUNDING && below < 1 - ROUNDING ? 1 : 0;
            }
        }
        assertTrue(partial >= size, "pixels on the edge: " + partial);
        assertEquals(0, Math.sqrt(squares / partial), 1 / 24.0);
    }

    private static double antiderivative(double height) {
        if (height <= 0) {
            return 0;
        }
        return height < 1 ? height * height / 2 : height - 0.5;
    }

    /** The circle in which a fisheye sees the sky has the radius of 90 degrees, 0.4 pi / 2, on a screen of area 4. */
    @Test
    void theBorderOfTheLensIsSmooth() {
        int size = 50;
        Scene scene = SceneText.scene("cam 0 0 0  0 0 1  0 1 0  0.4 2 true 0", "set 1 1 1 1 1");
        Film film = smooth(scene, size, 8).film();
        double area = 0;
        for (int y = 0; y < size; y++) {
            for (int x = 0; x < size; x++) {
                area += film.get(x, y).green() * 4 / (size * size);
            }
        }
        double radius = 0.4 * Math.PI / 2;
        assertEquals(Math.PI * radius * radius, area, 5e-4);
    }

    /** The only black pixel and its eight neighbours. */
    @Test
    void aDotInOnePixelRefinesItAndAllItsNeighbours() {
        Scene scene = SceneText.scene(EYE, "set 1 1 1 1 1", BLACK, "sph 0.3 0.1 1  0.08 1");
        assertEquals(1, black(oneRay(scene, SIZE)));
        assertEquals(9, smooth(scene, SIZE, 2).refinedPixels());
    }

    private static int black(Film film) {
        int black = 0;
        for (int y = 0; y < film.height(); y++) {
            for (int x = 0; x < film.width(); x++) {
                black += film.get(x, y).isBlack() ? 1 : 0;
            }
        }
        return black;
    }

    @Test
    void refinedPixelsAreThoseOfThePictureWithManyRaysEverywhereAndTheOthersThoseOfOneRay() {
        Scene scene = SceneText.scene(EYE, "set 1 0.5 1 1 1", "mtl 1 0.8 0.6  0 0 0  0 0 0  1 0",
            "sph 0.3 0.1 1  0.08 1", "sph -3 0 6 2 1", "lgt 1 4 -2  1 1 1  1 1 0");
        int size = 40;
        Rendering drawn = smooth(scene, size, 3);
        Film one = oneRay(scene, size);
        Film many = everywhere(scene, size, 3);
        OneRayEach seen = seen(scene, size);
        int refined = 0;
        for (int y = 0; y < size; y++) {
            for (int x = 0; x < size; x++) {
                Film expected = seen.isEdge(x, y) ? many : one;
                assertEquals(expected.get(x, y), drawn.film().get(x, y), "pixel " + x + ", " + y);
                refined += seen.isEdge(x, y) ? 1 : 0;
            }
        }
        assertEquals(refined, drawn.refinedPixels());
        assertTrue(refined > 100 && refined < size * size / 2, "refined: " + refined);
    }

    private static OneRayEach seen(Scene scene, int size) {
        Renderer renderer = Renderers.of(scene, RenderSettings.DEFAULT.withSize(size, size));
        PixelLight light = new PixelLight(renderer);
        Region whole = Region.whole(size, size);
        OneRayEach seen = OneRayEach.findingEdges(whole, whole, new Progress(whole.pixelCount(), PixelGrid.ONE_RAY),
            DrawingListener.NONE);
        for (int y = 0; y < size; y++) {
            for (int x = 0; x < size; x++) {
                seen.paint(x, y, light);
            }
        }
        return seen;
    }

    /** A ball in the middle, lit from the eye. */
    @Test
    void aSymmetricSceneIsRefinedSymmetrically() {
        int size = 31;
        OneRayEach seen = seen(SceneText.scene(EYE, "set 0.5 0.5 0.5 1 1", "mtl 1 1 1  0 0 0  0 0 0  1 0",
            "sph 0 0 2 1 1", "lgt 0 0 0 1 1 1 1 1 0"), size);
        int edges = 0;
        for (int y = 0; y < size; y++) {
            for (int x = 0; x < size; x++) {
                boolean isEdge = seen.isEdge(x, y);
                assertEquals(isEdge, seen.isEdge(size - 1 - x, y));
                assertEquals(isEdge, seen.isEdge(x, size - 1 - y));
                assertEquals(isEdge, seen.isEdge(y, x));
                edges += isEdge ? 1 : 0;
            }
        }
        assertTrue(edges > 0 && edges < size * size / 2, "edges: " + edges);
    }

    @Test
    void aPictureOfOneColourRefinesNothing() {
        assertEquals(0, smooth(SceneText.scene(EYE, "set 0.3 0.5 0.7 1 1"), SIZE, 4).refinedPixels());
    }

    /** Under a lamp of 100 at the eye, a wall is 100 cos(angle) bright: from 98 in the middle to 58 in the corners. */
    @Test
    void lightThatIsWhiterThanWhiteHasNoEdges() {
        Scene scene = SceneText.scene(EYE, "set 0 0 0 1 1", "mtl 1 1 1  0 0 0  0 0 0  1 0", "pln 0 0 1  1 1",
            "lgt 0 0 0  100 100 100  1 1 0");
        Film one = oneRay(scene, SIZE);
        assertTrue(one.get(5, 5).green() - one.get(0, 0).green() > 30);
        assertEquals(0, smooth(scene, SIZE, 4).refinedPixels());
    }

    /** A cube of clear glass before an even sky; the border of its face runs between two columns of pixels' centres. */
    @Test
    void whereOtherSurfacesAreSeenThereIsAnEdgeWhateverTheirColours() {
        Scene scene = SceneText.scene(EYE, "set 0.5 0.5 0.5 1 1", "mtl 0 0 0  0 0 0  0 0 0  1 1",
            "box -7.54 0 9  16 1");
        assertEquals(new Color(0.5, 0.5, 0.5), oneRay(scene, SIZE).get(3, 5));
        assertEquals(2 * SIZE, smooth(scene, SIZE, 2).refinedPixels());
    }

    @Test
    void everywhereMeansEveryPixel() {
        assertEquals(1, Rendering.of(Renderers.of(wall("0 1 0", 0.3, 1), settings(SIZE, 2, Where.EVERYWHERE))).refinedShare());
    }

    @ParameterizedTest(name = "{0} threads, tiles of {1}")
    @CsvSource({"2, 16", "3, 1", "2, 7", "4, 1000"})
    void thePictureIsTheSameForEveryNumberOfThreadsAndEveryTileSize(int threads, int tileSize) {
        RenderSettings settings = settings(47, 2, Where.EDGES);
        Rendering expected = Rendering.of(Renderers.of(RendererTest.SCENE, settings.withWorkers(1, 47)));
        Rendering found = Rendering.of(Renderers.of(RendererTest.SCENE, settings.withWorkers(threads, tileSize)));
        RendererTest.assertSamePixels(expected.film(), found.film());
        assertEquals(expected.refinedPixels(), found.refinedPixels());
    }

    @ParameterizedTest
    @CsvSource({"EDGES, 1", "EDGES, 2", "EVERYWHERE, 1", "EVERYWHERE, 2"})
    void everyPixelCanBeReplayed(Where where, int root) {
        Renderer renderer = Renderers.of(RendererTest.SCENE, settings(24, root, where));
        Film film = Renderers.film(renderer);
        for (int y = 0; y < 24; y++) {
            for (int x = 0; x < 24; x++) {
                assertEquals(film.get(x, y), Renderers.pixel(renderer, x, y), "pixel " + x + ", " + y);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"EDGES", "EVERYWHERE"})
    void oneByOneRayIsThePictureWithoutTheOption(Where where) {
        Rendering drawn = Rendering.of(Renderers.of(RendererTest.SCENE, settings(40, 1, where)));
        RendererTest.assertSamePixels(oneRay(RendererTest.SCENE, 40), drawn.film());
        assertEquals(0, drawn.refinedPixels());
    }

    /**
     * From the only pixel, a tiny place on the floor, half of the lamp's square is seen, to the border of a cube. Of the
     * 3 x 3 shadow rays of one ray three go to either side, whatever the random numbers are, and three to cells on the
     * border. Repeated numbers would give a whole number of ninths; the mean of 1024 rays with their own is 1/2 to
     * about 0.003.
     */
    @Test
    void everyRayOfAPixelHasRandomNumbersOfItsOwn() {
        Scene scene = SceneText.scene("cam -1 4 0  0 0 0  0 0 1  1000 1", "set 0 0 0 3 1", "mtl 1 1 1 0 0 0 0 0 0 1 0",
            "pln 0 1 0 0 1", "box 5 6 0 10 1", "lgt 0 9 0  1 1 1  1 1 2");
        assertEquals(0.5, everywhere(scene, 1, 32).get(0, 0).green(), 0.02);
    }

    /** Measured: 0.01 to 0.50 steps of 1/255; one ray a pixel is 3 to 12 steps off. */
    @ParameterizedTest
    @MethodSource("raytracing.CommittedScenesTest#scenes")
    void ourScenesLookLikeThoseWithManyRaysEverywhere(Path file) throws Exception {
        Scene scene = Steps.parseScene(file);
        PictureDifference difference = new PictureDifference(
            smooth(scene, 100, 3).film().toImage(), everywhere(scene, 100, 3).toImage());
        assertTrue(difference.rootMeanSquare() < 0.75, () -> difference.rootMeanSquare() + " steps");
    }
}
