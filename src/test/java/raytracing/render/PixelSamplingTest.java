package raytracing.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.render.PixelSampling.Where;

/** Places in the pixel, counted in units of 1 / (2 N^2), where all of them are odd whole numbers. */
class PixelSamplingTest {
    private static final double ROUNDING = 1e-9;

    private static int unitsX(PixelSampling sampling, int i, int j) {
        return units(sampling, sampling.placeX(i, j));
    }

    private static int unitsY(PixelSampling sampling, int i, int j) {
        return units(sampling, sampling.placeY(i, j));
    }

    private static int units(PixelSampling sampling, double place) {
        double units = 2 * sampling.root() * sampling.root() * place;
        assertEquals(Math.rint(units), units, ROUNDING);
        return (int) Math.rint(units);
    }

    private static PixelSampling sampling(int root) {
        return new PixelSampling(root, Where.EDGES);
    }

    @Test
    void oneRayGoesThroughTheCentre() {
        assertEquals(0.5, PixelSampling.ONE_RAY.placeX(0, 0));
        assertEquals(0.5, PixelSampling.ONE_RAY.placeY(0, 0));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 7, 32})
    void everyRayStaysInItsOwnCell(int root) {
        for (int j = 0; j < root; j++) {
            for (int i = 0; i < root; i++) {
                assertEquals(i, (int) (sampling(root).placeX(i, j) * root));
                assertEquals(j, (int) (sampling(root).placeY(i, j) * root));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 7, 32})
    void everyNarrowColumnAndEveryNarrowRowHoldsOneRay(int root) {
        boolean[] columns = new boolean[root * root];
        boolean[] rows = new boolean[root * root];
        for (int j = 0; j < root; j++) {
            for (int i = 0; i < root; i++) {
                columns[unitsX(sampling(root), i, j) / 2] = true;
                rows[unitsY(sampling(root), i, j) / 2] = true;
            }
        }
        for (int k = 0; k < root * root; k++) {
            assertTrue(columns[k], "column " + k);
            assertTrue(rows[k], "row " + k);
        }
    }

    /** A quarter turn about the middle takes (x, y) to (1 - y, x): so edges across are as good as upright ones. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 7, 32})
    void aQuarterTurnChangesNoPlace(int root) {
        int one = 2 * root * root;
        boolean[][] taken = new boolean[one][one];
        for (int j = 0; j < root; j++) {
            for (int i = 0; i < root; i++) {
                taken[unitsX(sampling(root), i, j)][unitsY(sampling(root), i, j)] = true;
            }
        }
        for (int j = 0; j < root; j++) {
            for (int i = 0; i < root; i++) {
                assertTrue(taken[one - unitsY(sampling(root), i, j)][unitsX(sampling(root), i, j)]);
            }
        }
    }
}
