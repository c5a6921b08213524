package raytracing.numerics;

/**
 * The unevaluated sum of two doubles, about 106 bits: Dekker, A floating-point technique for extending the available
 * precision, Numerische Mathematik 18, 1971. Written for reading, with an object for each number. Independent of the
 * product, so that both cannot share a mistake.
 *
 * @param high the sum, rounded to a double
 * @param low what that rounding left over
 */
record DoubleDouble(double high, double low) {
    static DoubleDouble of(double a) {
        return new DoubleDouble(a, 0);
    }

    /** Exact. */
    static DoubleDouble sum(double a, double b) {
        return new DoubleDouble(a + b, Rounding.ofSum(a, b));
    }

    /** Exact. */
    static DoubleDouble difference(double a, double b) {
        return sum(a, -b);
    }

    /** Exact. */
    static DoubleDouble product(double a, double b) {
        return new DoubleDouble(a * b, Rounding.ofProduct(a, b));
    }

    private static DoubleDouble normalised(double high, double low) {
        double sum = high + low;
        return new DoubleDouble(sum, low - (sum - high));
    }

    DoubleDouble plus(DoubleDouble other) {
        DoubleDouble highs = sum(high, other.high);
        DoubleDouble lows = sum(low, other.low);
        DoubleDouble carried = normalised(highs.high, highs.low + lows.high);
        return normalised(carried.high, carried.low + lows.low);
    }

    DoubleDouble minus(DoubleDouble other) {
        return plus(other.negated());
    }

    DoubleDouble times(DoubleDouble other) {
        DoubleDouble product = product(high, other.high);
        return normalised(product.high, product.low + (high * other.low + low * other.high));
    }

    DoubleDouble dividedBy(DoubleDouble other) {
        double quotient = high / other.high;
        if (Double.isInfinite(quotient)) {
            return of(quotient);             // its rest would be infinity minus infinity
        }
        DoubleDouble rest = minus(other.times(of(quotient)));
        double correction = rest.high / other.high;
        DoubleDouble secondRest = rest.minus(other.times(of(correction)));
        return normalised(quotient, correction).plus(of(secondRest.high / other.high));
    }

    /** Of a number that is not below 0. */
    DoubleDouble squareRoot() {
        if (high == 0) {
            return this;
        }
        double root = Math.sqrt(high);
        DoubleDouble rest = minus(product(root, root));
        return normalised(root, rest.high / (2 * root));
    }

    DoubleDouble negated() {
        return new DoubleDouble(-high, -low);
    }

    boolean isNegative() {
        return high < 0;
    }

    boolean isPositive() {
        return high > 0;
    }

    boolean isLessThan(DoubleDouble other) {
        return high < other.high || (high == other.high && low < other.low);
    }
}
