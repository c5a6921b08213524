package raytracing.nasty;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.DoubleSupplier;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/**
 * The numbers of one nasty scene. Lengths and places come in one of several habits, so that some scenes are small
 * throughout, some mix all sizes, and some lie on a coarse grid, where much coincides. Places are often those used
 * before, or beside one of them by a length used before.
 */
final class NastyNumbers {
    private static final double LARGEST = 1e300;
    private static final double[] FACTORS = {0, 1, 0.5, 1.1, 1e-300, 1e300, Double.MAX_VALUE, Double.MIN_VALUE, 0.999999};
    private static final double[] SHARES = {0, 1, 0.5, 1e-300, 0.9999999999999999, Double.MIN_VALUE, 0.9};

    private final SplittableRandom random;
    private final DoubleSupplier size;
    private final boolean isOrdinary;
    private final List<Vector> places = new ArrayList<>();
    private final List<Double> lengths = new ArrayList<>();

    NastyNumbers(long seed) {
        random = new SplittableRandom(seed);
        double unit = power(-300, 290);
        DoubleSupplier ordinary = () -> power(-2, 2);
        int habit = below(7);
        isOrdinary = habit < 2;
        size = switch (habit) {
            case 0, 1 -> ordinary;
            case 2 -> () -> unit * power(-2, 2);
            case 3 -> () -> power(-300, 300);
            case 4 -> () -> oneIn(8) ? power(-300, 300) : power(-2, 2);
            case 5 -> () -> oneIn(6) ? power(-2, 2) : power(-323, -307);
            default -> () -> oneIn(10) ? power(-2, 2) : below(8) / 2.0;
        };
    }

    /** Whether all lengths are within two powers of ten of 1. */
    boolean isOrdinary() {
        return isOrdinary;
    }

    boolean oneIn(int n) {
        return random.nextInt(n) == 0;
    }

    int below(int n) {
        return random.nextInt(n);
    }

    /** 10 to a power drawn evenly; below the smallest normal number with fewer digits. */
    private double power(int lowest, int highest) {
        return Math.min(LARGEST, StrictMath.pow(10, random.nextDouble(lowest, highest)));
    }

    /** A length above 0, in four of ten cases one used before. */
    double length() {
        if (!lengths.isEmpty() && below(10) < 4) {
            return lengths.get(below(lengths.size()));
        }
        double length = Math.max(Double.MIN_VALUE, size.getAsDouble());
        lengths.add(length);
        return length;
    }

    double coordinate() {
        return oneIn(4) ? 0 : random.nextBoolean() ? length() : -length();
    }

    /** A new place, one used before, or one beside it along an axis by a length used before. */
    Vector place() {
        Vector place = new Vector(coordinate(), coordinate(), coordinate());
        if (!places.isEmpty() && below(10) < 6) {
            place = places.get(below(places.size()));
            if (oneIn(2)) {
                place = finite(Vectors.plus(place, coordinate() * (oneIn(2) ? 1 : 0.5), axis()));
            }
        }
        places.add(place);
        return place;
    }

    private static Vector finite(Vector v) {
        return new Vector(finite(v.x()), finite(v.y()), finite(v.z()));
    }

    static double finite(double x) {
        return Math.max(-LARGEST, Math.min(LARGEST, x));
    }

    private Vector axis() {
        int axis = below(3);
        return new Vector(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
    }

    /** Any direction but none, at times along an axis and of any length. */
    Vector direction() {
        Vector direction = oneIn(2) ? axis() : new Vector(
            random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
        Vector scaled = oneIn(3) ? direction.times(power(-320, 300)) : oneIn(6)
            ? new Vector(direction.x() * power(-300, 0), direction.y() * power(-300, 0), direction.z()) : direction;
        return scaled.isZero() ? axis() : scaled;
    }

    /** A factor on light, at least 0; mostly an ordinary one. */
    double factor() {
        return oneIn(3) ? FACTORS[below(FACTORS.length)] : random.nextDouble();
    }

    /** From 0 to 1. */
    double share() {
        return oneIn(2) ? SHARES[below(SHARES.length)] : random.nextDouble();
    }

    /** Three factors, often all the same or all 0. */
    Vector color() {
        double all = factor();
        return oneIn(2) ? new Vector(all, all, all) : oneIn(3) ? Vector.ZERO : new Vector(factor(), factor(), factor());
    }
}
