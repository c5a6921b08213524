package raytracing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import raytracing.film.Film;
import raytracing.render.Region;

class CloseupTest {
    private static Film grey(int size) {
        return Pictures.even(size, 0.5);
    }

    private static Film withDots(int size, int... places) {
        Film film = grey(size);
        for (int i = 0; i < places.length; i += 2) {
            film.set(places[i], places[i + 1], 0, 0, 0);
        }
        return film;
    }

    private static Reference reference(int size) {
        return Reference.of(grey(size), grey(size), 1);
    }

    /** Two dots, 31 pixels apart both ways, fit into one square only. */
    @Test
    void theWorstSquareIsFoundAtAnyPlace() {
        Closeup closeup = Closeup.of(withDots(100, 7, 3, 41, 55, 72, 86), reference(100));
        assertEquals(new Region(41, 55, 73, 87), closeup.place());
        assertEquals(0, closeup.found().get(0, 0).red());
        assertEquals(0, closeup.found().get(31, 31).red());
        assertEquals(0.5, closeup.aim().get(0, 0).red());
    }

    @Test
    void ofEquallyBadSquaresTheFirstIsShown() {
        assertEquals(new Region(0, 0, 32, 32), Closeup.of(grey(100), reference(100)).place());
    }

    @Test
    void aSmallPictureIsItsOwnCloseup() {
        assertEquals(new Region(0, 0, 20, 20), Closeup.of(grey(20), reference(20)).place());
    }

    @Test
    void whereTheReferenceHasSquaresTheWorstOfThemIsShown() {
        List<Region> blocks = Blocks.of(500, 8);
        Region worst = blocks.get(7);
        List<Film> films = blocks.stream().map(block -> grey(Blocks.EDGE)).toList();
        Reference reference = Reference.of(blocks, films, films, 1);
        assertEquals(worst, Closeup.of(withDots(500, worst.left() + 5, worst.top() + 9), reference).place());
    }

    @Test
    void theFrameIsInSharesOfThePicture() {
        assertEquals("<span style=\"left:25.00%;top:50.00%;width:16.00%;height:16.00%\"></span>",
            SceneSection.frame(new Region(50, 100, 82, 132), 200));
    }

    @Test
    void squaresLieInThePictureAndDoNotTouch() {
        List<Region> blocks = Blocks.of(500, 8);
        Set<List<Integer>> places = new HashSet<>();
        for (Region block : blocks) {
            assertTrue(block.left() >= 0 && block.right() <= 500 && block.top() >= 0 && block.bottom() <= 500);
            assertEquals(Blocks.EDGE * Blocks.EDGE, block.pixelCount());
            int column = block.left() / Blocks.EDGE;
            int row = block.top() / Blocks.EDGE;
            for (int i = 0; i < 9; i++) {
                assertTrue(!places.contains(List.of(column + i % 3 - 1, row + i / 3 - 1)), block.toString());
            }
            places.add(List.of(column, row));
        }
        assertEquals(1.0 / 8, blocks.size() / 225.0, 0.01);
    }

    @Test
    void aSmallPictureOrTheOnlySceneIsComparedAsAWhole() {
        assertEquals(List.of(Region.whole(80, 80)), Blocks.of(80, 8));
        assertEquals(List.of(Region.whole(500, 500)), Blocks.of(500, 1));
    }
}
