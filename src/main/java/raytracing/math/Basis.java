package raytracing.math;

/**
 * Three unit vectors u, v, w, perpendicular to one another; u cross v is w. Turned again and again, for shading needs one for
 * every light at every point: so it makes no garbage. One thread.
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

    /** Not turned yet: all zero. */
    public Basis() {
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
        Basis basis = new Basis();
        basis.set(right.x(), right.y(), right.z(), trueUp.x(), trueUp.y(), trueUp.z(),
            forward.x(), forward.y(), forward.z());
        return basis;
    }

    /**
     * Axes of the plane perpendicular to a direction.
     *
     * @param direction that w takes; any length but 0
     * @return what {@link #turnTo} makes
     * @throws ArithmeticException if the direction is zero or not finite
     */
    public static Basis around(Vector direction) {
        Basis basis = new Basis();
        basis.turnTo(direction.x(), direction.y(), direction.z());
        return basis;
    }

    /**
     * Axes of the plane perpendicular to a direction n: the shortest rotation that takes +y to n, applied to z and x. The
     * result turns smoothly with n everywhere except at -y, where no such rule can be smooth.
     *
     * <p>With a = 1 / (1 + n.y) the rotated x is (1 - n.x n.x a, -n.x, -n.x n.z a), and so on. For n.y below 0 the
     * sum 1 + n.y cancels, so a comes from (1 + n.y)(1 - n.y) = n.x n.x + n.z n.z. The axes are perpendicular and unit to
     * within 8 ulp of 1 (measured in {@code BasisTest}).
     *
     * @param x direction that w takes, x part; any length but 0
     * @param y y part
     * @param z z part
     * @throws ArithmeticException if the direction is zero or not finite
     */
    public void turnTo(double x, double y, double z) {
        double scale = Vector.safeScale(x, y, z);
        double factor = Vector.unitFactor(scale * x, scale * y, scale * z);
        double nx = scale * x * factor;
        double ny = scale * y * factor;
        double nz = scale * z * factor;
        double squaredSine = nx * nx + nz * nz;
        double xx;
        double xz;
        double zz;
        if (ny < 0 && squaredSine < STRAIGHT_DOWN) {
            xx = 0;                          // the limit of the formula for n.x = 0, n.z to 0
            xz = 0;
            zz = 2;
        } else {
            double a = ny >= 0 ? 1 / (1 + ny) : (1 - ny) / squaredSine;
            xx = nx * nx * a;
            xz = nx * nz * a;
            zz = nz * nz * a;
        }
        set(-xz, -nz, 1 - zz, 1 - xx, -nx, -xz, nx, ny, nz);
    }

    private void set(double ux, double uy, double uz, double vx, double vy, double vz, double wx, double wy, double wz) {
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

    /**
     * First axis.
     *
     * @return its x part
     */
    public double ux() {
        return ux;
    }

    /**
     * First axis.
     *
     * @return its y part
     */
    public double uy() {
        return uy;
    }

    /**
     * First axis.
     *
     * @return its z part
     */
    public double uz() {
        return uz;
    }

    /**
     * Second axis.
     *
     * @return its x part
     */
    public double vx() {
        return vx;
    }

    /**
     * Second axis.
     *
     * @return its y part
     */
    public double vy() {
        return vy;
    }

    /**
     * Second axis.
     *
     * @return its z part
     */
    public double vz() {
        return vz;
    }

    /**
     * Third axis.
     *
     * @return its x part
     */
    public double wx() {
        return wx;
    }

    /**
     * Third axis.
     *
     * @return its y part
     */
    public double wy() {
        return wy;
    }

    /**
     * Third axis.
     *
     * @return its z part
     */
    public double wz() {
        return wz;
    }
}
