package raytracing.scene;

import raytracing.color.Color;
import raytracing.math.Vector;

/**
 * The scene line {@code lgt}.
 *
 * @param position centre of the light
 * @param color light that it sends, not reduced by distance
 * @param specularIntensity factor on its highlights, at least 0
 * @param shadowIntensity in [0, 1]: share of its light that an obstacle stops; 0 for no shadows
 * @param width edge of the square from which it shines when shadows are computed, at least 0
 */
public record Light(Vector position, Color color, double specularIntensity, double shadowIntensity, double width) {
}
