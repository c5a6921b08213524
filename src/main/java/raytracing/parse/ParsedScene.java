package raytracing.parse;

import java.util.List;
import raytracing.scene.Scene;

/**
 * A scene file that was read.
 *
 * @param scene what it describes
 * @param warnings what is allowed in it and can hardly be meant, a line each, at most 11; most files have none
 */
public record ParsedScene(Scene scene, List<String> warnings) {
}
