package raytracing.math;

import java.math.BigInteger;

/**
 * An exact number: a whole number times a power of two, as every double is, and every sum and product of such numbers. It
 * decides what no fixed precision can. Slow, and hardly ever asked. Immutable.
 *
 * @param significand the whole number
 * @param exponent of two
 */
public record Dyadic(BigInteger significand, int exponent) {
    /** Zero. */
    public static final Dyadic ZERO = new Dyadic(BigInteger.ZERO, 0);

    private static final int FRACTION_BITS = 52;
    private static final long IMPLICIT_BIT = 1L << FRACTION_BITS;

    /** Bits that go into a rounding: a double's, one that decides, and more; one for the sign is left. */
    private static final int BITS_TO_ROUND = 62;

    /**
     * A double, unchanged.
     *
     * @param value finite
     * @return the same number
     */
    public static Dyadic of(double value) {
        if (value == 0) {
            return ZERO;
        }
        long bits = Double.doubleToRawLongBits(value);
        long fraction = bits & (IMPLICIT_BIT - 1);
        boolean isNormal = Math.abs(value) >= Double.MIN_NORMAL;
        long whole = isNormal ? fraction | IMPLICIT_BIT : fraction;
        int exponent = Math.max(Math.getExponent(value), Double.MIN_EXPONENT) - FRACTION_BITS;
        int zeros = Long.numberOfTrailingZeros(whole);
        long odd = whole >>> zeros;
        return new Dyadic(BigInteger.valueOf(value < 0 ? -odd : odd), exponent + zeros);
    }

    /**
     * Sum.
     *
     * @param other summand
     * @return this + other
     */
    public Dyadic plus(Dyadic other) {
        if (signum() == 0) {
            return other;
        }
        if (other.signum() == 0) {
            return this;
        }
        return exponent <= other.exponent
            ? new Dyadic(significand.add(other.significand.shiftLeft(other.exponent - exponent)), exponent)
            : other.plus(this);
    }

    /**
     * Difference.
     *
     * @param other subtrahend
     * @return this - other
     */
    public Dyadic minus(Dyadic other) {
        return plus(other.negated());
    }

    /**
     * Product.
     *
     * @param other factor
     * @return this times other
     */
    public Dyadic times(Dyadic other) {
        return new Dyadic(significand.multiply(other.significand), exponent + other.exponent);
    }

    /**
     * The opposite number.
     *
     * @return this times -1
     */
    public Dyadic negated() {
        return new Dyadic(significand.negate(), exponent);
    }

    /**
     * Sign.
     *
     * @return -1, 0 or 1
     */
    public int signum() {
        return significand.signum();
    }

    /**
     * This number as a double.
     *
     * @return the nearest one, of two the even one; one of the two nearest where it is smaller than all normal numbers;
     *         infinite beyond all doubles
     */
    public double doubleValue() {
        BigInteger size = significand.abs();
        int dropped = Math.max(0, size.bitLength() - BITS_TO_ROUND);
        boolean isRest = dropped > 0 && size.getLowestSetBit() < dropped;
        // whatever is dropped can only break a tie, and so can the last of the bits that stay
        long leading = size.shiftRight(dropped).longValueExact() | (isRest ? 1 : 0);
        double rounded = Math.scalb((double) leading, exponent + dropped);
        return significand.signum() < 0 ? -rounded : rounded;
    }
}
