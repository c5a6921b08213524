package raytracing.area;

/**
 * The area between an arc of a conic and its chord, as a multiple of the triangle over the chord whose third corner is
 * the arc's apex: the point furthest from the chord. It depends on one number alone.
 *
 * <p>Put affine axes so that the chord's ends are (-1, 0) and (1, 0) and the apex (0, 1). There the arc is
 * x x = (1 - y)(1 + c y): part of an ellipse for c above 0, of a circle for 1, of a parabola for 0, of a hyperbola
 * below 0. The area under it is twice the integral of the root from 0 to 1,
 * F(c) = ((1 + c)^2 G(c) - (1 - c)) / (2 c) with G(c) = arctan(sqrt c) / sqrt c, continued analytically to c below 0.
 * Our derivation: on a circle, c is the squared tangent of a quarter of the arc.
 */
final class ConicSegment {
    /** Below this, the series; its terms fall at least by this factor from one to the next. */
    private static final double SMALL = 1 / 16.0;
    private static final int TERMS = 12;
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
     * The area F(c) between arc and chord, in multiples of the triangle between chord and apex. Only + - * / and square
     * roots, so the same on every machine.
     *
     * @param c shape of the arc, at least -1
     * @return at least 1, 4/3 of a parabola and pi/2 of half an ellipse; relative error below 2^-47 (measured in
     *         {@code ConicSegmentTest})
     */
    static double areaFactor(double c) {
        if (Math.abs(c) < SMALL) {
            return series(c);
        }
        if (!(c > -1)) {
            return 1;                        // two straight lines, rounded
        }
        return ((1 + c) * (1 + c) * arctangentRatio(c) - (1 - c)) / (2 * c);
    }

    /** 4/3 plus c times the sum over n from 0 of 4 (-c)^n / ((2n + 1)(2n + 3)(2n + 5)). */
    private static double series(double c) {
        return 4 / 3.0 + c * alternating(AREA_SERIES, c);
    }

    /** The sum of coefficient[n] (-c)^n. Even and odd powers apart, so that one need not wait for the other. */
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
     * series takes over.
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
