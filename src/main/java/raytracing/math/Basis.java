package raytracing.math;

/**
 * Three unit vectors u, v, w, perpendicular to one another; u cross v is w. Immutable. Kept as nine numbers: objects
 * inside an object are what a virtual machine fails to keep off the heap, and shading makes a basis for every light.
 */
public final class Basis {
    /**
     * Below this squared sine of the angle to -y, {@link #around} counts a direction as -y itself. No picture can show
     * the difference, and the squares in the formula would lose their digits further down.
     */
    private static final double STRAIGHT_DOWN = 0x1p-900;

    private final double ux;
    private final double uy;
    private final double uz;
    private final double vx;
    private final double vy;
    private final double vz;
    private final double wx;
    private final double wy;
    private final double wz;

    private Basis(double ux, double uy, double uz, double vx, double vy, double vz, double wx, double wy, double wz) {
        this.ux = ux;
        this.uy = uy;
        this.uz = uz;
        this.vx = vx;
        this.vy = vy;
        this.vz = vz;
        this.wx = wx;
        this.wy = wy;
        this.wz = wz;
    }

    /**
     * The axes that look along {@code forward} with {@code up} above: u to the right, v up, w forward.
     *
     * @param forward viewing direction, unit length
     * @param up any vector, unit length, not parallel to {@code forward}
     * @return right = up x forward, made unit; true up = forward x right; forward
     * @throws ArithmeticException if {@code up} is parallel to {@code forward}
     */
    public static Basis looking(Vector forward, Vector up) {
        Vector right = up.cross(forward).unit();
        Vector trueUp = forward.cross(right);
        return new Basis(right.x(), right.y(), right.z(), trueUp.x(), trueUp.y(), trueUp.z(),
            forward.x(), forward.y(), forward.z());
    }

    /**
     * Axes of the plane perpendicular to a direction: the shortest rotation that takes +y to {@code n}, applied to
     * z and x. The result turns smoothly with {@code n} everywhere except at -y, where no such rule can be smooth.
     *
     * <p>With a = 1 / (1 + n.y) the rotated x is (1 - n.x n.x a, -n.x, -n.x n.z a), and so on. For n.y below 0 the
     * sum 1 + n.y cancels, so a comes from (1 + n.y)(1 - n.y) = n.x n.x + n.z n.z.
     *
     * @param n unit vector
     * @return a basis with w = n; perpendicular and unit to within 8 ulp of 1 (measured in {@code BasisTest})
     */
    public static Basis around(Vector n) {
        double squaredSine = n.x() * n.x() + n.z() * n.z();
        double xx;
        double xz;
        double zz;
        if (n.y() < 0 && squaredSine < STRAIGHT_DOWN) {
            xx = 0;                          // the limit of the formula for n.x = 0, n.z to 0
            xz = 0;
            zz = 2;
        } else {
            double a = n.y() >= 0 ? 1 / (1 + n.y()) : (1 - n.y()) / squaredSine;
            xx = n.x() * n.x() * a;
            xz = n.x() * n.z() * a;
            zz = n.z() * n.z() * a;
        }
        return new Basis(-xz, -n.z(), 1 - zz, 1 - xx, -n.x(), -xz, n.x(), n.y(), n.z());
    }

    /**
     * First axis.
     *
     * @return unit vector
     */
    public Vector u() {
        return new Vector(ux, uy, uz);
    }

    /**
     * Second axis.
     *
     * @return unit vector
     */
    public Vector v() {
        return new Vector(vx, vy, vz);
    }

    /**
     * Third axis.
     *
     * @return unit vector
     */
    public Vector w() {
        return new Vector(wx, wy, wz);
    }
}
