package raytracing.timed;

import java.util.List;
import java.util.stream.IntStream;
import raytracing.color.Color;
import raytracing.math.Vector;
import raytracing.scene.Camera;
import raytracing.scene.Light;
import raytracing.scene.Material;
import raytracing.scene.Pinhole;
import raytracing.scene.Scene;
import raytracing.scene.Settings;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;

/**
 * 20 concentric mirrors that are wholly transparent, seen from inside the innermost: every ray goes on behind each of
 * them and is mirrored by each in full, 10 times over. No ray weighs less than another, so only a limit ends it.
 */
public final class Hall {
    private static final int WALLS = 20;

    private Hall() {
    }

    /** The scene, with hard shadows. */
    public static Scene scene() {
        Material mirror = new Material(Color.BLACK, Color.BLACK, Color.WHITE, 1, 1, Color.BLACK);
        return new Scene(
            new Camera(new Vector(0.3, 0.2, -0.5), new Vector(0, 0, 1), new Vector(0, 1, 0), 1, 1, new Pinhole()),
            new Settings(new Color(0.01, 0.02, 0.03), 1, 10, 1),
            List.of(mirror),
            IntStream.rangeClosed(1, WALLS).<Surface>mapToObj(radius -> new Sphere(Vector.ZERO, radius, 0)).toList(),
            List.of(new Light(new Vector(0, 30, 0), Color.WHITE, 1, 1, 0)));
    }
}
