package raytracing.shade;

import raytracing.math.Powers;
import raytracing.scene.Light;
import raytracing.scene.Material;

/** Reflection of light at one point: Phong, Illumination for Computer Generated Pictures, CACM 18:6, 1975. */
final class Phong {
    private Phong() {
    }

    /**
     * Factor on the specular colour: the light's specular intensity times max(0, R.V)^n. As a mirror is its own
     * inverse, R.V, the light's mirror image against the eye, is also L.M, the light against the eye's mirror image.
     *
     * @param material of the surface
     * @param light the light
     * @param cosine L.M; a rounding beyond 1 counts as 1
     * @return at least 0, finite
     */
    static double highlight(Material material, Light light, double cosine) {
        if (material.specular().isBlack()) {
            return 0;
        }
        double facing = cosine > 0 ? Math.min(cosine, 1) : 0;    // this way round, NaN from a light too far away is 0
        return light.specularIntensity() * Powers.power(facing, material.phongExponent());
    }
}
