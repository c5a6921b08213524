package raytracing.math;

/**
 * The order in which a ray's sums run over the axes: the one along which the ray goes furthest comes last. Sums of three
 * rounded products depend on their order; with an order taken from the ray itself, and as the first two terms commute,
 * no answer depends on which axis is called x, unless the ray goes equally far along two of them.
 */
public enum AxisOrder {
    /** y, z, x. */
    X_LAST,
    /** z, x, y. */
    Y_LAST,
    /** x, y, z. */
    Z_LAST;

    /**
     * The order for a ray.
     *
     * @param dx direction of the ray, x part
     * @param dy y part
     * @param dz z part
     * @return the order with the ray's main axis last
     */
    public static AxisOrder of(double dx, double dy, double dz) {
        double x = Math.abs(dx);
        double y = Math.abs(dy);
        double z = Math.abs(dz);
        if (z >= x && z >= y) {
            return Z_LAST;
        }
        return x >= y ? X_LAST : Y_LAST;
    }

    /**
     * A vector's parts in this order.
     *
     * @param vector x, y and z part
     * @return the same three numbers, that of the main axis last
     */
    public Vector sorted(Vector vector) {
        return new Vector(first(vector.x(), vector.y(), vector.z()), first(vector.y(), vector.z(), vector.x()),
            first(vector.z(), vector.x(), vector.y()));
    }

    /**
     * The first in this order of three numbers that belong to the axes; that of (y, z, x) is the second, and that of
     * (z, x, y) the last.
     *
     * @param x what belongs to the x axis
     * @param y what belongs to the y axis
     * @param z what belongs to the z axis
     * @return one of them
     */
    public double first(double x, double y, double z) {
        return this == Z_LAST ? x : this == X_LAST ? y : z;
    }

    /**
     * The same for rows of numbers.
     *
     * @param x what belongs to the x axis
     * @param y what belongs to the y axis
     * @param z what belongs to the z axis
     * @return one of them
     */
    public double[] first(double[] x, double[] y, double[] z) {
        return this == Z_LAST ? x : this == X_LAST ? y : z;
    }
}
