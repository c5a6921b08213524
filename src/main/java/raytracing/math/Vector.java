package raytracing.math;

/**
 * A point, a displacement or a direction in world axes: x, y and z in scene units. Immutable.
 *
 * @param x x part
 * @param y y part
 * @param z z part
 */
public record Vector(double x, double y, double z) {
    /** The origin of the world, and the zero displacement. */
    public static final Vector ZERO = new Vector(0, 0, 0);

    /**
     * Squared lengths between these carry no trace of overflow or of subnormal squares: beside a sum of 2^-900, the
     * error of a subnormal square, at most 2^-1075, is far below rounding. Beyond them, a shift brings every vector
     * but the zero one to where its square is a normal number.
     */
    private static final double SMALL_SQUARE = 0x1p-900;
    private static final double LARGE_SQUARE = 0x1p1000;
    private static final double SHIFT = 0x1p600;

    /**
     * Sum, part by part.
     *
     * @param other summand
     * @return this + other
     */
    public Vector plus(Vector other) {
        return new Vector(x + other.x, y + other.y, z + other.z);
    }

    /**
     * Difference, part by part.
     *
     * @param other subtrahend
     * @return this - other
     */
    public Vector minus(Vector other) {
        return new Vector(x - other.x, y - other.y, z - other.z);
    }

    /**
     * Product with a number.
     *
     * @param factor any number
     * @return factor times this
     */
    public Vector times(double factor) {
        return new Vector(factor * x, factor * y, factor * z);
    }

    /**
     * The point reached from here.
     *
     * @param distance how many times {@code direction} to go
     * @param direction where to
     * @return this + distance times direction
     */
    public Vector plus(double distance, Vector direction) {
        return new Vector(x + distance * direction.x, y + distance * direction.y, z + distance * direction.z);
    }

    /**
     * The opposite vector.
     *
     * @return this times -1
     */
    public Vector negated() {
        return new Vector(-x, -y, -z);
    }

    /**
     * Whether this is no displacement at all, and so has no direction.
     *
     * @return true if every part is 0 or -0
     */
    public boolean isZero() {
        return x == 0 && y == 0 && z == 0;
    }

    /**
     * Maximum norm.
     *
     * @return size of the part furthest from 0
     */
    public double largestPart() {
        return largestPart(x, y, z);
    }

    /**
     * The maximum norm of a vector given by its parts.
     *
     * @param x x part
     * @param y y part
     * @param z z part
     * @return size of the part furthest from 0
     */
    public static double largestPart(double x, double y, double z) {
        return Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
    }

    /**
     * Dot product.
     *
     * @param other any vector
     * @return |this| |other| cos(angle between them)
     */
    public double dot(Vector other) {
        return x * other.x + y * other.y + z * other.z;
    }

    /**
     * Cross product, by the right-hand rule of the coordinates: x cross y is z.
     *
     * @param other any vector
     * @return a vector perpendicular to both, |this| |other| sin(angle between them) long
     */
    public Vector cross(Vector other) {
        return new Vector(y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x);
    }

    /**
     * Euclidean length, free of overflow and underflow wherever the length itself is a double.
     *
     * @return the length, at least 0; error at most 3 ulp (proved: two roundings in each square and sum,
     *         halved by the root, and its own)
     */
    public double length() {
        return length(x, y, z);
    }

    /**
     * The Euclidean length of a vector given by its parts.
     *
     * @param x x part
     * @param y y part
     * @param z z part
     * @return the length, as {@link #length()} gives it
     */
    public static double length(double x, double y, double z) {
        double scale = safeScale(x, y, z);
        return Math.sqrt(square(scale * x, scale * y, scale * z)) / scale;
    }

    /**
     * The vector of length 1 in this direction.
     *
     * @return this / |this|; each part's error is below 4 ulp of 1 (measured in {@code VectorTest})
     * @throws ArithmeticException if this vector is zero or not finite, as it then has no direction
     */
    public Vector unit() {
        double scale = safeScale(x, y, z);
        double factor = unitFactor(scale * x, scale * y, scale * z);
        return new Vector(scale * x * factor, scale * y * factor, scale * z * factor);
    }

    /**
     * A power of two: multiplying by it brings the square of a vector into the range of normal numbers.
     *
     * @param x x part
     * @param y y part
     * @param z z part
     * @return 1 for all but very long and very short vectors
     */
    public static double safeScale(double x, double y, double z) {
        double square = square(x, y, z);
        if (square < SMALL_SQUARE) {
            return SHIFT;
        }
        return square > LARGE_SQUARE ? 1 / SHIFT : 1;
    }

    /**
     * What makes a vector a unit vector.
     *
     * @param x x part, scaled by {@link #safeScale}
     * @param y y part, likewise
     * @param z z part, likewise
     * @return one over the length
     * @throws ArithmeticException if the vector is zero or not finite, as it then has no direction
     */
    public static double unitFactor(double x, double y, double z) {
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
