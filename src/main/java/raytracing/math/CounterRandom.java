package raytracing.math;

/**
 * Random numbers without a state: every number is a function of a key and a counter, so it does not matter who
 * asks first, on which thread, or whether the numbers before it were ever used.
 *
 * <p>Counter k of key s is output k + 1 of a SplitMix64 generator seeded with s: Steele, Lea, Flood, Fast Splittable
 * Pseudorandom Number Generators, OOPSLA 2014, with Stafford's constants (variant 13) in the last step, as
 * {@code java.util.SplittableRandom} has them.
 */
public final class CounterRandom {
    /** The odd integer closest to 2^64 divided by the golden ratio. */
    private static final long GOLDEN_GAMMA = 0x9e3779b97f4a7c15L;
    private static final double UNIT_32 = 0x1p-32;

    private CounterRandom() {
    }

    /**
     * A number of a key's sequence.
     *
     * @param key which sequence
     * @param counter which number of it, any value
     * @return 64 random bits
     */
    public static long bits(long key, long counter) {
        return mixed(key + (counter + 1) * GOLDEN_GAMMA);
    }

    /**
     * A random fraction from the upper half of some random bits.
     *
     * @param bits from {@link #bits}
     * @return a multiple of 2^-32 in [0, 1)
     */
    public static double upperFraction(long bits) {
        return (bits >>> 32) * UNIT_32;
    }

    /**
     * A random fraction from the lower half of some random bits, independent of the upper one.
     *
     * @param bits from {@link #bits}
     * @return a multiple of 2^-32 in [0, 1)
     */
    public static double lowerFraction(long bits) {
        return (bits & 0xffffffffL) * UNIT_32;
    }

    private static long mixed(long state) {
        long z = (state ^ (state >>> 30)) * 0xbf58476d1ce4e5b9L;
        z = (z ^ (z >>> 27)) * 0x94d049bb133111ebL;
        return z ^ (z >>> 31);
    }
}
