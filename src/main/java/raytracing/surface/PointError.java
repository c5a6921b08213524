package raytracing.surface;

import raytracing.math.Vector;

/**
 * How far the coordinates of a point may be off. A secondary ray starts at a rounded point; where the rounding leaves open on
 * which side of some surface that is, the point touches that surface, and {@link RayOrigin} knows the side. So surfaces that
 * touch or coincide cast no shadow on each other at random, at any scale, and no absolute length counts as small.
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
     * @return bound for each coordinate, in scene units
     */
    public static double written(Vector point) {
        return WRITTEN * point.largestPart();
    }

    /**
     * The error of a crossing's point.
     *
     * @param way how far it is from the world's origin to the ray's, and on to the crossing, each as its largest coordinate
     */
    static double ofCrossing(double way) {
        return COMPUTED * way;
    }
}
