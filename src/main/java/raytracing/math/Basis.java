package raytracing.math;

/**
 * Three unit vectors u, v, w, perpendicular to one another; u cross v is w. All are zero before the first turn. It can be
 * turned again and again without allocation, as shading needs one for every light at every point. Not thread-safe.
 */
public final class Basis {
    /**
     * Below this squared sine of the angle to -y, {@link #turnTo} counts a direction as -y itself. No picture can show
     * the difference, and the squares in the formula would lose their digits further down.
     */
    private static final double STRAIGHT_DOWN = 0x1p-900;

    private double ux;
    private double uy;
    private double uz;
    private double vx;
    private double vy;
    private double vz;
    private double wx;
    private double wy;
    private double wz;
    private final UnitVector direction = new UnitVector();

    /**
     * Turns w to the direction n of a vector, and u and v, axes of the plane perpendicular to n, to where the shortest
     * rotation that takes +y to n takes z and x. They turn smoothly with n everywhere except at -y, where no such rule can
     * be smooth.
     *
     * <p>With a = 1 / (1 + n.y) the rotated x is (1 - n.x n.x a, -n.x, -n.x n.z a), and so on. For n.y below 0 the
     * sum 1 + n.y cancels, so a comes from (1 + n.y)(1 - n.y) = n.x n.x + n.z n.z. The axes are perpendicular and unit to
     * within 8 ulp of 1 (measured in {@code BasisTest}).
     *
     * @throws ArithmeticException if the vector is zero or not finite, as it then has no direction
     */
    public void turnTo(double x, double y, double z) {
        direction.set(x, y, z);
        wx = direction.x();
        wy = direction.y();
        wz = direction.z();
        double squaredSine = wx * wx + wz * wz;
        double xx;
        double xz;
        double zz;
        if (wy < 0 && squaredSine < STRAIGHT_DOWN) {
            xx = 0;                          // the limit of the formula for n.x = 0, n.z to 0
            xz = 0;
            zz = 2;
        } else {
            double a = wy >= 0 ? 1 / (1 + wy) : (1 - wy) / squaredSine;
            xx = wx * wx * a;
            xz = wx * wz * a;
            zz = wz * wz * a;
        }
        ux = -xz;
        uy = -wz;
        uz = 1 - zz;
        vx = 1 - xx;
        vy = -wx;
        vz = -xz;
    }

    public double ux() {
        return ux;
    }

    public double uy() {
        return uy;
    }

    public double uz() {
        return uz;
    }

    public double vx() {
        return vx;
    }

    public double vy() {
        return vy;
    }

    public double vz() {
        return vz;
    }

    public double wx() {
        return wx;
    }

    public double wy() {
        return wy;
    }

    public double wz() {
        return wz;
    }
}
