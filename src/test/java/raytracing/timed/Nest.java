package raytracing.timed;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import raytracing.color.Color;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.scene.Camera;
import raytracing.scene.Light;
import raytracing.scene.Material;
import raytracing.scene.Pinhole;
import raytracing.scene.Scene;
import raytracing.scene.Settings;
import raytracing.surface.Plane;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;

/**
 * 25 transparent balls in five nests of five, each ball inside the one before and each a faint mirror, over a floor. A
 * straight ray passes up to 20 of them and is mirrored at every one: what is hard here is how many rays there are, and how
 * little most of them matter.
 */
public final class Nest {
    private static final int NESTS = 5;
    private static final int BALLS_IN_A_NEST = 5;
    private static final double LARGEST = 1.2;
    private static final double STEP = 0.2;
    private static final double RADIUS_OF_THE_RING = 2.6;

    /** Less than half a step: a ball stays inside the one before, whichever way both are shifted. */
    private static final double SHIFT = 0.05;

    /** In radians; no two balls are shifted the same way. */
    private static final double GOLDEN_ANGLE = 2.39996323;

    private Nest() {
    }

    /** The scene, with 4 x 4 shadow rays to each of three lamps and up to 10 reflections. */
    public static Scene scene() {
        List<Surface> surfaces = new ArrayList<>();
        for (int i = 0; i < NESTS * BALLS_IN_A_NEST; i++) {
            double radius = NineDigits.of(LARGEST - STEP * (i % BALLS_IN_A_NEST));
            surfaces.add(new Sphere(centre(i), radius, 1 + i % 3));
        }
        surfaces.add(new Plane(new Vector(0, 1, 0), -LARGEST, 0));
        return new Scene(
            new Camera(new Vector(0, 5, -14), new Vector(0, 0.3, 0), new Vector(0, 1, 0), 1, 0.9, new Pinhole()),
            new Settings(new Color(0.5, 0.6, 0.8), 4, 10, 1),
            materials(), surfaces,
            List.of(lamp(5, 7, -6), lamp(-6, 6, -3), lamp(0, 9, 4)));
    }

    private static Vector centre(int ball) {
        double around = 2 * Math.PI * (ball / BALLS_IN_A_NEST) / NESTS;
        double shifted = GOLDEN_ANGLE * ball;
        Vector nest = new Vector(StrictMath.cos(around), 0, StrictMath.sin(around)).times(RADIUS_OF_THE_RING);
        return NineDigits.of(Vectors.plus(nest, SHIFT, new Vector(StrictMath.cos(shifted), StrictMath.sin(shifted), 0)));
    }

    private static List<Material> materials() {
        Material floor = new Material(new Color(0.6, 0.6, 0.55), Color.BLACK, Color.BLACK, 1, 0, Color.BLACK);
        return Stream.concat(Stream.of(floor), Stream.of(
            shell(new Color(0.9, 0.4, 0.3), 0.1, 0.7),
            shell(new Color(0.4, 0.8, 0.4), 0.15, 0.75),
            shell(new Color(0.3, 0.5, 0.9), 0.2, 0.8))).toList();
    }

    private static Material shell(Color diffuse, double reflection, double transparency) {
        return new Material(diffuse, Color.WHITE, new Color(reflection, reflection, reflection), 40, transparency,
            Color.BLACK);
    }

    private static Light lamp(double x, double y, double z) {
        return new Light(new Vector(x, y, z), new Color(0.5, 0.5, 0.5), 1, 1, 1.5);
    }
}
