package raytracing.math;

import java.math.BigDecimal;
import java.math.MathContext;

/** A vector in exact decimal arithmetic: the oracle of the tests. Only roots and quotients round, to 120 digits. */
public record ExactVector(BigDecimal x, BigDecimal y, BigDecimal z) {
    public static final MathContext DIGITS = new MathContext(120);

    public static ExactVector of(Vector v) {
        return new ExactVector(new BigDecimal(v.x()), new BigDecimal(v.y()), new BigDecimal(v.z()));
    }

    public ExactVector minus(ExactVector other) {
        return new ExactVector(x.subtract(other.x), y.subtract(other.y), z.subtract(other.z));
    }

    public ExactVector plus(BigDecimal t, ExactVector d) {
        return new ExactVector(x.add(t.multiply(d.x)), y.add(t.multiply(d.y)), z.add(t.multiply(d.z)));
    }

    public BigDecimal dot(ExactVector other) {
        return x.multiply(other.x).add(y.multiply(other.y)).add(z.multiply(other.z));
    }

    public BigDecimal length() {
        return dot(this).sqrt(DIGITS);
    }
}
