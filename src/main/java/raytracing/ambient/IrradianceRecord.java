package raytracing.ambient;

import raytracing.color.Color;
import raytracing.math.Vector;

/**
 * The ambient light at one point of a surface, which counts around that point too.
 *
 * @param point world axes
 * @param normal unit length, on the side on which the light arrives
 * @param radius how far from the point the record counts, in scene units
 * @param light mean over the hemisphere, weighted with the cosine to the normal
 */
public record IrradianceRecord(Vector point, Vector normal, double radius, Color light) {
}
