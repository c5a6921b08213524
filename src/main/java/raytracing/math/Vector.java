package raytracing.math;

/** A point, a displacement or a direction in world axes: x, y and z in scene units. Immutable. */
public record Vector(double x, double y, double z) {
    /** The origin of the world, and the zero displacement. */
    public static final Vector ZERO = new Vector(0, 0, 0);

    /**
     * Squared lengths between these carry no trace of overflow or of subnormal squares: next to a sum of 2^-900, the error of
     * a subnormal square, at most 2^-1075, is far below rounding. Beyond them, a shift brings every vector but the zero one to
     * where its square is a normal number.
     */
    private static final double SMALL_SQUARE = 0x1p-900;
    private static final double LARGE_SQUARE = 0x1p1000;
    private static final double SHIFT = 0x1p600;

    public Vector minus(Vector other) {
        return new Vector(x - other.x, y - other.y, z - other.z);
    }

    public Vector times(double factor) {
        return new Vector(factor * x, factor * y, factor * z);
    }

    /** Whether every coordinate is 0 or -0, so that there is no direction. */
    public boolean isZero() {
        return x == 0 && y == 0 && z == 0;
    }

    /**
     * Whether another vector is the same point: 0 and -0 are, unlike for {@link #equals}, which the virtual machine makes at
     * its first call, from sixty classes.
     */
    public boolean isSameAs(Vector other) {
        return x == other.x && y == other.y && z == other.z;
    }

    /** The maximum norm: the size of the coordinate furthest from 0. */
    public double largestPart() {
        return largestPart(x, y, z);
    }

    /** The maximum norm of a vector that is given by its coordinates. */
    public static double largestPart(double x, double y, double z) {
        return Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
    }

    public double dot(Vector other) {
        return x * other.x + y * other.y + z * other.z;
    }

    /** The cross product, by the right-hand rule of the coordinates: x cross y is z. */
    public Vector cross(Vector other) {
        return new Vector(y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x);
    }

    /**
     * The Euclidean length, free of overflow and underflow wherever the length itself is a double. The error is at most
     * 3 ulp (proved: two roundings in each square and sum, halved by the root, and its own).
     */
    public double length() {
        return length(x, y, z);
    }

    /** The length of a vector that is given by its coordinates, as {@link #length()} computes it. */
    public static double length(double x, double y, double z) {
        double scale = safeScale(x, y, z);
        return Math.sqrt(square(scale * x, scale * y, scale * z)) / scale;
    }

    /**
     * The vector of length 1 in this direction, as {@link UnitVector} computes it.
     *
     * @throws ArithmeticException if this vector is zero or not finite, as it then has no direction
     */
    public Vector unit() {
        UnitVector unit = new UnitVector();
        unit.set(x, y, z);
        return new Vector(unit.x(), unit.y(), unit.z());
    }

    /**
     * A power of two by which to multiply a vector, so that its square is in the range of normal numbers: 1 for all but
     * very long and very short vectors.
     */
    static double safeScale(double x, double y, double z) {
        double square = square(x, y, z);
        if (square < SMALL_SQUARE) {
            return SHIFT;
        }
        return square > LARGE_SQUARE ? 1 / SHIFT : 1;
    }

    /** One over the length of a vector that was scaled by {@link #safeScale}; fails for vectors without a direction. */
    static double unitFactor(double x, double y, double z) {
        double square = square(x, y, z);
        if (!(square > 0 && square < Double.POSITIVE_INFINITY)) {
            throw new ArithmeticException("no direction: " + x + ", " + y + ", " + z);
        }
        return 1 / Math.sqrt(square);
    }

    private static double square(double x, double y, double z) {
        return x * x + y * y + z * z;
    }
}
