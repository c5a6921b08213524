package raytracing.trace;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class CrossedSurfacesTest {
    /** Numbers whose product depends on the order in which it is rounded. */
    private static final double[] TRANSMITTANCES = {0.7, 0.3, 0.35, 0.6, 0};

    private final CrossedSurfaces crossed = new CrossedSurfaces(TRANSMITTANCES);

    private static void add(CrossedSurfaces crossed, int... numbers) {
        for (int number : numbers) {
            crossed.add(number);
        }
    }

    @Test
    void theProductIsTakenInTheOrderOfTheSceneWhateverWasCrossedFirst() {
        double inOrder = 0.7 * 0.3 * 0.35 * 0.6;
        assertTrue(inOrder != 0.6 * 0.35 * 0.3 * 0.7, "an example in which the order matters");
        int[][] orders = {{0, 1, 2, 3}, {3, 2, 1, 0}, {2, 0, 3, 1}};
        for (int[] order : orders) {
            crossed.clear();
            add(crossed, order);
            assertEquals(inOrder, crossed.transmittance());
        }
    }

    @Test
    void numbersAreInTheOrderOfTheScene() {
        add(crossed, 3, 1, 2);
        assertArrayEquals(new int[] {1, 2, 3}, IntStream.range(0, crossed.count()).map(crossed::number).toArray());
    }

    @Test
    void anOpaqueSurfaceLeavesNoLight() {
        add(crossed, 0, 4);
        assertTrue(crossed.isDark());
        assertEquals(0, crossed.transmittance());
        crossed.clear();
        assertFalse(crossed.isDark());
    }

    @Test
    void nothingCrossedIsAllLight() {
        assertEquals(0, crossed.count());
        assertEquals(1, crossed.transmittance());
    }

    @Test
    void thereIsRoomForAnyNumberOfSurfaces() {
        double[] many = new double[100];
        Arrays.fill(many, 0.5);
        CrossedSurfaces list = new CrossedSurfaces(many);
        for (int i = 99; i >= 0; i--) {
            list.add(i);
        }
        assertEquals(0x1p-100, list.transmittance());
    }
}
