package raytracing.render;

import java.util.Optional;
import raytracing.shade.RayCounts;
import raytracing.shade.Shader;

/**
 * Works on tiles until none is left or the work is cancelled. What goes wrong in it stops all workers and is thrown where
 * their end is awaited.
 */
abstract class TileWorker implements Runnable {
    final Shader shader;
    final Failure failure = new Failure();
    private final TileQueue tiles;
    private final Cancellation cancellation;

    /** Of a worker that is too slow to be awaited, this much is known. */
    private volatile RayCounts counts = RayCounts.NONE;

    TileWorker(Renderer renderer, TileQueue tiles, Cancellation cancellation) {
        this.tiles = tiles;
        this.cancellation = cancellation;
        shader = renderer.shader();
    }

    @Override
    public final void run() {
        try {
            for (Optional<Region> tile = tiles.next(); tile.isPresent(); tile = tiles.next()) {
                shader.forgetPast();         // so that the counts of a tile are its own, whatever this thread drew before
                drawAll(tile.get());
                if (cancellation.isRequested()) {
                    return;
                }
                tiles.finish(tile.get());
                counts = shader.counts();
                finished(tile.get());
            }
        } catch (RuntimeException | Error thrown) {
            failure.keep(thrown);
            tiles.close();
        }
    }

    /** What the tiles finished so far took; any thread may ask. */
    final RayCounts counts() {
        return counts;
    }

    /** What is done for a tile: something for each of its pixels. */
    void drawAll(Region tile) {
        for (int y = tile.top(); y < tile.bottom(); y++) {
            for (int x = tile.left(); x < tile.right() && !cancellation.isRequested(); x++) {
                drawNamed(x, y);
            }
        }
    }

    /** Draws a pixel, whose place is named if that fails. */
    final void drawNamed(int x, int y) {
        try {
            draw(x, y);
        } catch (RuntimeException defect) {
            throw new IllegalStateException("pixel " + x + ", " + y + ": " + defect, defect);
        }
    }

    /** What is done for one pixel of the picture. */
    abstract void draw(int x, int y);

    /** What is done when all pixels of a tile are. */
    abstract void finished(Region tile);
}
