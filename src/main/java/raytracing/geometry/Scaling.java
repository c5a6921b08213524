package raytracing.geometry;

import raytracing.math.Vector;

/** Powers of two that bring numbers near 1, where squares and products stay in range. */
final class Scaling {
    /** Between 2^-200 and 2^200 the products of four sizes, and what 106 bits hold of them, stay in range unscaled. */
    private static final int HARMLESS = 200;

    /** Beyond this exponent a factor would not be a normal number. */
    private static final int LARGEST = 1000;

    private Scaling() {
    }

    /** The exponent by which to scale a size {@link #down}; 0 for sizes that need no scaling. */
    static int exponent(double size) {
        int exponent = Math.getExponent(size);
        return Math.abs(exponent) <= HARMLESS ? 0 : Math.max(-LARGEST, Math.min(LARGEST, exponent));
    }

    static double down(double value, int exponent) {
        return Math.scalb(value, -exponent);
    }

    static Vector down(Vector vector, int exponent) {
        return vector.times(Math.scalb(1.0, -exponent));
    }

    /** A crossing above 0 stays above 0 and finite even where its size leaves the range. */
    static double upPositive(double crossing, int exponent) {
        return crossing == Surface.MISS ? crossing
            : Math.max(Double.MIN_VALUE, Math.min(Double.MAX_VALUE, Math.scalb(crossing, exponent)));
    }
}
