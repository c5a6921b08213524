package raytracing.math;

/** A vector of exact numbers. Immutable. */
public record DyadicVector(Dyadic x, Dyadic y, Dyadic z) {
    /** The same vector as one of finite doubles. */
    public static DyadicVector of(Vector vector) {
        return new DyadicVector(Dyadic.of(vector.x()), Dyadic.of(vector.y()), Dyadic.of(vector.z()));
    }

    public DyadicVector minus(DyadicVector other) {
        return new DyadicVector(x.minus(other.x), y.minus(other.y), z.minus(other.z));
    }

    public Dyadic dot(DyadicVector other) {
        return x.times(other.x).plus(y.times(other.y)).plus(z.times(other.z));
    }

    /** |x| + |y| + |z|. */
    public Dyadic sumOfSizes() {
        return x.abs().plus(y.abs()).plus(z.abs());
    }
}
