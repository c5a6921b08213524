package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import raytracing.film.Film;
import raytracing.render.RenderSettings;
import raytracing.shadow.ShadowMethod;

/**
 * A soft shadow that is known on paper, and so the error of every method. A lamp of width 2 hangs 4 above a floor; a
 * wall at x = 0.3 cuts its square.
 *
 * <p>From the floor at (p, 0, 0) with p below 0.3, the lamp is seen under the cosine n = 4 / sqrt(16 + p p). The
 * square's axis in the plane of the wall's normal is (n, ..., 0), so the square passes the wall at 0.3 / n from its
 * middle: the share 1/2 + 0.15 / n is seen. Times the cosine, the floor shines with n / 2 + 0.15.
 */
class PaperShadowTest {
    private static final int WIDTH = 201;
    private static final double EYE_HEIGHT = 3;
    private static final String SCENE = """
        cam 0 3 0  0 0 0  0 0 1  1 2
        set 0 0 0  5 0
        mtl 1 1 1  0 0 0  0 0 0  1 0
        pln 0 1 0  0  1
        pln 1 0 0  0.3  1
        lgt 0 4 0  1 1 1  0  1  2
        """;

    /** Errors of the pixels of a row that sees the floor along z = 0. */
    private record Errors(double largest, double rootMeanSquare) {
    }

    private static Errors errors(ShadowMethod method) {
        Film film = Steps.renderScene(SceneText.scene(SCENE),
            RenderSettings.DEFAULT.withSize(WIDTH, 1).withShadowMethod(method));
        double largest = 0;
        double squares = 0;
        int count = 0;
        for (int i = 0; i < WIDTH; i++) {
            double p = EYE_HEIGHT * 2 * ((i + 0.5) / WIDTH - 0.5);
            if (p < 0.3) {
                double error = film.get(i, 0).red() - (2 / Math.sqrt(16 + p * p) + 0.15);
                largest = Math.max(largest, Math.abs(error));
                squares += error * error;
                count++;
            }
        }
        return new Errors(largest, Math.sqrt(squares / count));
    }

    @Test
    void exactShadowsAreThoseOnPaper() {
        assertEquals(0, errors(new ShadowMethod.Exact()).largest(), 1e-14);
    }

    /**
     * A straight border crosses about N cells, each of which adds an error of the order of 1 / N^2: together N^-1.5.
     * From N = 4 to 16 that is 8; the ratio of two roots of mean squares over 100 pixels is off by a third in less than
     * one of 1000 seeds.
     */
    @Test
    void sampledShadowsComeNearerWithMoreRays() {
        double four = errors(ShadowMethod.Sampled.withRoot(4)).rootMeanSquare();
        double sixteen = errors(ShadowMethod.Sampled.withRoot(16)).rootMeanSquare();
        assertEquals(8, four / sixteen, 8 / 3.0);
        assertTrue(four < 0.1, () -> "N = 4 is off by " + four);
    }

    @Test
    void exactShadowsHaveNoUseForRandomNumbers() {
        RenderSettings settings = RenderSettings.DEFAULT.withSize(WIDTH, 1).withShadowMethod(new ShadowMethod.Exact());
        Film film = Steps.renderScene(SceneText.scene(SCENE), settings);
        Film other = Steps.renderScene(SceneText.scene(SCENE), settings.withSeed(2));
        for (int i = 0; i < WIDTH; i++) {
            assertEquals(film.get(i, 0), other.get(i, 0));
        }
    }

    /** The scene's N does not matter either: one ray, a hard shadow, has the same limit. */
    @Test
    void exactShadowsAreSoftWhateverTheScenesNumberOfRays() {
        RenderSettings settings = RenderSettings.DEFAULT.withSize(WIDTH, 1).withShadowMethod(new ShadowMethod.Exact());
        Film film = Steps.renderScene(SceneText.scene(SCENE), settings);
        Film one = Steps.renderScene(SceneText.scene(SCENE.replace("5 0\n", "1 0\n")), settings);
        for (int i = 0; i < WIDTH; i++) {
            assertEquals(film.get(i, 0), one.get(i, 0));
        }
    }
}
