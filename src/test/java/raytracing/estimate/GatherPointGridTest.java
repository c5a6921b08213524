package raytracing.estimate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import raytracing.SceneText;
import raytracing.math.Vector;
import raytracing.scene.Scene;
import raytracing.surface.Hit;
import raytracing.trace.PreparedScene;
import raytracing.trace.Queries;
import raytracing.trace.ShadowMode;

/** A grid over a picture of a wall that fills it: 20 wide, 40 high, looked at from 1 2 3 along z. */
class GatherPointGridTest {
    private static final int EDGE = 10;
    private static final Vector EYE = new Vector(1, 2, 3);

    /** The screen is 3 wide at a distance of 2, and so 6 high. */
    private static final String PINHOLE = "cam 1 2 3  1 2 4  0 1 0  2 3";

    private static GatherPointGrid grid(String camera) {
        Scene scene = SceneText.scene(camera, "set 1 1 1  1 5", "mtl 0 0 0  0 0 0  0 0 0  1 0  1 1 1", "pln 0 0 1 11 1");
        PreparedScene prepared = Queries.prepared(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
        GatherPointGrid grid = new GatherPointGrid(scene, prepared, 20, 40, EDGE, EDGE, 1);
        grid.work(0, 1, EDGE);
        return grid;
    }

    @Test
    void everyPointLiesInItsCell() {
        List<GatherPoint> points = grid(PINHOLE).choose(1, List.of(), 1);
        assertEquals(EDGE * EDGE, points.size());
        for (int cell = 0; cell < points.size(); cell++) {
            Hit point = points.get(cell).hit;
            double column = EDGE * ((point.x() - EYE.x()) / 8 * 2 / 3 + 0.5);
            double row = EDGE * (0.5 - (point.y() - EYE.y()) / 8 * 2 / 6);
            assertEquals(cell % EDGE, (int) Math.floor(column), "column of cell " + cell);
            assertEquals(cell / EDGE, (int) Math.floor(row), "row of cell " + cell);
        }
    }

    /**
     * Cells are 0.6 high, seen from 2: that is how far points lie apart on a sphere of radius 2. As nothing is known of their
     * surroundings, their radius is 10 times as much, and 3 times that over the cosine where others are missing.
     */
    @Test
    void pointsLieAsFarApartAsTheirCellsSeenFromTheEye() {
        for (GatherPoint point : grid(PINHOLE).choose(1, List.of(), 1)) {
            Hit hit = point.hit;
            double distance = new Vector(hit.x(), hit.y(), hit.z()).minus(EYE).length();
            double radius = 10 * 0.6 / 2 * distance;
            assertEquals(radius, point.radius(1), 1e-12 * radius);
            assertEquals(3 * radius * distance / 8, point.wideRadius(1), 1e-12 * radius * distance);
        }
    }

    @Test
    void noPointIsChosenThatOthersCover() {
        GatherPointGrid grid = grid(PINHOLE);
        List<GatherPoint> coarse = grid.choose(4, List.of(), 1);
        assertEquals(9, coarse.size());
        assertEquals(List.of(), grid.choose(1, coarse, 1));
    }

    /** Half of the world is a disc, as wide as the picture: no more than the cells that reach into it can see something. */
    @Test
    void whereTheLensShowsBlackThereIsNoPoint() {
        int count = grid("cam 1 2 3  1 2 4  0 1 0  1 3.1416 true 0").choose(1, List.of(), 1).size();
        assertTrue(count > 20 && count <= 60, count + " points");
    }
}
