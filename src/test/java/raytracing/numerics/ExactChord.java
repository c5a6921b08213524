package raytracing.numerics;

import java.math.BigDecimal;
import java.math.MathContext;

/**
 * The stretch of a line inside a closed body, from t = near to t = far; of a plane, a single point. The signs of both
 * ends, and whether they are equal, are exact; their values are rounded to {@link #DIGITS}.
 */
record ExactChord(BigDecimal near, BigDecimal far) {
    static final MathContext DIGITS = new MathContext(60);

    static ExactChord between(BigDecimal s, BigDecimal t) {
        return new ExactChord(s.min(t), s.max(t));
    }

    /** Which end a ray from t = 0 meets first. */
    Root firstRoot() {
        if (near.signum() > 0) {
            return Root.NEAR;
        }
        return far.signum() > 0 ? Root.FAR : Root.NONE;
    }

    ExactAnswer answer() {
        return switch (firstRoot()) {
            case NEAR -> new ExactAnswer(aboveZero(near), far.doubleValue());
            case FAR -> new ExactAnswer(aboveZero(far), near.doubleValue());
            case NONE -> ExactAnswer.NO_CROSSING;
        };
    }

    /** A crossing is neither 0 nor infinite, even where doubles are: the outermost double stands for it. */
    private static double aboveZero(BigDecimal crossing) {
        return Math.max(Double.MIN_VALUE, Math.min(Double.MAX_VALUE, crossing.doubleValue()));
    }

    enum Root { NONE, NEAR, FAR }
}
