package raytracing.parse;

import java.util.List;
import raytracing.scene.Scene;

/**
 * A scene file that was read.
 *
 * @param warnings one line for each thing that is allowed but is probably a mistake, at most 11; most files have none
 */
public record ParsedScene(Scene scene, List<String> warnings) {
}
