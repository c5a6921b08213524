package raytracing.area;

/**
 * The area between an arc of a conic and its chord. As a multiple of the triangle between the chord and the arc's apex, the
 * point furthest from the chord, it depends on one number only.
 *
 * <p>Choose affine axes such that the chord's ends are (-1, 0) and (1, 0) and the apex (0, 1). There the arc is
 * x x = (1 - y)(1 + c y): part of an ellipse for c above 0, of a circle for 1, of a parabola for 0, of a hyperbola
 * below 0. The area under it is twice the integral of the root from 0 to 1,
 * F(c) = ((1 + c)^2 G(c) - (1 - c)) / (2 c) with G(c) = arctan(sqrt c) / sqrt c, continued analytically to c below 0.
 * This is our derivation; on a circle, c is the squared tangent of a quarter of the arc.
 */
final class ConicSegment {
    /** Below this the series is used; each term is at most this times the one before. */
    private static final double SMALL = 1 / 16.0;
    private static final int TERMS = 12;

    /** F(c) is 4/3 plus c times the sum over n from 0 of 4 (-c)^n / ((2n + 1)(2n + 3)(2n + 5)). */
    private static final double[] AREA_SERIES = new double[TERMS];
    private static final double[] ARCTANGENT_SERIES = new double[TERMS];

    static {
        for (int n = 0; n < TERMS; n++) {
            AREA_SERIES[n] = 4.0 / ((2 * n + 1) * (2 * n + 3) * (2 * n + 5));
            ARCTANGENT_SERIES[n] = 1.0 / (2 * n + 1);
        }
    }

    private ConicSegment() {
    }

    /**
     * The area F(c), for a shape of at least -1: at least 1, 4/3 for a parabola and pi/2 for half an ellipse. The relative
     * error is below 2^-47 (measured in {@code ConicSegmentTest}). It is computed with + - * / and square roots only, so it is
     * the same on every machine.
     */
    static double areaFactor(double c) {
        if (Math.abs(c) < SMALL) {
            return 4 / 3.0 + c * alternating(AREA_SERIES, c);
        }
        if (!(c > -1)) {
            return 1;                        // two straight lines, rounded
        }
        return ((1 + c) * (1 + c) * arctangentRatio(c) - (1 - c)) / (2 * c);
    }

    /** The sum of coefficient[n] (-c)^n; even and odd powers separately, so that the processor can overlap them. */
    private static double alternating(double[] coefficients, double c) {
        double square = c * c;
        double even = 0;
        double odd = 0;
        for (int n = TERMS - 2; n >= 0; n -= 2) {
            even = coefficients[n] + square * even;
            odd = coefficients[n + 1] + square * odd;
        }
        return even - c * odd;
    }

    /**
     * G(c) = arctan(t) / t with c = t t. The angle is halved, arctan(t) = 2 arctan(t / (1 + sqrt(1 + t t))), until the
     * series can be used.
     */
    private static double arctangentRatio(double c) {
        double factor = 1;
        double rest = c;
        while (Math.abs(rest) > SMALL) {
            double divisor = 1 + Math.sqrt(1 + rest);
            factor *= 2 / divisor;
            rest /= divisor * divisor;
        }
        return factor * alternating(ARCTANGENT_SERIES, rest);
    }
}
