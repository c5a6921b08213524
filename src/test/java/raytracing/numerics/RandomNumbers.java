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
        return Math.scalb(1.0, random.nextInt(lowest, highest));
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

    /** A whole number between -most and most, never 0. */
    double whole(int most) {
        return random.nextInt(1, most + 1) * sign();
    }

    /** Every part such a number, or 0 for one in four. */
    Vector wholes(int most) {
        Vector v = new Vector(wholeOrZero(most), wholeOrZero(most), wholeOrZero(most));
        return v.isZero() ? wholes(most) : v;
    }

    private double wholeOrZero(int most) {
        return oneIn(4) ? zero() : whole(most);
    }

    /** A number moved by up to so many units in its last place; 0, by as many units of 2^-60. */
    double beside(double number, int ulps) {
        double unit = number == 0 ? 0x1p-60 : Math.ulp(number);
        return number + random.nextInt(-ulps, ulps + 1) * unit;
    }

    /** A point with one part moved by up to so many units in its last place. */
    Vector beside(Vector point, int ulps) {
        int axis = axis();
        return Axes.withPart(point, axis, beside(Axes.part(point, axis), ulps));
    }

    /** One query in three as it is, the others with one number moved by up to three units in its last place. */
    Query besideByUlps(Query query) {
        return switch (random.nextInt(6)) {
            case 0 -> new Query(beside(query.origin(), 3), query.direction(), query.vector(), query.scalar());
            case 1 -> query.withDirection(beside(query.direction(), 3));
            case 2 -> query.withVector(beside(query.vector(), 3));
            case 3 -> new Query(query.origin(), query.direction(), query.vector(), beside(query.scalar(), 3));
            default -> query;
        };
    }

    int axis() {
        return random.nextInt(3);
    }

    /** From a point, an ordinary ray. */
    Line line() {
        return new Line(vector(10), direction());
    }
}
