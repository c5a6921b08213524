package raytracing.math;

/**
 * An endless sequence of points in the unit square whose first 2^m points are spread as evenly as 2^m points can be, for every
 * m, and so is each further run of 2^m points from a multiple of 2^m on: one point lies in each rectangle of area 2^-m that
 * halving the square again and again along its sides makes (a (0, 2)-sequence in base 2: Niederreiter, Random Number
 * Generation and Quasi-Monte Carlo Methods, SIAM 1992). Each key has a sequence of its own. The coordinates are multiples of
 * 2^-32 in [0, 1). Not thread-safe: a point is read before the next is asked for.
 *
 * <p>The points are those of Sobol's first two dimensions, scrambled as Owen does it (Randomly Permuted (t,m,s)-Nets and
 * (t,s)-Sequences, 1995): which half of an interval is which is decided at random, for each interval by itself. So the points
 * are random to every integrand, and no two of them share a coordinate. Hashed numbers make the decisions (Laine and Karras,
 * Stratified Sampling for Stochastic Transparency, EGSR 2011; Burley, Practical Hash-based Owen Scrambling, JCGT 9, 2020).
 */
public final class ScrambledNet {
    private int seedX;
    private int seedY;
    private double x;
    private double y;

    /** Begins the sequence of a key, any value. */
    public void begin(long key) {
        long bits = CounterRandom.bits(key, 0);
        seedX = (int) bits;
        seedY = (int) (bits >>> 32);
    }

    /** Moves to a point, counted from 0. */
    public void moveTo(int index) {
        x = fraction(scrambled(index, seedX));
        y = fraction(scrambled(pascal(index), seedY));
    }

    /** The digits of an index, multiplied by the triangle of Pascal modulo 2: those of Sobol's second dimension, reversed. */
    private static int pascal(int index) {
        int digits = index;
        digits ^= digits >>> 1 & 0x55555555;
        digits ^= digits >>> 2 & 0x33333333;
        digits ^= digits >>> 4 & 0x0f0f0f0f;
        digits ^= digits >>> 8 & 0x00ff00ff;
        return digits ^ digits >>> 16 & 0x0000ffff;
    }

    /** A number whose first digit is the lowest, scrambled: each digit is kept or not by those before it. */
    private static int scrambled(int digits, int seed) {
        int hash = digits;
        hash ^= hash * 0x3d20adea;
        hash += seed;
        hash *= seed >>> 16 | 1;
        hash ^= hash * 0x05526c56;
        return hash ^ hash * 0x53a22864;
    }

    private static double fraction(int digits) {
        return (Integer.reverse(digits) & 0xffffffffL) * 0x1p-32;
    }

    public double x() {
        return x;
    }

    public double y() {
        return y;
    }
}
