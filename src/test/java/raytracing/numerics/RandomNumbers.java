package raytracing.numerics;

import java.util.SplittableRandom;
import raytracing.math.Vector;

/** What random rays and surfaces are made of. Built from exact operations only: the same numbers on every machine. */
record RandomNumbers(SplittableRandom random) {
    boolean oneIn(int n) {
        return random.nextInt(n) == 0;
    }

    /** 1 or -1. */
    double sign() {
        return random.nextBoolean() ? 1 : -1;
    }

    /** 0 or -0. */
    double zero() {
        return random.nextBoolean() ? 0.0 : -0.0;
    }

    double between(double low, double high) {
        return random.nextDouble(low, high);
    }

    /** A number above 0 whose power of two is uniform: from 2^lowest up to below 2^highest. */
    double magnitude(int lowest, int highest) {
        return Math.scalb(random.nextDouble(1, 2), random.nextInt(lowest, highest));
    }

    double powerOfTwo(int lowest, int highest) {
        return Math.scalb(1, random.nextInt(lowest, highest));
    }

    /** Every part between -size and size. */
    Vector vector(double size) {
        return new Vector(between(-size, size), between(-size, size), between(-size, size));
    }

    /** A unit vector. */
    Vector direction() {
        return vector(1).unit();
    }

    /** A unit vector at a right angle, but for rounding. */
    Vector perpendicularTo(Vector axis) {
        return axis.cross(vector(1)).unit();
    }

    /** Every part an eighth of an integer, so that few sums and products round at all. */
    Vector eighths(int most) {
        return new Vector(eighth(most), eighth(most), eighth(most));
    }

    private double eighth(int most) {
        return random.nextInt(1, 8 * most) * sign() / 8;
    }

    int axis() {
        return random.nextInt(3);
    }

    /** From a point, an ordinary ray. */
    Line line() {
        return new Line(vector(10), direction());
    }
}
