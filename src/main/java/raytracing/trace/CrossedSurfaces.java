package raytracing.trace;

import java.util.Arrays;

/**
 * The surfaces that light has crossed on its path, and what they let through together. Kept in the order of the scene, as a
 * product of rounded factors depends on it. Mutable, so that testing millions of segments allocates nothing. Not thread-safe.
 */
public final class CrossedSurfaces {
    private final double[] transmittances;
    private int[] numbers = new int[8];
    private int count;
    private boolean isDark;

    /** No surface yet, in a scene whose surfaces have these transmittances. */
    public CrossedSurfaces(double[] transmittances) {
        this.transmittances = transmittances;
    }

    public void clear() {
        count = 0;
        isDark = false;
    }

    /** How many transparent surfaces were crossed. */
    public int count() {
        return count;
    }

    /** The number of one of them; they are in the order of the scene, and i is from 0 to before the count. */
    public int number(int i) {
        return numbers[i];
    }

    public void add(int number) {
        if (transmittances[number] == 0) {
            isDark = true;
            return;
        }
        if (count == numbers.length) {
            numbers = Arrays.copyOf(numbers, 2 * count);
        }
        int i = count++;
        while (i > 0 && numbers[i - 1] > number) {
            numbers[i] = numbers[i - 1];
            i--;
        }
        numbers[i] = number;
    }

    /** Whether an opaque surface was crossed. */
    public boolean isDark() {
        return isDark;
    }

    /** Product of the transmittances, in [0, 1]. */
    public double transmittance() {
        if (isDark) {
            return 0;
        }
        double product = 1;
        for (int i = 0; i < count; i++) {
            product *= transmittances[numbers[i]];
        }
        return product;
    }
}
