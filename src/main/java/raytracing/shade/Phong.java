package raytracing.shade;

import raytracing.math.Powers;

/** Reflection of light at one point: Phong, Illumination for Computer Generated Pictures, CACM 18:6, 1975. */
final class Phong {
    /** A highlight with a larger exponent is sharp: it may have an edge inside a pixel. */
    private static final double SHARPEST_WIDE = 50;

    /** The exponent times the square of an angle at which light forty times white has fallen to 1/512: 2 ln (40 x 512). */
    private static final double VISIBLE_TURN = 20;

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

    /**
     * How far the mirrored direction must turn, in radians, until a sharp highlight becomes visible or, below 0, until none
     * is; infinite if the highlight is not sharp.
     *
     * @param cosine L.M, as above
     */
    static double sharpMargin(double cosine, double exponent) {
        return exponent > SHARPEST_WIDE ? Math.sqrt(Math.max(0, 2 - 2 * cosine)) - Math.sqrt(VISIBLE_TURN / exponent)
            : Double.POSITIVE_INFINITY;
    }
}
