package raytracing.math;

import java.math.BigInteger;

/**
 * An exact number: a whole number times a power of two, as every double is, and every sum and product of such numbers. It
 * decides what no fixed precision can. Slow, and rarely needed. Immutable.
 *
 * @param exponent of two
 */
public record Dyadic(BigInteger significand, int exponent) implements Comparable<Dyadic> {
    public static final Dyadic ZERO = new Dyadic(BigInteger.ZERO, 0);

    private static final int FRACTION_BITS = 52;

    /** Bits that go into a rounding: a double's, one that decides, and more; one for the sign is left. */
    private static final int BITS_TO_ROUND = 62;

    /** Bits of a quotient or a root at least: many more than those of a double. */
    private static final int BITS_TO_KEEP = 80;

    /** The same number as a finite double. */
    public static Dyadic of(double value) {
        if (value == 0) {
            return ZERO;
        }
        int exponent = Math.max(Math.getExponent(value), Double.MIN_EXPONENT) - FRACTION_BITS;
        long whole = (long) Math.scalb(value, -exponent);
        int zeros = Long.numberOfTrailingZeros(whole);
        return new Dyadic(BigInteger.valueOf(whole >> zeros), exponent + zeros);
    }

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

    public Dyadic minus(Dyadic other) {
        return plus(other.negated());
    }

    public Dyadic times(Dyadic other) {
        return new Dyadic(significand.multiply(other.significand), exponent + other.exponent);
    }

    /**
     * The quotient by a divisor that is not 0, cut off: 0 for 0, else with a relative error of at most 2^-77 (proved: at
     * most 2^-79 each for both numbers and for the quotient).
     */
    public Dyadic over(Dyadic divisor) {
        Dyadic dividend = cutTo(2 * BITS_TO_KEEP);
        Dyadic cutDivisor = divisor.cutTo(BITS_TO_KEEP);
        return new Dyadic(dividend.significand.divide(cutDivisor.significand), dividend.exponent - cutDivisor.exponent);
    }

    /**
     * The square root of a number that is at least 0, cut off: 0 for 0, else with a relative error of at most 2^-78
     * (proved: 2^-158 for the number, 2^-79 for the root).
     */
    public Dyadic squareRoot() {
        int bits = (exponent + significand.bitLength()) % 2 == 0 ? 2 * BITS_TO_KEEP : 2 * BITS_TO_KEEP - 1;
        Dyadic square = cutTo(bits);         // whose exponent is even
        return new Dyadic(square.significand.sqrt(), square.exponent / 2);
    }

    /** This number with so many bits, the last ones cut off, or zeros added. */
    private Dyadic cutTo(int bits) {
        int shift = bits - significand.bitLength();
        return new Dyadic(significand.signum() < 0 ? significand.negate().shiftLeft(shift).negate()
            : significand.shiftLeft(shift), exponent - shift);
    }

    public Dyadic negated() {
        return new Dyadic(significand.negate(), exponent);
    }

    public Dyadic abs() {
        return new Dyadic(significand.abs(), exponent);
    }

    /** Equal numbers compare as 0, however they are written; most others by their leading bits alone. */
    @Override
    public int compareTo(Dyadic other) {
        int sign = signum();
        if (sign != other.signum() || sign == 0) {
            return Integer.compare(sign, other.signum());
        }
        if (sign < 0) {
            return other.negated().compareTo(negated());
        }
        int leadingBit = exponent + significand.bitLength();
        int othersLeadingBit = other.exponent + other.significand.bitLength();
        return leadingBit != othersLeadingBit ? Integer.compare(leadingBit, othersLeadingBit) : minus(other).signum();
    }

    public int signum() {
        return significand.signum();
    }

    /**
     * The nearest double, of two the even one; below all normal numbers one of the two nearest, beyond all doubles infinity.
     */
    public double doubleValue() {
        BigInteger size = significand.abs();
        int dropped = Math.max(0, size.bitLength() - BITS_TO_ROUND);
        boolean isRest = dropped > 0 && size.getLowestSetBit() < dropped;
        // the dropped bits can only break a tie, and so can the last of those that stay
        long leading = size.shiftRight(dropped).longValueExact() | (isRest ? 1 : 0);
        double rounded = Math.scalb((double) leading, exponent + dropped);
        return significand.signum() < 0 ? -rounded : rounded;
    }
}
