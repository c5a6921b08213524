package raytracing.area;

import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.DoubleStream;

/** The conics at their simplest, each the area between two functions of y. Any other is an affine image of one. */
enum CanonicalConic {
    /** x x + y y &lt;= 1. */
    DISC(-1, 0, 1) {
        @Override
        double left(double y) {
            return -right(y);
        }

        @Override
        double right(double y) {
            return Math.sqrt(Math.max(1 - y * y, 0));
        }

        @Override
        Tangent tangent(double along) {
            return new Tangent(Math.cos(3 * along), Math.sin(3 * along), Math.cos(3 * along), Math.sin(3 * along));
        }
    },

    /** x &gt;= y y. */
    PARABOLA(0, 0.5, 0) {
        @Override
        double left(double y) {
            return y * y;
        }

        @Override
        Tangent tangent(double along) {
            double length = Math.sqrt(1 + 4 * along * along);
            return new Tangent(along * along, along, -1 / length, 2 * along / length);
        }
    },

    /** x x - y y &gt;= 1 with x above 0. */
    HYPERBOLA(1, 0, -1) {
        @Override
        double left(double y) {
            return Math.sqrt(1 + y * y);
        }

        @Override
        Tangent tangent(double along) {
            double x = Math.sqrt(1 + along * along);
            double length = Math.sqrt(x * x + along * along);
            return new Tangent(x, along, -x / length, along / length);
        }
    };

    /** So that long pieces stay smooth for the quadrature. */
    private static final double[] PLACES_BETWEEN = {-27, -9, -3, -1, 0, 1, 3, 9, 27};

    /** Q(x, y) = xx x x - y y + 2 x0 x + c. */
    final double xx;
    final double x0;
    final double c;

    /** A point of the outline, and the unit vector that leads out of the figure there. */
    record Tangent(double x, double y, double outX, double outY) { }

    CanonicalConic(double xx, double x0, double c) {
        this.xx = xx;
        this.x0 = x0;
        this.c = c;
    }

    /** Where the figure begins at a height. */
    abstract double left(double y);

    /** Where it ends. */
    double right(double y) {
        return Double.POSITIVE_INFINITY;
    }

    /** The tangent at a place of the outline that the number chooses. */
    abstract Tangent tangent(double along);

    /**
     * The area that the figure has in common with a convex polygon: the integral over y of the common part of two
     * stretches.
     */
    double area(double[] cornersX, double[] cornersY) {
        double lowest = Arrays.stream(cornersY).min().getAsDouble();
        double highest = Arrays.stream(cornersY).max().getAsDouble();
        DoubleUnaryOperator width = y -> {
            double[] side = stretch(cornersX, cornersY, Math.max(lowest, Math.min(y, highest)));
            return Math.max(Math.min(side[1], right(y)) - Math.max(side[0], left(y)), 0);
        };
        double from = this == DISC ? Math.max(lowest, -1) : lowest;
        double to = this == DISC ? Math.min(highest, 1) : highest;
        return from < to ? Quadrature.integral(width, DoubleStream.concat(DoubleStream.of(from, to),
            kinks(cornersX, cornersY).filter(y -> from < y && y < to)).toArray()) : 0;
    }

    /** From where to where a polygon reaches at a height. */
    private static double[] stretch(double[] x, double[] y, double height) {
        double from = Double.POSITIVE_INFINITY;
        double to = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < x.length; i++) {
            int next = (i + 1) % x.length;
            if (y[i] != y[next] && (height - y[i]) * (height - y[next]) <= 0) {
                double place = x[i] + (height - y[i]) / (y[next] - y[i]) * (x[next] - x[i]);
                from = Math.min(from, place);
                to = Math.max(to, place);
            }
        }
        return new double[] {from, to};
    }

    /** The heights of corners, and those where a side crosses the outline. */
    private DoubleStream kinks(double[] x, double[] y) {
        DoubleStream all = DoubleStream.concat(DoubleStream.of(PLACES_BETWEEN), DoubleStream.of(y));
        for (int i = 0; i < x.length; i++) {
            int next = (i + 1) % x.length;
            double dx = x[next] - x[i];
            double dy = y[next] - y[i];
            double a = xx * dx * dx - dy * dy;
            double half = xx * x[i] * dx - y[i] * dy + x0 * dx;
            double rest = xx * x[i] * x[i] - y[i] * y[i] + 2 * x0 * x[i] + c;
            double sum = -half - Math.copySign(Math.sqrt(half * half - a * rest), half);
            all = DoubleStream.concat(all, DoubleStream.of(y[i] + dy * sum / a, y[i] + dy * rest / sum));
        }
        return all;
    }
}
