package raytracing.math;

/** A vector of length 1 that can be set again and again without allocation. Not thread-safe. */
public final class UnitVector {
    private double x;
    private double y;
    private double z;

    /**
     * Sets this to the direction of a vector. The error of each coordinate is below 4 ulp of 1 (measured in
     * {@code VectorTest}).
     *
     * @throws ArithmeticException if the vector is zero or not finite, as it then has no direction
     */
    public void set(double vx, double vy, double vz) {
        double scale = Vector.safeScale(vx, vy, vz);
        double factor = Vector.unitFactor(scale * vx, scale * vy, scale * vz);
        x = scale * vx * factor;
        y = scale * vy * factor;
        z = scale * vz * factor;
    }

    public void set(UnitVector other) {
        x = other.x;
        y = other.y;
        z = other.z;
    }

    /** Turns this to the opposite direction. */
    public void negate() {
        x = -x;
        y = -y;
        z = -z;
    }

    /** The dot product with any vector: the length of its component in this direction, below 0 if it points the other way. */
    public double dot(double vx, double vy, double vz) {
        return x * vx + y * vy + z * vz;
    }

    public double x() {
        return x;
    }

    public double y() {
        return y;
    }

    public double z() {
        return z;
    }
}
