package raytracing.timed;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
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
 * The "balls" of Haines, A Proposal for Standard Graphics Environments, IEEE Computer Graphics and Applications 7(11),
 * 1987: a sphere of radius r carries nine touching ones of radius r/3, each of these again nine, and so on. They sit
 * where nine of the twelve neighbours of a sphere in a closest packing do: six in the plane across its axis, three
 * above it, none on the side of the parent. The axis of a child points away from its parent.
 */
public final class Sphereflake {
    private static final int GROUND = 0;
    private static final int BALL = 1;
    private static final int RECURSION = 4;
    private static final double CHILD = 1.0 / 3;

    /** Height along the axis, and distance from it, of the upper three of a closest packing. */
    private static final double UPPER_HEIGHT = Math.sqrt(2.0 / 3);
    private static final double UPPER_RADIUS = Math.sqrt(1.0 / 3);

    private Sphereflake() {
    }

    private record Ball(Vector centre, double radius, Vector axis) {
        Stream<Ball> children() {
            Vectors.Axes basis = Vectors.around(axis);
            return Stream.concat(
                IntStream.range(0, 6).mapToObj(i -> child(basis, 60 * i, 1, 0)),
                IntStream.range(0, 3).mapToObj(i -> child(basis, 30 + 120 * i, UPPER_RADIUS, UPPER_HEIGHT)));
        }

        private Ball child(Vectors.Axes basis, int degrees, double fromAxis, double alongAxis) {
            double angle = StrictMath.toRadians(degrees);
            Vector direction = Vectors.plus(Vectors.plus(basis.u().times(fromAxis * StrictMath.cos(angle)),
                fromAxis * StrictMath.sin(angle), basis.v()), alongAxis, axis);
            return new Ball(Vectors.plus(centre, radius * (1 + CHILD), direction), radius * CHILD, direction);
        }

        Surface sphere() {
            return new Sphere(NineDigits.of(centre), NineDigits.of(radius), BALL);
        }
    }

    /**
     * A sphereflake on a matte floor under three lamps. The children of ball i, counted from 0 in the order of the
     * list, are the balls 9 i + 1 to 9 i + 9; the floor comes after the last ball.
     *
     * @param levels how often children are added: 2 to 6 for 91, 820, 7,381, 66,430 and 597,871 balls
     * @param shadowRayRoot N: each of the lamps is sampled by N x N shadow rays
     */
    public static Scene scene(int levels, int shadowRayRoot) {
        List<Surface> surfaces = new ArrayList<>();
        List<Ball> generation = List.of(new Ball(Vector.ZERO, 1, new Vector(0, 1, 0)));
        for (int level = 0; level < levels; level++) {
            generation.forEach(ball -> surfaces.add(ball.sphere()));
            generation = generation.stream().flatMap(Ball::children).toList();
        }
        generation.forEach(ball -> surfaces.add(ball.sphere()));
        surfaces.add(new Plane(new Vector(0, 1, 0), -1, GROUND));
        return new Scene(
            new Camera(new Vector(4.2, 2.6, 3.4), Vector.ZERO, new Vector(0, 1, 0), 1, 0.83, new Pinhole()),
            new Settings(new Color(0.08, 0.36, 0.75), shadowRayRoot, RECURSION, 1),
            List.of(
                new Material(new Color(0.8, 0.6, 0.27), Color.BLACK, Color.BLACK, 1, 0, Color.BLACK),
                new Material(new Color(0.5, 0.45, 0.35), grey(0.5), grey(0.2), 20, 0, Color.BLACK)),
            surfaces,
            List.of(lamp(8, 4, 6), lamp(2, 8, -8), lamp(-6, 10, 2)));
    }

    private static Light lamp(double x, double y, double z) {
        return new Light(new Vector(x, y, z), grey(0.5), 1, 1, 1);
    }

    private static Color grey(double share) {
        return new Color(share, share, share);
    }
}
