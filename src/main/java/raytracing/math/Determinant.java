package raytracing.math;

/**
 * The determinant a . (b x c) as if computed in twice the precision and rounded once: the error of every product and sum is
 * kept, as in {@link CompensatedSum}. It allocates nothing.
 */
public final class Determinant {
    private Determinant() {
    }

    /**
     * The determinant of three vectors, each coordinate of which is a sum of a double and a far smaller one: at most u times
     * the first, with u = 2^-53.
     *
     * @return error at most u times the result plus 2^-98 |a| |b| |c|, where |v| is the largest coordinate (proved: 40
     *         products of sizes |a| |b| |c|, each off by at most 3 u^2); where no product leaves the range of normal doubles
     */
    public static double of(double ax, double ay, double az, double lowAx, double lowAy, double lowAz,
                            double bx, double by, double bz, double lowBx, double lowBy, double lowBz,
                            double cx, double cy, double cz, double lowCx, double lowCy, double lowCz) {
        double yz = by * cz;
        double zy = bz * cy;
        double zx = bz * cx;
        double xz = bx * cz;
        double xy = bx * cy;
        double yx = by * cx;
        double x = yz - zy;
        double y = zx - xz;
        double z = xy - yx;
        double lowX = CompensatedSum.errorOfSum(yz, -zy, x)
            + (Fused.errorOfProduct(by, cz, yz) - Fused.errorOfProduct(bz, cy, zy))
            + (lowBy * cz + by * lowCz - lowBz * cy - bz * lowCy);
        double lowY = CompensatedSum.errorOfSum(zx, -xz, y)
            + (Fused.errorOfProduct(bz, cx, zx) - Fused.errorOfProduct(bx, cz, xz))
            + (lowBz * cx + bz * lowCx - lowBx * cz - bx * lowCz);
        double lowZ = CompensatedSum.errorOfSum(xy, -yx, z)
            + (Fused.errorOfProduct(bx, cy, xy) - Fused.errorOfProduct(by, cx, yx))
            + (lowBx * cy + bx * lowCy - lowBy * cx - by * lowCx);
        double rest = (ax * lowX + ay * lowY + az * lowZ) + (lowAx * x + lowAy * y + lowAz * z);
        return CompensatedSum.ofProducts(rest, ax, ay, az, x, y, z);
    }

    /** The determinant of three vectors of doubles, with six products rounded: fast. */
    public static double rounded(double ax, double ay, double az, double bx, double by, double bz,
                                 double cx, double cy, double cz) {
        return ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
    }
}
