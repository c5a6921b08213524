package raytracing.geometry;

import raytracing.math.Vector;

/** Powers of two that bring numbers near 1, where squares and products stay in range. */
final class Scaling {
    /** Between 2^-200 and 2^200 the products of four sizes, and what 106 bits hold of them, stay in range unscaled. */
    private static final int HARMLESS = 200;

    /** Beyond this exponent a factor would not be a normal number. */
    private static final int LARGEST = 1000;

    private static final int DOUBLE_FRACTION_BITS = 52;

    /** Exact numbers of sizes further apart than 1 and this are long, and no picture shows the smaller one. */
    private static final double NEGLIGIBLE = 0x1p-400;

    private Scaling() {
    }

    /** The exponent by which to scale a size and points {@link #down}; 0 for those that need no scaling. */
    static int exponent(double size, Vector... points) {
        double largest = size;
        for (Vector point : points) {
            largest = Math.max(largest, point.largestPart());
        }
        int exponent = Math.getExponent(largest);
        return largest == 0 || Math.abs(exponent) <= HARMLESS ? 0 : Math.max(-LARGEST, Math.min(LARGEST, exponent));
    }

    /** As {@code scalb}, which is for any exponent and slower: where 2^exponent is a normal number, one product will do. */
    private static double scaled(double value, int exponent) {
        return Math.abs(exponent) > LARGEST ? Math.scalb(value, exponent)
            : value * Double.longBitsToDouble((long) (exponent + Double.MAX_EXPONENT) << DOUBLE_FRACTION_BITS);
    }

    /** A size scaled; where scaling is needed at all, a size 2^400 times smaller than the largest counts as 0. */
    static double down(double value, int exponent) {
        if (exponent == 0) {
            return value;
        }
        double scaled = scaled(value, -exponent);
        return Math.abs(scaled) < NEGLIGIBLE ? 0 : scaled;
    }

    static Vector down(Vector vector, int exponent) {
        return exponent == 0 ? vector
            : new Vector(down(vector.x(), exponent), down(vector.y(), exponent), down(vector.z(), exponent));
    }

    /** A crossing above 0 stays above 0 and finite even where its size leaves the range. */
    static double upPositive(double crossing, int exponent) {
        return crossing == Surface.MISS ? crossing
            : Math.max(Double.MIN_VALUE, Math.min(Double.MAX_VALUE, scaled(crossing, exponent)));
    }
}
