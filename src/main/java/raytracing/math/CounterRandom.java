package raytracing.math;

/**
 * Random numbers without a state: every number is a function of a key and a counter, so the order in which numbers are
 * computed does not matter, nor does the thread, nor whether the numbers before were ever used.
 *
 * <p>Counter k of key s is output k + 1 of a SplitMix64 generator seeded with s: Steele, Lea, Flood, Fast Splittable
 * Pseudorandom Number Generators, OOPSLA 2014, with Stafford's constants (variant 13) in the last step, as
 * {@code java.util.SplittableRandom} has them.
 */
public final class CounterRandom {
    /** The odd integer closest to 2^64 divided by the golden ratio. */
    private static final long GOLDEN_GAMMA = 0x9e3779b97f4a7c15L;

    private CounterRandom() {
    }

    /** 64 random bits: number {@code counter}, any value, of the sequence of a key. */
    public static long bits(long key, long counter) {
        long state = key + (counter + 1) * GOLDEN_GAMMA;
        long z = (state ^ (state >>> 30)) * 0xbf58476d1ce4e5b9L;
        z = (z ^ (z >>> 27)) * 0x94d049bb133111ebL;
        return z ^ (z >>> 31);
    }

    /** A random multiple of 2^-32 in [0, 1) from the upper half of some random bits. */
    public static double upperFraction(long bits) {
        return (bits >>> 32) * 0x1p-32;
    }

    /** A random multiple of 2^-32 in [0, 1) from the lower half of some random bits, independent of the upper half. */
    public static double lowerFraction(long bits) {
        return (bits & 0xffffffffL) * 0x1p-32;
    }
}
