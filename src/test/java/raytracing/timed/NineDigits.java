package raytracing.timed;

import java.math.BigDecimal;
import java.math.MathContext;
import raytracing.math.Vector;

/**
 * Numbers as scene files have them. A made scene is rounded before it is used, so that its file says neither more nor
 * less than the scene, and is no longer to read than one by hand.
 */
final class NineDigits {
    private static final MathContext DIGITS = new MathContext(9);

    private NineDigits() {
    }

    static double of(double number) {
        return BigDecimal.valueOf(number).round(DIGITS).doubleValue();
    }

    static Vector of(Vector vector) {
        return new Vector(of(vector.x()), of(vector.y()), of(vector.z()));
    }
}
