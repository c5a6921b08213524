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
}
