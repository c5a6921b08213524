package raytracing.scene;

import java.util.List;
import raytracing.surface.Surface;

/**
 * The contents of a scene file, in the order of the file. Immutable; every {@link Surface#material()} is an index in the
 * list of materials.
 */
public record Scene(Camera camera, Settings settings, List<Material> materials, List<Surface> surfaces, List<Light> lights) {
    /** Copies the lists. */
    public Scene {
        materials = List.copyOf(materials);
        surfaces = List.copyOf(surfaces);
        lights = List.copyOf(lights);
    }
}
