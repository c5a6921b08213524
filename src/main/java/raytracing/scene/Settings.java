package raytracing.scene;

import raytracing.color.Color;

/**
 * The scene line {@code set}.
 *
 * @param background light along a ray that meets nothing
 * @param shadowRayRoot N: each light is sampled by N x N shadow rays; in [1, {@value #LARGEST_SHADOW_RAY_ROOT}]
 * @param maxReflections how often light may be mirrored on its way to the eye; in [0, 1000]
 * @param ambientScale factor on the estimated ambient light, at least 0
 */
public record Settings(Color background, int shadowRayRoot, int maxReflections, double ambientScale) {
    /** The largest N, in a scene and on the command line. */
    public static final int LARGEST_SHADOW_RAY_ROOT = 1024;
}
