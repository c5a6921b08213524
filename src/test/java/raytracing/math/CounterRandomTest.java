package raytracing.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class CounterRandomTest {
    @Test
    void countersWalkThroughTheSequenceOfSplitMix64() {
        for (long seed : new long[] {0, 1, -1, 0x123456789abcdefL}) {
            SplittableRandom sequence = new SplittableRandom(seed);
            for (int counter = 0; counter < 100; counter++) {
                assertEquals(sequence.nextLong(), CounterRandom.bits(seed, counter));
            }
        }
    }

    @Test
    void fractionsComeFromTheirHalvesOfTheBits() {
        assertEquals(0.5, CounterRandom.upperFraction(0x80000000_ffffffffL));
        assertEquals(1 - 0x1p-32, CounterRandom.lowerFraction(0x80000000_ffffffffL));
        assertEquals(0, CounterRandom.lowerFraction(0xffffffff_00000000L));
    }

    /**
     * The keys of neighbouring pixels, as the renderer makes them, put points evenly over the square: chi-square with
     * 255 degrees of freedom stays below 377 except once in a million runs, and this run is always the same one.
     */
    @Test
    void neighbouringPixelsFillTheSquareEvenly() {
        int[] count = new int[256];
        int pixels = 256;
        for (int x = 0; x < pixels; x++) {
            for (int y = 0; y < pixels; y++) {
                long bits = CounterRandom.bits(CounterRandom.bits(CounterRandom.bits(1, x), y), 0);
                count[(int) (16 * CounterRandom.upperFraction(bits)) * 16
                    + (int) (16 * CounterRandom.lowerFraction(bits))]++;
            }
        }
        double expected = pixels * pixels / 256.0;
        double chiSquare = 0;
        for (int n : count) {
            chiSquare += (n - expected) * (n - expected) / expected;
        }
        assertTrue(chiSquare < 377, () -> "uneven");
    }
}
