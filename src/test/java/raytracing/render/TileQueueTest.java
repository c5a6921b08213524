package raytracing.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TileQueueTest {
    @ParameterizedTest(name = "{0} x {1} pixels, tiles of {2}")
    @CsvSource({"61, 47, 8", "1, 1, 16", "100, 1, 3", "5, 70, 5", "64, 64, 16", "7, 7, 1000", "89, 89, 1"})
    void everyPixelIsInExactlyOneTile(int width, int height, int tileSize) {
        int[][] drawn = new int[height][width];
        TileQueue tiles = new TileQueue(new Region(1000, 2000, 1000 + width, 2000 + height), tileSize);
        for (Optional<Region> next = tiles.next(); next.isPresent(); next = tiles.next()) {
            Region tile = next.get();
            for (int y = tile.top(); y < tile.bottom(); y++) {
                for (int x = tile.left(); x < tile.right(); x++) {
                    drawn[y - 2000][x - 1000]++;
                }
            }
        }
        assertTrue(Arrays.stream(drawn).flatMapToInt(Arrays::stream).allMatch(count -> count == 1));
    }

    @Test
    void aClosedQueueHasNoMoreTiles() {
        TileQueue tiles = new TileQueue(Region.whole(100, 100), 10);
        assertTrue(tiles.next().isPresent());
        tiles.close();
        assertEquals(Optional.empty(), tiles.next());
    }

    /** Whatever share of the tiles is dealt, each quarter of the picture has had about that share of its own. */
    @Test
    void theTilesDealtAreSpreadOverThePicture() {
        TileQueue tiles = new TileQueue(Region.whole(400, 400), 10);
        int[] dealt = new int[4];
        for (int i = 1; i <= 1600; i++) {
            Region tile = tiles.next().orElseThrow();
            dealt[(tile.top() < 200 ? 0 : 2) + (tile.left() < 200 ? 0 : 1)]++;
            for (int quarter : dealt) {
                assertEquals(i / 4.0, quarter, 8, "of 400 in a quarter, after " + i + " tiles");
            }
        }
    }

    @Test
    void whatIsNotFinishedIsUnfinished() {
        TileQueue tiles = new TileQueue(new Region(5, 6, 25, 16), 10);
        Region first = tiles.next().orElseThrow();
        Region second = tiles.next().orElseThrow();
        assertEquals(2, tiles.unfinished().size());
        tiles.finish(second);
        assertEquals(List.of(first), tiles.unfinished());
        tiles.finish(first);
        assertEquals(List.of(), tiles.unfinished());
    }
}
