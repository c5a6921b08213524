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

    /** The cross product, by the right-hand rule of the coordinates: x cross y is z. */
    public DyadicVector cross(DyadicVector other) {
        return new DyadicVector(y.times(other.z).minus(z.times(other.y)), z.times(other.x).minus(x.times(other.z)),
            x.times(other.y).minus(y.times(other.x)));
    }

    public boolean isZero() {
        return x.signum() == 0 && y.signum() == 0 && z.signum() == 0;
    }

    /**
     * A vector of doubles in the same direction, each coordinate rounded once, its largest near 1; not of a zero vector.
     */
    public Vector direction() {
        int exponent = Math.max(exponent(x), Math.max(exponent(y), exponent(z)));
        return new Vector(scaled(x, exponent), scaled(y, exponent), scaled(z, exponent));
    }

    private static int exponent(Dyadic number) {
        return number.signum() == 0 ? Integer.MIN_VALUE : number.exponent() + number.significand().bitLength();
    }

    private static double scaled(Dyadic number, int exponent) {
        return number.signum() == 0 ? 0 : new Dyadic(number.significand(), number.exponent() - exponent).doubleValue();
    }

    /** |x| + |y| + |z|. */
    public Dyadic sumOfSizes() {
        return x.abs().plus(y.abs()).plus(z.abs());
    }
}
