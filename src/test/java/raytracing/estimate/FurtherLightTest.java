package raytracing.estimate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import raytracing.color.MutableColor;
import raytracing.math.Vector;
import raytracing.surface.Departure;
import raytracing.surface.Hit;
import raytracing.surface.HitRecord;

/** Light between cells, solved on paper. */
class FurtherLightTest {
    private static MutableColor grey(double value) {
        MutableColor color = new MutableColor();
        color.set(value, value, value);
        return color;
    }

    private static double light(FurtherLight further, long cell) {
        MutableColor sum = new MutableColor();
        further.addTo(sum, grey(1), cell);
        return sum.red();
    }

    private static Hit at(double x, double y, double z, Vector normal) {
        return new HitRecord(0, 0, new Vector(x, y, z), 0, normal, Departure.OUTWARD).toHit();
    }

    /** Light 2, of which a quarter goes on, and so forth: 2 / (1 - 1/4). */
    @Test
    void oneCellThatSeesItselfHasTheSumOfTheSeries() {
        PathSegments paths = new PathSegments(1);
        paths.add(7, grey(2), grey(0.25), 7);
        assertEquals(8.0 / 3, light(new FurtherLight(List.of(paths)), 7), 1e-12);
    }

    /** The first has 1 and half of the second, which has nothing but a tenth of the first: a = 1 + a / 20. */
    @Test
    void twoCellsThatSeeEachOtherSolveTheirEquations() {
        PathSegments paths = new PathSegments(2);
        paths.add(7, grey(1), grey(0.5), 8);
        paths.add(8, grey(0), grey(0.1), 7);
        FurtherLight further = new FurtherLight(List.of(paths));
        assertEquals(1 / 0.95, light(further, 7), 1e-3);
        assertEquals(0.1 / 0.95, light(further, 8), 1e-3);
    }

    @Test
    void pathsOfOneCellShareWhatTheyFind() {
        PathSegments one = new PathSegments(1);
        PathSegments other = new PathSegments(1);
        one.add(7, grey(1), grey(0), FurtherLight.NO_CELL);
        other.add(7, grey(3), grey(0), FurtherLight.NO_CELL);
        assertEquals(2, light(new FurtherLight(List.of(one, other)), 7), 1e-15);
    }

    @Test
    void aCellFromWhichNoPathStartedHasTheMean() {
        PathSegments paths = new PathSegments(2);
        paths.add(7, grey(1), grey(0), FurtherLight.NO_CELL);
        paths.add(8, grey(3), grey(0), FurtherLight.NO_CELL);
        assertEquals(2, light(new FurtherLight(List.of(paths)), 9), 1e-15);
        assertEquals(0, light(new FurtherLight(List.of()), 9));
    }

    /** Seen from 16 away, cells have an edge of 2; a wall is not in the cell of the floor beside it. */
    @Test
    void pointsShareACellIfTheyAreNearAndTurnedAlike() {
        Vector up = new Vector(0, 1, 0);
        long cell = FurtherLight.cell(at(16.2, 0.1, 0.1, up), Vector.ZERO);
        assertEquals(cell, FurtherLight.cell(at(17.8, 0.1, 1.9, up), Vector.ZERO));
        assertNotEquals(cell, FurtherLight.cell(at(18.1, 0.1, 0.1, up), Vector.ZERO));
        assertNotEquals(cell, FurtherLight.cell(at(16.2, 0.1, 2.1, up), Vector.ZERO));
        assertNotEquals(cell, FurtherLight.cell(at(16.2, 0.1, 0.1, up.times(-1)), Vector.ZERO));
        assertNotEquals(cell, FurtherLight.cell(at(16.2, 0.1, 0.1, new Vector(0, 0, 1)), Vector.ZERO));
    }
}
