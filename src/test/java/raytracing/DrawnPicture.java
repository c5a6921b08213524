package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.OptionalDouble;
import java.util.Set;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.math.Vector;
import raytracing.render.RenderSettings;
import raytracing.scene.Scene;

/**
 * A picture that the program drew, to be held to one derived on paper. It is square, of an odd number of pixels: its
 * middle row and column look exactly along the camera's axes, where touching and coincident surfaces are met edge-on.
 * Whatever the scene, every pixel is finite.
 */
final class DrawnPicture {
    static final int SIZE = 61;

    /** The solution of a pixel that is so close to an outline that rounding may decide it. */
    static final OptionalDouble UNDECIDED = OptionalDouble.empty();

    private static final double MOST_UNDECIDED = 0.02;

    private final Film film;

    /** The grey of a pixel by where its centre meets the screen: from -1 to 1, to the right and up. */
    interface Solution {
        OptionalDouble grey(double right, double up);
    }

    private DrawnPicture(Film film) {
        this.film = film;
    }

    /** The picture of the scene of these lines. */
    static DrawnPicture of(String... lines) {
        return of(SceneText.scene(lines));
    }

    static DrawnPicture of(Scene scene) {
        DrawnPicture picture = new DrawnPicture(
            Steps.renderScene(scene, RenderSettings.DEFAULT.withSize(SIZE, SIZE)));
        picture.assertFinite();
        return picture;
    }

    /** Three numbers of a scene line. */
    static String numbers(Vector vector) {
        return " " + vector.x() + " " + vector.y() + " " + vector.z() + " ";
    }

    Color get(int x, int y) {
        return film.get(x, y);
    }

    private void assertFinite() {
        for (int i = 0; i < SIZE * SIZE; i++) {
            Color color = get(i % SIZE, i / SIZE);
            boolean finite = Double.isFinite(color.red()) && Double.isFinite(color.green())
                && Double.isFinite(color.blue());
            assertTrue(finite, "pixel " + i % SIZE + ", " + i / SIZE + " is " + color);
        }
    }

    /** Compares every pixel with the solution, except for the few that it leaves open. */
    void assertSolved(double tolerance, Solution solution) {
        Set<Double> greys = new HashSet<>();
        int undecided = 0;
        Differences differences = new Differences();
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x++) {
                OptionalDouble expected = solution.grey(right(x), up(y));
                if (expected.isPresent()) {
                    greys.add(expected.getAsDouble());
                    differences.compare(x, y, expected.getAsDouble(), get(x, y).green(), tolerance);
                } else {
                    undecided++;
                }
            }
        }
        differences.assertNone();
        assertTrue(undecided <= MOST_UNDECIDED * SIZE * SIZE, "too many pixels left open: " + undecided);
        assertTrue(greys.size() > 1, "an even picture proves nothing");
    }

    /** Compares every pixel with that of another picture. */
    void assertLike(DrawnPicture other, double tolerance) {
        Differences differences = new Differences();
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x++) {
                differences.compare(x, y, other.get(x, y).green(), get(x, y).green(), tolerance);
            }
        }
        differences.assertNone();
        assertTrue(greys() > 1, "an even picture proves nothing");
    }

    private long greys() {
        Set<Double> greys = new HashSet<>();
        for (int i = 0; i < SIZE * SIZE; i++) {
            greys.add(get(i % SIZE, i / SIZE).green());
        }
        return greys.size();
    }

    private static double right(int x) {
        return ((x + 0.5) / SIZE - 0.5) * 2;
    }

    private static double up(int y) {
        return (0.5 - (y + 0.5) / SIZE) * 2;
    }

    /** Counts pixels that are not what they should be, and remembers the first. */
    private static final class Differences {
        private int count;
        private String first = "";

        void compare(int x, int y, double expected, double found, double tolerance) {
            if (!(Math.abs(found - expected) <= tolerance)) {
                first = count == 0 ? ", the first at " + x + ", " + y + ": expected " + expected + ", found " + found
                    : first;
                count++;
            }
        }

        void assertNone() {
            assertEquals(0, count, "pixels that differ" + first);
        }
    }
}
