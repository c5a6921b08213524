package raytracing.scene;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import raytracing.surface.Surface;

/**
 * The contents of a scene file, in the order of the file. Immutable; every {@link Surface#material()} is an index in the
 * list of materials.
 */
public record Scene(Camera camera, Settings settings, List<Material> materials, List<Surface> surfaces, List<Light> lights) {
    /** Copies the lists; the surfaces in one move, for there may be a million ({@code List.copyOf} looks at each of them). */
    public Scene {
        materials = List.copyOf(materials);
        surfaces = Collections.unmodifiableList(new ArrayList<>(surfaces));
        lights = List.copyOf(lights);
    }
}
