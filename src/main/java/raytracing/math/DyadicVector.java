package raytracing.math;

import java.math.BigDecimal;

/**
 * A vector of exact numbers: every double is a decimal with finitely many digits, and so are sums and products of them.
 * It decides what no fixed precision can. Slow, and hardly ever asked. Immutable.
 *
 * @param x x part
 * @param y y part
 * @param z z part
 */
public record DecimalVector(BigDecimal x, BigDecimal y, BigDecimal z) {
    /**
     * A vector of doubles, unchanged.
     *
     * @param vector finite parts
     * @return the same vector
     */
    public static DecimalVector of(Vector vector) {
        return new DecimalVector(new BigDecimal(vector.x()), new BigDecimal(vector.y()), new BigDecimal(vector.z()));
    }

    /**
     * Difference.
     *
     * @param other subtrahend
     * @return this - other
     */
    public DecimalVector minus(DecimalVector other) {
        return new DecimalVector(x.subtract(other.x), y.subtract(other.y), z.subtract(other.z));
    }

    /**
     * Dot product.
     *
     * @param other any vector
     * @return this . other
     */
    public BigDecimal dot(DecimalVector other) {
        return x.multiply(other.x).add(y.multiply(other.y)).add(z.multiply(other.z));
    }
}
