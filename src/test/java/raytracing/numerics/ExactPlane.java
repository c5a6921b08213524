package raytracing.numerics;

import java.math.BigDecimal;
import java.util.Optional;
import raytracing.math.ExactVector;

/** Ray against plane in exact arithmetic. */
final class ExactPlane {
    private ExactPlane() {
    }

    /** The point where the line crosses the plane N . P = c, or nothing where it runs along or inside it. */
    static Optional<ExactChord> chord(Query query) {
        ExactVector normal = ExactVector.of(query.vector());
        BigDecimal approach = normal.dot(ExactVector.of(query.direction()));
        if (approach.signum() == 0) {
            return Optional.empty();
        }
        BigDecimal ahead = new BigDecimal(query.scalar()).subtract(normal.dot(ExactVector.of(query.origin())));
        BigDecimal t = ahead.divide(approach, ExactChord.DIGITS);
        return Optional.of(new ExactChord(t, t));
    }

    /** How far a point is from the plane, on either side. */
    static BigDecimal distance(ExactVector point, ExactVector normal, BigDecimal offset) {
        return normal.dot(point).subtract(offset).abs().divide(normal.length(), ExactChord.DIGITS);
    }
}
