package raytracing.geometry;

import raytracing.math.Vector;

/**
 * How far the parts of a point may be off from where it is meant to be. A secondary ray starts at a rounded point; where
 * the rounding leaves open on which side of some surface that is, the point touches that surface, and {@link Standpoint} knows the
 * side. So surfaces that touch or coincide cast no shadow on each other at random, at any scale, and no length is ever called
 * small.
 */
public final class PointError {
    /**
     * 4 units of u = 2^-53: a coordinate as written is off by half a unit in the last place, and so are the numbers of a
     * surface written to go through it.
     */
    private static final double WRITTEN = 0x1p-51;

    /**
     * 16 u: a crossing is off by a few ulp, nearly always by 1, and o + t d rounds twice. Measured, not proved: a point
     * outside this bound would be a speck in {@code NoSpeckTest}.
     */
    private static final double COMPUTED = 0x1p-49;

    private PointError() {
    }

    /**
     * The error of a point that a scene names, or that is computed from such a one with a few roundings.
     *
     * @param point the point
     * @return bound for each part, in scene units
     */
    public static double written(Vector point) {
        return WRITTEN * point.largestPart();
    }

    /**
     * The error of a crossing's point.
     *
     * @param way how far the ray goes from the world's origin to the ray's, and on to the crossing, in largest parts
     * @return bound for each part, in scene units
     */
    static double ofCrossing(double way) {
        return COMPUTED * way;
    }
}
