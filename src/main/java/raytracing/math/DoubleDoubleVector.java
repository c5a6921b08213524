package raytracing.math;

/**
 * A vector of double-doubles, for the few rays that doubles cannot decide. Immutable. Sums of products have an absolute
 * error of at most 2^-101 times the sum of the products' sizes (proved from the bounds of {@link DoubleDouble}: 4 u^2
 * for each product, 3 u^2 for each sum), as long as nothing leaves the range of normal numbers.
 *
 * @param x x part
 * @param y y part
 * @param z z part
 */
public record DoubleDoubleVector(DoubleDouble x, DoubleDouble y, DoubleDouble z) {
    /**
     * The exact way from one point to another.
     *
     * @param from start
     * @param to end
     * @return to - from, no error
     */
    public static DoubleDoubleVector between(Vector from, Vector to) {
        return new DoubleDoubleVector(DoubleDouble.difference(to.x(), from.x()),
            DoubleDouble.difference(to.y(), from.y()), DoubleDouble.difference(to.z(), from.z()));
    }

    /**
     * A vector of doubles, unchanged.
     *
     * @param vector any vector
     * @return the same vector
     */
    public static DoubleDoubleVector of(Vector vector) {
        return new DoubleDoubleVector(new DoubleDouble(vector.x(), 0), new DoubleDouble(vector.y(), 0),
            new DoubleDouble(vector.z(), 0));
    }

    /**
     * Dot product.
     *
     * @param other any vector
     * @return this . other
     */
    public DoubleDouble dot(DoubleDoubleVector other) {
        return x.times(other.x).plus(y.times(other.y)).plus(z.times(other.z));
    }

    /**
     * Cross product.
     *
     * @param other any vector
     * @return this x other
     */
    public DoubleDoubleVector cross(DoubleDoubleVector other) {
        return new DoubleDoubleVector(y.times(other.z).minus(z.times(other.y)),
            z.times(other.x).minus(x.times(other.z)), x.times(other.y).minus(y.times(other.x)));
    }
}
