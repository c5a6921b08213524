package raytracing.shade;

import raytracing.math.Powers;

/** Reflection of light at one point: Phong, Illumination for Computer Generated Pictures, CACM 18:6, 1975. */
final class Phong {
    private Phong() {
    }

    /**
     * Factor on the specular colour: the light's specular intensity times max(0, R.V)^n. As a mirror is its own
     * inverse, R.V, the light's mirror image against the eye, is also L.M, the light against the eye's mirror image.
     *
     * @param cosine L.M; a rounding beyond 1 counts as 1
     * @return at least 0, finite
     */
    static double highlight(double intensity, double cosine, double exponent) {
        double facing = cosine > 0 ? Math.min(cosine, 1) : 0;    // 0 also if it is NaN, as of a light too far away
        return intensity * Powers.power(facing, exponent);
    }
}
