package raytracing.math;

/**
 * A number of twice the precision: the unevaluated sum of two doubles, the second at most half a unit in the last
 * place of the first. Immutable.
 *
 * <p>Operations and their relative errors, with u = 2^-53, after Joldes, Muller, Popescu, Tight and Rigorous Error
 * Bounds for Basic Building Blocks of Double-Word Arithmetic, ACM TOMS 44:2, 2017. They hold while no intermediate
 * result leaves the range of normal numbers: callers scale first. The order of operations is what makes them right;
 * no step may be simplified as if doubles were real numbers.
 *
 * @param high the number, rounded to a double
 * @param low what {@code high} leaves out
 */
public record DoubleDouble(double high, double low) {
    /** Zero. */
    public static final DoubleDouble ZERO = new DoubleDouble(0, 0);

    /**
     * The exact sum of two doubles (Knuth's TwoSum).
     *
     * @param a summand
     * @param b summand
     * @return a + b, no error
     */
    public static DoubleDouble sum(double a, double b) {
        double sum = a + b;
        return new DoubleDouble(sum, errorOfSum(a, b, sum));
    }

    /**
     * The exact difference of two doubles.
     *
     * @param a minuend
     * @param b subtrahend
     * @return a - b, no error
     */
    public static DoubleDouble difference(double a, double b) {
        return sum(a, -b);
    }

    /**
     * The exact product of two doubles.
     *
     * @param a factor
     * @param b factor
     * @return a b, no error
     */
    public static DoubleDouble product(double a, double b) {
        double product = a * b;
        return new DoubleDouble(product, Math.fma(a, b, -product));
    }

    /**
     * The nearest double-double to an exact number.
     *
     * @param exact any number whose size is that of a double
     * @return relative error at most u^2
     */
    public static DoubleDouble nearest(Dyadic exact) {
        double high = exact.doubleValue();
        return new DoubleDouble(high, exact.minus(Dyadic.of(high)).doubleValue());
    }

    /**
     * What rounding took from a sum of two doubles, exactly.
     *
     * @param a summand
     * @param b summand
     * @param sum a + b as a double
     * @return the real number a + b - sum
     */
    public static double errorOfSum(double a, double b, double sum) {
        double partOfB = sum - a;
        return (a - (sum - partOfB)) + (b - partOfB);
    }

    /** Sum of two doubles of which the first is known to be the larger one, or 0 (Dekker's FastTwoSum). */
    private static DoubleDouble normalized(double large, double small) {
        double sum = large + small;
        return new DoubleDouble(sum, small - (sum - large));
    }

    /**
     * Sum.
     *
     * @param other summand
     * @return this + other; relative error at most 3 u^2 / (1 - 4 u)
     */
    public DoubleDouble plus(DoubleDouble other) {
        DoubleDouble highs = sum(high, other.high);
        DoubleDouble lows = sum(low, other.low);
        DoubleDouble first = normalized(highs.high, highs.low + lows.high);
        return normalized(first.high, lows.low + first.low);
    }

    /**
     * Difference.
     *
     * @param other subtrahend
     * @return this - other; relative error at most 3 u^2 / (1 - 4 u)
     */
    public DoubleDouble minus(DoubleDouble other) {
        return plus(other.negated());
    }

    /**
     * Product.
     *
     * @param other factor
     * @return this times other; relative error at most 4 u^2
     */
    public DoubleDouble times(DoubleDouble other) {
        double product = high * other.high;
        double error = Math.fma(high, other.high, -product);
        double cross = Math.fma(high, other.low, low * other.high + low * other.low);
        return normalized(product, error + cross);
    }

    /**
     * Product with a double.
     *
     * @param factor any double
     * @return this times factor; relative error at most 2 u^2
     */
    public DoubleDouble times(double factor) {
        double product = high * factor;
        double error = Math.fma(high, factor, -product);
        return normalized(product, Math.fma(low, factor, error));
    }

    /**
     * Square root.
     *
     * @return root of this number, which is at least 0; relative error at most 25/8 u^2 (Lefevre, Louvet, Muller,
     *         Picot, Rideau, Accurate Calculation of Euclidean Norms Using Double-Word Arithmetic, ACM TOMS 49:1, 2023)
     */
    public DoubleDouble squareRoot() {
        if (high == 0) {
            return ZERO;
        }
        double root = Math.sqrt(high);
        double remainder = Math.fma(-root, root, high) + low;
        return normalized(root, remainder / (2 * root));
    }

    /**
     * Quotient, rounded to a double.
     *
     * @param divisor not 0
     * @return this / divisor; relative error at most u (1 + 2^-40)
     */
    public double over(DoubleDouble divisor) {
        double quotient = high / divisor.high;
        DoubleDouble remainder = minus(divisor.times(quotient));
        return quotient + remainder.high / divisor.high;
    }

    /**
     * The opposite number.
     *
     * @return this times -1
     */
    public DoubleDouble negated() {
        return new DoubleDouble(-high, -low);
    }

    /**
     * Sign.
     *
     * @return -1, 0 or 1
     */
    public int sign() {
        return (int) Math.signum(high);
    }
}
