package raytracing.math;

/**
 * An exact number (p + s sqrt(q)) / r, where p, q and r are sums and products of doubles, as a ray's crossing with a plane,
 * a cube or a sphere is. Such numbers are compared by squaring the roots away, so nothing is rounded. Immutable.
 *
 * @param rational the number p
 * @param signedSquare the number s q, where s is 1 or -1 and q is at least 0; 0 for a quotient without a root
 * @param divisor the number r, above 0
 */
public record Surd(Dyadic rational, Dyadic signedSquare, Dyadic divisor) implements Comparable<Surd> {
    public static final Surd ZERO = new Surd(Dyadic.ZERO, Dyadic.ZERO, Dyadic.of(1));

    private static final Dyadic FOUR = Dyadic.of(4);

    /** A number over another that is not 0. */
    public static Surd quotient(Dyadic dividend, Dyadic divisor) {
        return divisor.signum() > 0 ? new Surd(dividend, Dyadic.ZERO, divisor)
            : new Surd(dividend.negated(), Dyadic.ZERO, divisor.negated());
    }

    /** Equal numbers compare as 0, however they are written; {@code equals} is about how they are written. */
    @Override
    public int compareTo(Surd other) {
        Dyadic difference = rational.times(other.divisor).minus(other.rational.times(divisor));
        Dyadic mine = signedSquare.times(other.divisor).times(other.divisor);
        Dyadic others = other.signedSquare.times(divisor).times(divisor);
        return signOfSum(difference, mine, others.negated());
    }

    public int signum() {
        return signOfSum(rational, signedSquare);
    }

    /** The sign of a + root, given s root^2 for a root of sign s. */
    private static int signOfSum(Dyadic a, Dyadic square) {
        int sign = a.signum();
        if (sign == 0 || square.signum() == 0 || sign == square.signum()) {
            return sign == 0 ? square.signum() : sign;
        }
        return sign * a.times(a).compareTo(square.abs());
    }

    /** The sign of a + root + other root. */
    private static int signOfSum(Dyadic a, Dyadic square, Dyadic otherSquare) {
        int sign = signOfSum(a, square);
        if (sign == 0 || otherSquare.signum() == 0 || sign == otherSquare.signum()) {
            return sign == 0 ? otherSquare.signum() : sign;
        }
        // (a + root)^2 - other root^2 is a number and a root again
        Dyadic squares = a.times(a).plus(square.abs()).minus(otherSquare.abs());
        Dyadic product = FOUR.times(a).times(a).times(square);
        return sign * signOfSum(squares, a.signum() < 0 ? product.negated() : product);
    }

    /**
     * This number as a double. The error is at most half a unit in the last place and 2^-70 of it where the number is in
     * the range of normal doubles; below that it is one of the two nearest, beyond it infinity.
     */
    public double doubleValue() {
        if (signedSquare.signum() == 0) {
            return rational.over(divisor).doubleValue();
        }
        Dyadic root = signedSquare.abs().squareRoot();
        Dyadic signedRoot = signedSquare.signum() < 0 ? root.negated() : root;
        if (rational.signum() * signedSquare.signum() >= 0) {
            return rational.plus(signedRoot).over(divisor).doubleValue();
        }
        // p + s root is (p^2 - q) / (p - s root), where nothing cancels
        return rational.times(rational).minus(signedSquare.abs())
            .over(rational.minus(signedRoot).times(divisor)).doubleValue();
    }
}
