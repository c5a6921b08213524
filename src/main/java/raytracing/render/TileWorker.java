package raytracing.render;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import raytracing.film.Film;
import raytracing.shade.LightSum;
import raytracing.shade.Shader;

/**
 * Draws tiles until none is left, one ray through the centre of each pixel. What goes wrong in it stops all workers and
 * is thrown where the film is awaited.
 */
class TileWorker implements Runnable {
    final Shader shader;
    final Film film;
    private final Renderer renderer;
    private final TileQueue tiles;
    private final Failure failure = new Failure();

    TileWorker(Renderer renderer, Film film, TileQueue tiles) {
        this.renderer = renderer;
        this.film = film;
        this.tiles = tiles;
        shader = renderer.shader();
    }

    /** Lets them work, each on a thread of its own, the first on the calling one; returns when all are done. */
    static void runAll(List<? extends TileWorker> workers) {
        List<Thread> helpers = new ArrayList<>();
        for (TileWorker worker : workers.subList(1, workers.size())) {
            Thread helper = new Thread(worker, "tiles");
            helper.setDaemon(true);
            helper.start();
            helpers.add(helper);
        }
        workers.get(0).run();
        for (Thread helper : helpers) {
            waitFor(helper);
        }
        for (TileWorker worker : workers) {
            worker.failure.rethrow();
        }
    }

    static void waitFor(Thread thread) {
        boolean interrupted = false;
        while (thread.isAlive()) {
            try {
                thread.join();
            } catch (InterruptedException request) {
                interrupted = true;          // the film is nobody's before all are done; pass the request on after that
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public final void run() {
        try {
            for (Optional<Tile> tile = tiles.next(); tile.isPresent(); tile = tiles.next()) {
                drawAll(tile.get());
            }
        } catch (RuntimeException | Error thrown) {
            failure.keep(thrown);
            tiles.close();
        }
    }

    private void drawAll(Tile tile) {
        for (int y = tile.top(); y < tile.bottom(); y++) {
            for (int x = tile.left(); x < tile.right(); x++) {
                drawNamed(x, y);
            }
        }
    }

    private void drawNamed(int x, int y) {
        try {
            draw(x, y);
        } catch (RuntimeException defect) {
            throw new IllegalStateException("pixel " + x + ", " + y + ": " + defect, defect);
        }
    }

    /** What is done for one pixel. */
    void draw(int x, int y) {
        LightSum light = renderer.oneRay(shader, x, y);
        film.set(x, y, light.red(), light.green(), light.blue());
    }
}
