package raytracing.numerics;

import java.math.BigDecimal;
import java.math.BigInteger;

/**
 * A whole number times a power of two, as every double is, and every sum and product of doubles. For the tests that
 * need so many that decimal numbers are too slow. Independent of the product, so that both cannot share a mistake.
 *
 * @param significand the whole number
 * @param exponent of two
 */
record ExactNumber(BigInteger significand, int exponent) implements Comparable<ExactNumber> {
    static final ExactNumber ZERO = new ExactNumber(BigInteger.ZERO, 0);

    private static final long FRACTION = (1L << 52) - 1;

    /** A finite double, unchanged. */
    static ExactNumber of(double value) {
        long bits = Double.doubleToLongBits(value);
        int biased = (int) (bits >>> 52) & 0x7ff;
        long magnitude = biased == 0 ? bits & FRACTION : bits & FRACTION | FRACTION + 1;
        if (magnitude == 0) {
            return ZERO;
        }
        int zeros = Long.numberOfTrailingZeros(magnitude);
        long odd = magnitude >> zeros;
        return new ExactNumber(BigInteger.valueOf(bits < 0 ? -odd : odd), Math.max(biased, 1) - 1075 + zeros);
    }

    ExactNumber plus(ExactNumber other) {
        if (exponent < other.exponent) {
            return other.plus(this);
        }
        return other.signum() == 0 ? this : signum() == 0 ? other
            : new ExactNumber(significand.shiftLeft(exponent - other.exponent).add(other.significand), other.exponent);
    }

    ExactNumber minus(ExactNumber other) {
        return plus(other.negated());
    }

    ExactNumber times(ExactNumber other) {
        return new ExactNumber(significand.multiply(other.significand), exponent + other.exponent);
    }

    ExactNumber timesTwoTo(int power) {
        return new ExactNumber(significand, exponent + power);
    }

    ExactNumber squared() {
        return times(this);
    }

    ExactNumber negated() {
        return new ExactNumber(significand.negate(), exponent);
    }

    ExactNumber absolute() {
        return signum() < 0 ? negated() : this;
    }

    int signum() {
        return significand.signum();
    }

    @Override
    public int compareTo(ExactNumber other) {
        return signum() == other.signum() ? minus(other).signum() : Integer.compare(signum(), other.signum());
    }

    /** The quotient by a number that is not 0, off by less than 2^-50 of it; 0 or infinite beyond the range of doubles. */
    double over(ExactNumber divisor) {
        return Math.scalb(leading() / divisor.leading(), last() - divisor.last());
    }

    /** The leading bits as a number below 2^62, cut off. */
    private double leading() {
        return significand.shiftRight(last() - exponent).longValueExact();
    }

    /** The exponent of the last of these bits. */
    private int last() {
        return exponent + Math.max(0, significand.bitLength() - 62);
    }

    BigDecimal toDecimal() {
        BigDecimal whole = new BigDecimal(significand);
        BigDecimal power = new BigDecimal(BigInteger.TWO.pow(Math.abs(exponent)));
        return exponent >= 0 ? whole.multiply(power) : whole.divide(power);
    }
}
