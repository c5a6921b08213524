package raytracing.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.area.ConvexPolygons;
import raytracing.render.PixelGrid.Where;

/** Places in the pixel, counted in units of 1 / (2 N^2), where all of them are odd whole numbers. */
class PixelGridTest {
    private static final int EDGES = 20_000;

    private static final double ROUNDING = 1e-9;

    private static int unitsX(PixelGrid sampling, int i, int j) {
        return units(sampling, sampling.placeX(i, j));
    }

    private static int unitsY(PixelGrid sampling, int i, int j) {
        return units(sampling, sampling.placeY(i, j));
    }

    private static int units(PixelGrid sampling, double place) {
        double units = 2 * sampling.root() * sampling.root() * place;
        assertEquals(Math.rint(units), units, ROUNDING);
        return (int) Math.rint(units);
    }

    private static PixelGrid sampling(int root) {
        return new PixelGrid(root, Where.EDGES);
    }

    @Test
    void oneRayGoesThroughTheCentre() {
        assertEquals(0.5, PixelGrid.ONE_RAY.placeX(0, 0));
        assertEquals(0.5, PixelGrid.ONE_RAY.placeY(0, 0));
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

    /** Places of N x N rays in a pixel whose sides go from -1 to 1. */
    private interface Places {
        double x(int i, int j);

        double y(int i, int j);
    }

    private static Places grid(int root) {
        return new Places() {
            @Override
            public double x(int i, int j) {
                return 2 * (i + 0.5) / root - 1;
            }

            @Override
            public double y(int i, int j) {
                return 2 * (j + 0.5) / root - 1;
            }
        };
    }

    private static Places ours(int root) {
        PixelGrid sampling = new PixelGrid(root, PixelGrid.Where.EVERYWHERE);
        return new Places() {
            @Override
            public double x(int i, int j) {
                return 2 * sampling.placeX(i, j) - 1;
            }

            @Override
            public double y(int i, int j) {
                return 2 * sampling.placeY(i, j) - 1;
            }
        };
    }

    /** Root of the mean square error of the share of a pixel beside random straight edges, at angles up to one in degrees. */
    private static double errorAtEdges(Places places, int root, double mostDegrees) {
        SplittableRandom random = new SplittableRandom(1);
        ConvexPolygons polygons = new ConvexPolygons();
        int pixel = polygons.addSquare(1);
        double squares = 0;
        for (int edge = 0; edge < EDGES; edge++) {
            double angle = Math.toRadians(random.nextDouble(mostDegrees));
            double a = Math.sin(angle);
            double b = Math.cos(angle);
            double c = random.nextDouble(-a - b, a + b);
            int inside = 0;
            for (int j = 0; j < root; j++) {
                for (int i = 0; i < root; i++) {
                    inside += a * places.x(i, j) + b * places.y(i, j) + c >= 0 ? 1 : 0;
                }
            }
            double share = polygons.area(polygons.cut(pixel, a, b, c)) / 4;
            polygons.dropTo(pixel + 1);
            double error = (double) inside / (root * root) - share;
            squares += error * error;
        }
        return Math.sqrt(squares / EDGES);
    }

    /** The figures that DECISIONS names; the grid with upright rows is what else one would take. */
    @ParameterizedTest
    @CsvSource({"2, 0.091, 0.090", "4, 0.032, 0.033", "8, 0.0115, 0.0122"})
    void slantedEdgesAreAsSmoothAsWithAnUprightGrid(int root, double grid, double ours) {
        assertEquals(grid, errorAtEdges(grid(root), root, 90), 0.05 * grid);
        assertEquals(ours, errorAtEdges(ours(root), root, 90), 0.05 * ours);
    }

    @Test
    void edgesNearAnAxisAreSmootherThanWithAnUprightGrid() {
        assertEquals(0.053, errorAtEdges(grid(4), 4, 8), 0.003);
        assertEquals(0.023, errorAtEdges(ours(4), 4, 8), 0.002);
    }
}
