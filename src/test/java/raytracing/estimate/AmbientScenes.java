package raytracing.estimate;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import raytracing.SceneText;
import raytracing.Shared;
import raytracing.Steps;
import raytracing.color.Color;
import raytracing.parse.RayTracerException;
import raytracing.scene.Material;
import raytracing.scene.Scene;

/** Scenes whose ambient light is known, or found by brute force. In all of them ambient colours are the diffuse ones. */
public final class AmbientScenes {
    private static final Path ROOM1 = Shared.SCENES.resolve("Room1.txt");

    private AmbientScenes() {
    }

    /**
     * A white furnace: the eye and a lamp of light 1 in the middle of a matt ball. N.L is 1 everywhere, so the wall sends
     * a on by the first bounce, a a by the second, and so on: ambient light is a + a a + ... = a / (1 - a).
     *
     * @param reflectance a, in [0, 1)
     */
    public static Scene furnace(double reflectance) {
        String color = (" " + reflectance).repeat(3);
        return SceneText.scene("cam 0 0 0  0 0 1  0 1 0  1 2", "set 0 0 0  1 5",
            "mtl " + color + "  0 0 0  0 0 0  1 0" + color, "sph 0 0 0 3 1", "lgt 0 0 0  1 1 1  0 0 0");
    }

    /** Things on an endless floor under a bright sky. */
    public static Scene open() {
        return SceneText.scene("cam 0 2.2 -6  0 0.6 0  0 1 0  1 1", "set 0.7 0.8 1  2 5",
            matt("0.6 0.55 0.5"), matt("0.8 0.2 0.15"), matt("0.2 0.3 0.7"), "pln 0 1 0  0 1",
            "sph -0.9 0.9 0  0.9 2", "sph 0.9 0.6 -0.8  0.6 3", "box 1.2 0.8 1.2  1.6 1", "box -1.6 0.3 -1.6  0.6 3",
            "lgt 4 6 -5  0.3 0.3 0.25  1 0.9 1");
    }

    /** A red, a green and a grey wall under a roof, the front open to the sky. */
    public static Scene halfClosed() {
        return SceneText.scene("cam 0 1.6 -5  0 1.2 0  0 1 0  1 1", "set 0.8 0.9 1  2 5",
            matt("0.7 0.7 0.7"), matt("0.7 0.2 0.2"), matt("0.2 0.7 0.3"), "pln 0 1 0  0 1", "pln 0 0 -1  -2 1",
            "box -3.5 1.5 0.5  3 2", "box 3.5 1.5 0.5  3 3", "box -1.5 4.5 0.5  3 1", "box 1.5 4.5 0.5  3 1",
            "sph 0.6 0.5 0.6  0.5 1", "lgt 3 8 -6  0.4 0.4 0.4  1 1 1");
    }

    /** A closed room of six colours with two balls in it, lit from the middle. */
    public static Scene closed() {
        return closed("pln 0 1 0 -1 1", "pln 0 1 0 1 2", "pln 1 0 0 -1.2 3", "pln 1 0 0 1.1 4", "pln 0 0 1 1 5",
            "pln 0 0 1 -3 5");
    }

    /** The same room, each of its walls of two triangles. */
    public static Scene closedOfTriangles() {
        return closed("trg -1.2 -1 -3 1.1 -1 -3 1.1 -1 1 1", "trg -1.2 -1 -3 1.1 -1 1 -1.2 -1 1 1",
            "trg -1.2 1 -3 1.1 1 1 1.1 1 -3 2", "trg -1.2 1 -3 1.1 1 1 -1.2 1 1 2",
            "trg -1.2 -1 -3 -1.2 -1 1 -1.2 1 1 3", "trg -1.2 -1 -3 -1.2 1 1 -1.2 1 -3 3",
            "trg 1.1 -1 -3 1.1 -1 1 1.1 1 -3 4", "trg 1.1 1 1 1.1 -1 1 1.1 1 -3 4",
            "trg -1.2 -1 1 1.1 -1 1 1.1 1 1 5", "trg -1.2 -1 1 -1.2 1 1 1.1 1 1 5",
            "trg -1.2 -1 -3 1.1 -1 -3 -1.2 1 -3 5", "trg 1.1 1 -3 1.1 -1 -3 -1.2 1 -3 5");
    }

    private static Scene closed(String... walls) {
        return SceneText.scene("cam 0 0 -2.7  0.05 0 0  0 1 0  1 1", "set 0 0 0  1 5",
            matt("0.8 0.5 0.4"), matt("0.5 0.75 0.4"), matt("0.4 0.5 0.8"), matt("0.6 0.4 0.8"), matt("0.7 0.7 0.7"),
            matt("0.2 0.2 0.2"), String.join("\n", walls), "sph 0.5 -0.7 0 0.3 6", "sph -0.3 -0.5 0.3 0.2 1", "lgt 0 0.1 -0.5  0.5 0.5 0.5  1 1 0");
    }

    /**
     * What a floor has of a white sky under a black ball that does not cut it. The ball, seen from the floor as a disc of
     * radius r / D around a direction, D the distance of its middle, hides (r / D)^2 times the direction's cosine, h / D.
     *
     * @param height h of the ball's middle, at least r
     * @param radius r
     * @param aside distance from the point below the ball
     */
    public static double lightUnderBlackBall(double height, double radius, double aside) {
        return 1 - radius * radius * height / Math.pow(Math.hypot(height, aside), 3);
    }

    /** A black ball above a floor under a white sky: what it hides of the sky is missing. */
    public static Scene blackBallOverFloor(double height, double radius) {
        return SceneText.scene("cam 0 0.5 -6  0 0 0  0 1 0  1 1.4", "set 1 1 1  1 5", matt("0 0 0"),
            "mtl 0 0 0  0 0 0  0 0 0  1 0  1 1 1", "pln 0 1 0  0 2", "sph 0 " + height + " 0 " + radius + " 1");
    }

    /** The course's closed room, its diffuse colours as ambient ones too; none if it does not lie beside the checkout. */
    public static Optional<Scene> room1() throws IOException, RayTracerException {
        return Files.exists(ROOM1) ? Optional.of(withAmbientColors(Steps.parseScene(ROOM1))) : Optional.empty();
    }

    /** A scene whose ambient colours are its diffuse ones. */
    public static Scene withAmbientColors(Scene scene) {
        return new Scene(scene.camera(), scene.settings(),
            scene.materials().stream().map(material -> withAmbient(material, material.diffuse())).toList(),
            scene.surfaces(), scene.lights());
    }

    /** A scene that shows the ambient light itself: all ambient colours are white. */
    public static Scene withWhiteAmbient(Scene scene) {
        return new Scene(scene.camera(), scene.settings(),
            scene.materials().stream().map(material -> withAmbient(material, Color.WHITE)).toList(),
            scene.surfaces(), scene.lights());
    }

    private static Material withAmbient(Material material, Color ambient) {
        return new Material(material.diffuse(), material.specular(), material.reflection(), material.phongExponent(),
            material.transparency(), ambient);
    }

    private static String matt(String color) {
        return "mtl " + color + "  0 0 0  0 0 0  1 0  " + color;
    }
}
