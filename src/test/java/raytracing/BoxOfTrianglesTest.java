package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.film.Film;
import raytracing.math.Vector;
import raytracing.render.RenderSettings;
import raytracing.scene.Scene;
import raytracing.shadow.ShadowMethod;

/**
 * A box of 12 opaque triangles beside the same box: the same picture, but for rounding. A ray of the eye or to a light passes
 * so near to an edge that rounding tells the two apart with a chance of 1e-9 in all pictures here together.
 */
class BoxOfTrianglesTest {
    private static final int SIZE = 40;
    private static final int SCENES = 12;

    /** Far above the rounding of light, and far below what a single shadow ray changes. */
    private static final double ROUNDING = 1e-9;

    private static final String HEAD = """
        set 0.3 0.5 0.9  3 2
        mtl 0.8 0.7 0.6  0 0 0  0 0 0  1 0
        mtl 0.5 0.6 0.2  0.4 0.4 0.4  0.3 0.3 0.3  9 0
        mtl 0.3 0.3 0.7  0 0 0  0 0 0  1 0.5
        pln 0 1 0 0 1
        sph -1.5 1 1.5 0.7 2
        """;

    static List<ShadowMethod> methods() {
        return List.of(ShadowMethod.Sampled.withRoot(1), ShadowMethod.Sampled.withRoot(2), ShadowMethod.Sampled.withRoot(5),
            new ShadowMethod.Exact());
    }

    private static Film film(ShadowMethod method, String camera, String body, String lights) {
        Scene scene = SceneText.scene(camera, HEAD + body, lights);
        return Steps.renderScene(scene, RenderSettings.DEFAULT.withSize(SIZE, SIZE).withShadowMethod(method));
    }

    private static String numbers(double x, double y, double z) {
        return " " + x + " " + y + " " + z + " ";
    }

    private static String camera(SplittableRandom random, Vector target) {
        return "cam" + numbers(random.nextDouble(-5, 5), random.nextDouble(0.5, 6), random.nextDouble(-7, -3))
            + numbers(target.x(), target.y(), target.z()) + "0 1 0  1 1.2";
    }

    /** Returns how many pixels differ from a picture without the body. */
    private static int assertSamePictures(ShadowMethod method, String camera, Vector centre, double edge, String lights) {
        String box = "box" + numbers(centre.x(), centre.y(), centre.z()) + edge + " 2";
        Film expected = film(method, camera, box, lights);
        Film found = film(method, camera, Meshes.box(centre, edge, 2), lights);
        Film without = film(method, camera, "", lights);
        int filled = 0;
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x++) {
                String pixel = "pixel " + x + ", " + y + " of " + camera + box + lights;
                assertEquals(expected.get(x, y).red(), found.get(x, y).red(), ROUNDING, pixel);
                assertEquals(expected.get(x, y).blue(), found.get(x, y).blue(), ROUNDING, pixel);
                filled += expected.get(x, y).equals(without.get(x, y)) ? 0 : 1;
            }
        }
        return filled;
    }

    /** A point, a small lamp, and a wide one that does not reach into the box, but below the horizon of its sides. */
    @ParameterizedTest
    @MethodSource("methods")
    void drawsWhatTheBoxDraws(ShadowMethod method) {
        SplittableRandom random = new SplittableRandom(1);
        int filled = 0;
        for (int i = 0; i < SCENES; i++) {
            double edge = random.nextDouble(0.2, 2);
            Vector centre = new Vector(random.nextDouble(-1, 2), random.nextDouble(0, 2), random.nextDouble(-1, 1));
            String lights = "lgt" + numbers(random.nextDouble(-4, 4), 5, random.nextDouble(-4, 1)) + " 0.4 0.4 0.4 1 1 0\n"
                + "lgt" + numbers(random.nextDouble(-4, 4), random.nextDouble(1, 4), -3) + " 0.5 0.3 0.3 1 0.9 0.4\n"
                + "lgt" + numbers(random.nextDouble(-3, 3), 5.2, random.nextDouble(-1, 1)) + " 0.3 0.3 0.5 1 1 3";
            filled += assertSamePictures(method, camera(random, centre), centre, edge, lights);
        }
        int pixels = filled;
        assertTrue(filled > SCENES * SIZE * SIZE / 20, () -> pixels + " pixels");
    }

    /** The eye and the lights are inside. */
    @ParameterizedTest
    @MethodSource("methods")
    void showsTheSameFromInside(ShadowMethod method) {
        String lights = "lgt 0.5 0.4 0.1  0.5 0.5 0.5  1 1 0\nlgt -0.3 1 0.3  0.5 0.5 0.5  1 1 0.7";
        String camera = "cam 0.1 1.2 -1.3  0 0.7 0  0 1 0  1 2";
        assertTrue(assertSamePictures(method, camera, new Vector(0.1, 1.1, 0.2), 4, lights) > SIZE * SIZE / 2);
    }

    /** On the floor, behind the wall that the light passes first, there is a second one. */
    @Test
    void aTransparentOneDimsTwice() {
        String camera = "cam 0 9 0.1  0 0 0  0 0 1  1 0.1";
        String light = "lgt 0 20 0  1 1 1  1 1 0";
        Vector centre = new Vector(0, 12, 0);
        double lit = film(ShadowMethod.OF_THE_SCENE, camera, "", light).get(20, 20).red();
        assertEquals(0.5 * lit, film(ShadowMethod.OF_THE_SCENE, camera, "box 0 12 0 2 3", light).get(20, 20).red(), ROUNDING);
        assertEquals(0.25 * lit, film(ShadowMethod.OF_THE_SCENE, camera, Meshes.box(centre, 2, 3), light).get(20, 20).red(),
            ROUNDING);
    }
}
