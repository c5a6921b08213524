package raytracing.math;

/**
 * A vector of exact numbers. Immutable.
 *
 * @param x x part
 * @param y y part
 * @param z z part
 */
public record DyadicVector(Dyadic x, Dyadic y, Dyadic z) {
    /**
     * A vector of doubles, unchanged.
     *
     * @param vector finite parts
     * @return the same vector
     */
    public static DyadicVector of(Vector vector) {
        return new DyadicVector(Dyadic.of(vector.x()), Dyadic.of(vector.y()), Dyadic.of(vector.z()));
    }

    /**
     * Difference.
     *
     * @param other subtrahend
     * @return this - other
     */
    public DyadicVector minus(DyadicVector other) {
        return new DyadicVector(x.minus(other.x), y.minus(other.y), z.minus(other.z));
    }

    /**
     * Dot product.
     *
     * @param other any vector
     * @return this . other
     */
    public Dyadic dot(DyadicVector other) {
        return x.times(other.x).plus(y.times(other.y)).plus(z.times(other.z));
    }

    /**
     * Sum of the sizes of the parts.
     *
     * @return |x| + |y| + |z|
     */
    public Dyadic sumOfSizes() {
        return x.abs().plus(y.abs()).plus(z.abs());
    }
}
