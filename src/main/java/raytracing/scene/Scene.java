package raytracing.scene;

import java.util.List;
import raytracing.geometry.Surface;

/**
 * Everything a scene file said. Immutable; surfaces refer to materials by their place in the list.
 *
 * @param camera the one camera
 * @param settings the one line of settings
 * @param materials in the order of the file
 * @param surfaces in the order of the file
 * @param lights in the order of the file
 */
public record Scene(Camera camera, Settings settings,
                    List<Material> materials, List<Surface> surfaces, List<Light> lights) {
    /**
     * Copies the lists.
     *
     * @param camera the one camera
     * @param settings the one line of settings
     * @param materials every {@link Surface#material()} is a place in it
     * @param surfaces any number, also none
     * @param lights any number, also none
     */
    public Scene {
        materials = List.copyOf(materials);
        surfaces = List.copyOf(surfaces);
        lights = List.copyOf(lights);
    }
}
