package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.render.Renderers;
import raytracing.scene.Scene;
import raytracing.shadow.ShadowMethod;

/** Exact shadows in all pictures of this project. */
class ExactPicturesTest {
    private static final int SIZE = 40;
    private static final int RUNS = 6;
    private static final RenderSettings SMALL = RenderSettings.DEFAULT.withSize(SIZE, SIZE);
    private static final RenderSettings EXACT = SMALL.withShadowMethod(new ShadowMethod.Exact());

    static Stream<Path> scenes() throws Exception {
        return CommittedScenesTest.scenes();
    }

    /**
     * The distance from the mean of 6 pictures with 16 x 16 shadow rays is that of this mean from its limit, which the
     * spread of the six shows: the root of the mean square over thousands of channels is known to a few percent. A
     * pixel whose shadow is off shows where the distance is many times the spread. All are drawn in one ambient light, whose
     * estimate would differ by its seed.
     */
    @ParameterizedTest(name = "{0}")
    @MethodSource("scenes")
    void areTheLimitOfSampledOnes(Path file) throws Exception {
        Scene scene = Steps.parseScene(file);
        Renderer exactly = Renderers.of(scene, EXACT);
        Film exact = Renderers.film(exactly);
        Film[] sampled = new Film[RUNS];
        for (int run = 0; run < RUNS; run++) {
            RenderSettings settings = SMALL.withSeed(run + 1).withShadowMethod(ShadowMethod.Sampled.withRoot(16));
            sampled[run] = Renderers.film(Renderers.inAmbientLight(Renderers.of(scene, settings), exactly.ambientLight()));
        }
        double squares = 0;
        double variances = 0;
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x++) {
                double mean = 0;
                double meanSquare = 0;
                for (Film film : sampled) {
                    double light = grey(film, x, y);
                    mean += light / RUNS;
                    meanSquare += light * light / RUNS;
                }
                double variance = Math.max(meanSquare - mean * mean, 0) / (RUNS - 1);
                double distance = Math.abs(grey(exact, x, y) - mean);
                assertTrue(distance < 12 * Math.sqrt(variance) + 0.005, "pixel " + x + ", " + y + " is off by " + distance);
                squares += distance * distance;
                variances += variance;
            }
        }
        assertTrue(squares < 2 * variances + 1e-20,
            Math.sqrt(squares / variances) + " times as far as the spread says");
    }

    private static double grey(Film film, int x, int y) {
        Color light = film.get(x, y);
        return (light.red() + light.green() + light.blue()) / 3;
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("scenes")
    void areTheSameForEveryNumberOfThreadsAndEveryTileSize(Path file) throws Exception {
        Scene scene = Steps.parseScene(file);
        Film one = Steps.renderScene(scene, EXACT.withWorkers(1, SIZE));
        Film other = Steps.renderScene(scene, EXACT.withWorkers(3, 7));
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x++) {
                assertEquals(one.get(x, y), other.get(x, y), "pixel " + x + ", " + y);
            }
        }
    }
}
