package raytracing.numerics;

/** A vector of {@link DoubleDouble} numbers. */
record DoubleDoubleVector(DoubleDouble x, DoubleDouble y, DoubleDouble z) {
    static DoubleDoubleVector of(double x, double y, double z) {
        return new DoubleDoubleVector(DoubleDouble.of(x), DoubleDouble.of(y), DoubleDouble.of(z));
    }

    /** The way from one point to another, without an error. */
    static DoubleDoubleVector between(double fromX, double fromY, double fromZ, double toX, double toY, double toZ) {
        return new DoubleDoubleVector(DoubleDouble.difference(toX, fromX), DoubleDouble.difference(toY, fromY),
            DoubleDouble.difference(toZ, fromZ));
    }

    DoubleDouble dot(DoubleDoubleVector other) {
        return x.times(other.x).plus(y.times(other.y)).plus(z.times(other.z));
    }

    DoubleDoubleVector cross(DoubleDoubleVector other) {
        return new DoubleDoubleVector(y.times(other.z).minus(z.times(other.y)), z.times(other.x).minus(x.times(other.z)),
            x.times(other.y).minus(y.times(other.x)));
    }
}
