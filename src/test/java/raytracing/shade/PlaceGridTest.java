package raytracing.shade;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import raytracing.SceneText;
import raytracing.compiled.CompiledScene;
import raytracing.compiled.ShadowMode;
import raytracing.geometry.HitPoint;
import raytracing.math.Vector;
import raytracing.scene.Scene;

/** A grid over a picture of a wall that fills it: 20 wide, 40 high, looked at from 1 2 3 along z. */
class PlaceGridTest {
    private static final int EDGE = 10;
    private static final Vector EYE = new Vector(1, 2, 3);

    /** The screen is 3 wide at a distance of 2, and so 6 high. */
    private static final String PINHOLE = "cam 1 2 3  1 2 4  0 1 0  2 3";

    private static PlaceGrid grid(String camera) {
        Scene scene = SceneText.scene(camera, "set 1 1 1  1 5", "mtl 0 0 0  0 0 0  0 0 0  1 0  1 1 1", "pln 0 0 1 11 1");
        PlaceGrid grid = new PlaceGrid(scene, 20, 40, EDGE);
        grid.look(scene, new CompiledScene(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT), 1, 0, 1);
        return grid;
    }

    @Test
    void everyPlaceLiesInItsCell() {
        List<Place> places = grid(PINHOLE).choose(1, List.of());
        assertEquals(EDGE * EDGE, places.size());
        for (int cell = 0; cell < places.size(); cell++) {
            HitPoint point = places.get(cell).point();
            double column = EDGE * ((point.x() - EYE.x()) / 8 * 2 / 3 + 0.5);
            double row = EDGE * (0.5 - (point.y() - EYE.y()) / 8 * 2 / 6);
            assertEquals(cell % EDGE, (int) Math.floor(column), "column of cell " + cell);
            assertEquals(cell / EDGE, (int) Math.floor(row), "row of cell " + cell);
        }
    }

    /**
     * Cells are 0.6 high, seen from 2: that is how far places lie apart on a sphere of radius 2. As nobody has looked at what
     * is around, they reach 6 times as far, and 3 times that over the cosine for want of others.
     */
    @Test
    void placesLieAsFarApartAsTheirCellsSeenFromTheEye() {
        for (Place place : grid(PINHOLE).choose(1, List.of())) {
            HitPoint point = place.point();
            double distance = new Vector(point.x(), point.y(), point.z()).minus(EYE).length();
            double radius = 6 * 0.6 / 2 * distance;
            assertEquals(radius, place.radius(), 1e-12 * radius);
            assertEquals(3 * radius * distance / 8, place.wideRadius(), 1e-12 * radius * distance);
        }
    }

    @Test
    void noPlaceIsChosenThatOthersCover() {
        PlaceGrid grid = grid(PINHOLE);
        List<Place> coarse = grid.choose(4, List.of());
        assertEquals(9, coarse.size());
        assertEquals(List.of(), grid.choose(1, coarse));
    }

    /** Half of the world is a disc, as wide as the picture: no more than the cells that reach into it can see something. */
    @Test
    void whereTheLensShowsBlackThereIsNoPlace() {
        int count = grid("cam 1 2 3  1 2 4  0 1 0  1 3.1416 true 0").choose(1, List.of()).size();
        assertTrue(count > 20 && count <= 60, count + " places");
    }
}
