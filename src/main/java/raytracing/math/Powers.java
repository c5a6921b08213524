package raytracing.math;

/** Powers that are the same on every machine and virtual machine. */
public final class Powers {
    /** Whole exponents up to this are multiplied out, which is several times faster than a logarithm and back. */
    private static final int LARGEST_MULTIPLIED = 1 << 12;

    private Powers() {
    }

    /**
     * base^exponent, for numbers of at least 0; any base to the power 0 is 1. The relative error is below 2^-52 times the
     * exponent for whole exponents up to 4096 (proved: that many roundings at most), otherwise 1 ulp (fdlibm's). Whole ones go
     * by repeated squaring: Knuth, The Art of Computer Programming, volume 2, section 4.6.3, algorithm A.
     */
    public static double power(double base, double exponent) {
        if (exponent > LARGEST_MULTIPLIED || exponent != (int) exponent) {
            return StrictMath.pow(base, exponent);
        }
        double product = 1;
        double square = base;
        for (int bits = (int) exponent; bits != 0; bits >>= 1) {
            if ((bits & 1) != 0) {
                product *= square;
            }
            square *= square;
        }
        return product;
    }
}
