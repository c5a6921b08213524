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
        double scale = safeScale();
        return Math.sqrt(squareOfScaled(scale)) / scale;
    }

    /**
     * The vector of length 1 in this direction.
     *
     * @return this / |this|; each part's error is below 4 ulp of 1 (measured in {@code VectorTest})
     * @throws ArithmeticException if this vector is zero or not finite, as it then has no direction
     */
    public Vector unit() {
        double scale = safeScale();
        double square = squareOfScaled(scale);
        if (!(square > 0 && square < Double.POSITIVE_INFINITY)) {
            throw new ArithmeticException("no direction: " + this);
        }
        double factor = 1 / Math.sqrt(square);
        return new Vector(scale * x * factor, scale * y * factor, scale * z * factor);
    }

    /** A power of two: multiplying by it brings the square of this vector into the range of normal numbers. */
    private double safeScale() {
        double square = dot(this);
        if (square < SMALL_SQUARE) {
            return SHIFT;
        }
        return square > LARGE_SQUARE ? 1 / SHIFT : 1;
    }

    private double squareOfScaled(double scale) {
        double sx = scale * x;
        double sy = scale * y;
        double sz = scale * z;
        return sx * sx + sy * sy + sz * sz;
    }
}
