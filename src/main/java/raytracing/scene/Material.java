package raytracing.scene;

import raytracing.color.Color;

/**
 * The scene line {@code mtl}.
 *
 * @param diffuse share of light that is scattered evenly
 * @param specular strength of the highlights
 * @param reflection share of the mirrored scene that is added
 * @param phongExponent sharpness of the highlights, at least 0
 * @param transparency in [0, 1]: 0 opaque, 1 shows only what is behind and what is mirrored
 * @param ambient share of the room's ambient light that is added
 */
public record Material(Color diffuse, Color specular, Color reflection, double phongExponent, double transparency,
                       Color ambient) {
}
