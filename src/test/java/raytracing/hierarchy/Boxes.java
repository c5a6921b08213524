package raytracing.hierarchy;

import java.util.SplittableRandom;
import raytracing.parallel.ForkJoin;

/** Groups of boxes for the tests of hierarchies, six numbers each, and the hierarchy over them. */
record Boxes(double[] numbers, Hierarchy hierarchy) {
    static Boxes of(double... numbers) {
        return of(numbers, ForkJoin.sequential());
    }

    static Boxes of(double[] numbers, ForkJoin workers) {
        return new Boxes(numbers, Hierarchy.over(bounds(numbers), workers));
    }

    /** The boxes in floats, rounded outwards where they are none. */
    static Bounds bounds(double[] numbers) {
        Bounds bounds = new Bounds(numbers.length / Bounds.STRIDE);
        for (int i = 0; i < numbers.length; i++) {
            float nearest = (float) numbers[i];
            boolean isHigh = i % Bounds.STRIDE >= Bounds.TO_HIGH;
            boolean isInside = isHigh ? nearest < numbers[i] : nearest > numbers[i];
            float next = isHigh ? Math.nextUp(nearest) : Math.nextDown(nearest);
            float outside = isInside ? next : nearest;
            bounds.numbers()[i] = isHigh ? Math.max(outside, -Bounds.FAR) : Math.min(outside, Bounds.FAR);
        }
        return bounds;
    }

    /** Cubes of edges up to twice the size, everywhere in the cube from 0 to 1. */
    static double[] scattered(int n, double size) {
        SplittableRandom random = new SplittableRandom(n);
        double[] numbers = new double[Bounds.STRIDE * n];
        for (int i = 0; i < n; i++) {
            double half = size * random.nextDouble(0.1, 1);
            for (int axis = 0; axis < 3; axis++) {
                double centre = random.nextDouble();
                numbers[Bounds.STRIDE * i + axis] = centre - half;
                numbers[Bounds.STRIDE * i + axis + Bounds.TO_HIGH] = centre + half;
            }
        }
        return numbers;
    }

    /** Cubes around one centre, whose coordinates are not exact, with half edges from 1/2 to 1. */
    static double[] concentric(int n) {
        SplittableRandom random = new SplittableRandom(n);
        double[] centre = {1.0 / 3, 0.7, 0.1};
        double[] numbers = new double[Bounds.STRIDE * n];
        for (int i = 0; i < n; i++) {
            double half = random.nextDouble(0.5, 1);
            for (int axis = 0; axis < 3; axis++) {
                numbers[Bounds.STRIDE * i + axis] = centre[axis] - half;
                numbers[Bounds.STRIDE * i + axis + Bounds.TO_HIGH] = centre[axis] + half;
            }
        }
        return numbers;
    }

    /** Unit cubes side by side, n along each axis, from (0, 0, 0) to (n, n, n). */
    static double[] grid(int n) {
        double[] numbers = new double[Bounds.STRIDE * n * n * n];
        for (int i = 0; i < n * n * n; i++) {
            int[] low = {i % n, i / n % n, i / n / n};
            for (int axis = 0; axis < 3; axis++) {
                numbers[Bounds.STRIDE * i + axis] = low[axis];
                numbers[Bounds.STRIDE * i + axis + Bounds.TO_HIGH] = low[axis] + 1;
            }
        }
        return numbers;
    }

    static double[] scaled(double[] numbers, double factor) {
        double[] scaled = numbers.clone();
        for (int i = 0; i < scaled.length; i++) {
            scaled[i] *= factor;
        }
        return scaled;
    }

    int size() {
        return numbers.length / Bounds.STRIDE;
    }

    double low(int body, int axis) {
        return numbers[Bounds.STRIDE * body + axis];
    }

    double high(int body, int axis) {
        return numbers[Bounds.STRIDE * body + axis + Bounds.TO_HIGH];
    }
}
