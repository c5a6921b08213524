package raytracing.numerics;

/** What a rounded operation leaves over: itself a double, as long as nothing leaves the range of normal numbers. */
final class Rounding {
    private Rounding() {
    }

    /** Exactly a + b less the rounded sum: Knuth, The Art of Computer Programming, volume 2, section 4.2.2. */
    static double ofSum(double a, double b) {
        double sum = a + b;
        double bPart = sum - a;
        double aPart = sum - bPart;
        return (a - aPart) + (b - bPart);
    }

    /** Exactly a b less the rounded product: the fused operation rounds nothing else. */
    static double ofProduct(double a, double b) {
        return Math.fma(a, b, -(a * b));
    }
}
