package raytracing.area;

import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;

/**
 * Integrals to nearly all digits, of functions that are smooth but for the places given. Ends where a root begins do no
 * harm: the points crowd there (the double exponential rule).
 */
final class Quadrature {
    private static final int STEPS = 160;
    private static final double FURTHEST = 3.6;

    private Quadrature() {
    }

    /** The integral from the least to the greatest of the places, each piece between two of them by itself. */
    static double integral(DoubleUnaryOperator function, double... places) {
        double[] sorted = places.clone();
        Arrays.sort(sorted);
        double sum = 0;
        for (int i = 1; i < sorted.length; i++) {
            sum += overPiece(function, sorted[i - 1], sorted[i] - sorted[i - 1]);
        }
        return sum;
    }

    private static double overPiece(DoubleUnaryOperator function, double from, double length) {
        if (length == 0) {
            return 0;
        }
        double step = 2 * FURTHEST / STEPS;
        double sum = 0;
        for (int i = 0; i <= STEPS; i++) {
            double u = i * step - FURTHEST;
            double exponent = Math.PI * Math.sinh(u);
            double share = 1 / (1 + Math.exp(-exponent));
            double rest = 1 / (1 + Math.exp(exponent));
            sum += function.applyAsDouble(from + share * length) * Math.PI * Math.cosh(u) * share * rest;
        }
        return length * step * sum;
    }
}
