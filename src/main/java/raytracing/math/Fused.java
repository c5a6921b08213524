package raytracing.math;

/**
 * Products and sums with one rounding, to the bit those of {@link Math#fma}. Where the processor has no such operation, Java
 * computes it in decimals, some hundred times as slowly; there these take a dozen or four dozen operations of doubles.
 */
public final class Fused {
    /** Of doubles: 26 and 26 bits, the second with a sign, make 53. */
    private static final double SPLITTER = 0x1p27 + 1;

    /** Below the first, splitting does not overflow; between the other two, neither a product nor its error leaves the range. */
    private static final double LARGEST_FACTOR = 0x1p990;
    private static final double SMALLEST_PRODUCT = 0x1p-900;
    private static final double LARGEST_PRODUCT = 0x1p1000;

    private static final int TRIALS = 5;
    private static final long SLOW_NANOSECONDS = 2_000;
    private static final boolean IS_FAST = isFast();

    private Fused() {
    }

    /** Whether the processor does it: found by the time of the fastest of some calls, as no public method tells. */
    private static boolean isFast() {
        long least = Long.MAX_VALUE;
        double sum = 0;
        for (int i = 0; i < TRIALS; i++) {
            long start = System.nanoTime();
            sum = Math.fma(sum, SPLITTER, 1 / SPLITTER);
            least = Math.min(least, System.nanoTime() - start);
        }
        return sum > 0 && least < SLOW_NANOSECONDS;
    }

    /** The number a b + c, rounded once. */
    public static double multiplyAdd(double a, double b, double c) {
        return IS_FAST ? Math.fma(a, b, c) : slowMultiplyAdd(a, b, c);
    }

    /** The real number a b - product, rounded once, where {@code product} is a b rounded to a double; 0 if both are 0. */
    public static double errorOfProduct(double a, double b, double product) {
        return IS_FAST ? Math.fma(a, b, -product) : slowErrorOfProduct(a, b, product);
    }

    /**
     * The product and its error are added to the third number as three doubles: the two small ones rounded to odd, so that the
     * last rounding is that of the real sum (proved by Boldo, Melquiond, Emulation of a FMA and Correctly Rounded Sums, IEEE
     * Trans. Computers 57:4, 2008).
     */
    static double slowMultiplyAdd(double a, double b, double c) {
        double product = a * b;
        if (product == 0 && (a == 0 || b == 0)) {
            return product + c;
        }
        if (!isInRange(a, b, product) || !(Math.abs(c) < LARGEST_PRODUCT)) {
            return Math.fma(a, b, c);
        }
        double error = dekker(a, b, product);
        double small = c + error;
        double smallError = CompensatedSum.errorOfSum(c, error, small);
        double sum = product + small;
        double sumError = CompensatedSum.errorOfSum(product, small, sum);
        return sum + addedToOdd(sumError, smallError);
    }

    static double slowErrorOfProduct(double a, double b, double product) {
        if (product == 0 && (a == 0 || b == 0)) {
            return 0;
        }
        return isInRange(a, b, product) ? dekker(a, b, product) + 0.0 : Math.fma(a, b, -product);   // 0.0 makes 0 of -0
    }

    private static boolean isInRange(double a, double b, double product) {
        double size = Math.abs(product);
        return size > SMALLEST_PRODUCT && size < LARGEST_PRODUCT
            && Math.abs(a) < LARGEST_FACTOR && Math.abs(b) < LARGEST_FACTOR;
    }

    /** The error of a product, exactly (Dekker, A Floating-Point Technique for Extending the Available Precision, 1971). */
    private static double dekker(double a, double b, double product) {
        double shiftedA = SPLITTER * a;
        double highA = shiftedA - (shiftedA - a);
        double lowA = a - highA;
        double shiftedB = SPLITTER * b;
        double highB = shiftedB - (shiftedB - b);
        double lowB = b - highB;
        return lowA * lowB - (((product - highA * highB) - lowA * highB) - highA * lowB);
    }

    /** The sum, rounded to the neighbour whose last bit is 1 if it is no double. */
    private static double addedToOdd(double a, double b) {
        double sum = a + b;
        double error = CompensatedSum.errorOfSum(a, b, sum);
        long bits = Double.doubleToRawLongBits(sum);
        if (error == 0 || (bits & 1) != 0) {
            return sum;
        }
        return Double.longBitsToDouble(error > 0 == sum > 0 ? bits + 1 : bits - 1);
    }
}
