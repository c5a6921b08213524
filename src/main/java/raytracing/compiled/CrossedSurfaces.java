package raytracing.compiled;

import java.util.Arrays;

/**
 * The surfaces that light has crossed on its way, and what they let through in all. Kept in the order of the scene, as a
 * product of rounded factors depends on their order. One thread, line after line.
 */
final class CrossedSurfaces {
    private final double[] transmittanceOf;
    private int[] numbers = new int[8];
    private int count;
    private boolean isDark;

    /** The array gives the transmittance of every surface of the scene by its number. */
    CrossedSurfaces(double[] transmittanceOf) {
        this.transmittanceOf = transmittanceOf;
    }

    void clear() {
        count = 0;
        isDark = false;
    }

    boolean isEmpty() {
        return count == 0 && !isDark;
    }

    void addAll(CrossedSurfaces others) {
        for (int i = 0; i < others.count; i++) {
            add(others.numbers[i]);
        }
        isDark |= others.isDark;
    }

    void add(int number) {
        if (transmittanceOf[number] == 0) {
            isDark = true;
            return;
        }
        if (count == numbers.length) {
            numbers = Arrays.copyOf(numbers, 2 * count);
        }
        int place = count++;
        while (place > 0 && numbers[place - 1] > number) {
            numbers[place] = numbers[place - 1];
            place--;
        }
        numbers[place] = number;
    }

    /** Whether no light is left, whatever comes. */
    boolean isDark() {
        return isDark;
    }

    /** Product of the surfaces' transmittances, in [0, 1]. */
    double transmittance() {
        if (isDark) {
            return 0;
        }
        double product = 1;
        for (int i = 0; i < count; i++) {
            product *= transmittanceOf[numbers[i]];
        }
        return product;
    }
}
