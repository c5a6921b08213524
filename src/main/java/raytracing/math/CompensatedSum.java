package raytracing.math;

/**
 * Sums of products as if computed in twice the precision and rounded once: the error of every rounding is kept and added at
 * the end (Ogita, Rump, Oishi, Accurate Sum and Dot Product, SIAM J. Sci. Comput. 26:6, 2005, algorithm Dot2).
 */
public final class CompensatedSum {
    private CompensatedSum() {
    }

    /**
     * The number s + a . b. The error is at most u times the result plus 2^-102 times the sum of the terms' sizes, with
     * u = 2^-53 (proved there).
     */
    public static double ofProducts(double s, double ax, double ay, double az, double bx, double by, double bz) {
        double x = ax * bx;
        double y = ay * by;
        double z = az * bz;
        double xy = x + y;
        double xyz = xy + z;
        double sum = s + xyz;
        double productErrors = Fused.errorOfProduct(ax, bx, x) + Fused.errorOfProduct(ay, by, y)
            + Fused.errorOfProduct(az, bz, z);
        double sumErrors = errorOfSum(x, y, xy) + errorOfSum(xy, z, xyz) + errorOfSum(s, xyz, sum);
        return sum + (productErrors + sumErrors);
    }

    /** The real number a + b - sum, exactly, where {@code sum} is a + b rounded to a double (Knuth's TwoSum). */
    public static double errorOfSum(double a, double b, double sum) {
        double partOfB = sum - a;
        return (a - (sum - partOfB)) + (b - partOfB);
    }
}
