package raytracing.render;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import raytracing.color.Color;
import raytracing.compiled.CompiledScene;
import raytracing.compiled.PixelRays;
import raytracing.compiled.Shortcut;
import raytracing.film.Film;
import raytracing.math.CounterRandom;
import raytracing.scene.Scene;
import raytracing.shade.LightSum;
import raytracing.shade.Shader;

/**
 * Draws a scene. Every pixel depends on the scene, the size, the seed, the shadow mode and its own coordinates alone:
 * {@link #pixel} replays any of them, and the film is the same for every number of threads and every tile size.
 */
public final class Renderer {
    private final RenderSettings settings;
    private final Scene scene;
    private final PixelRays pixelRays;
    private final CompiledScene compiled;

    /**
     * Makes a scene ready to be drawn.
     *
     * @param scene what to draw
     * @param settings how
     */
    public Renderer(Scene scene, RenderSettings settings) {
        this.scene = scene;
        this.settings = settings;
        pixelRays = new PixelRays(scene.camera(), settings.width(), settings.height());
        compiled = new CompiledScene(scene, settings.shadowMode(), EnumSet.allOf(Shortcut.class),
            new ThreadWorkers(settings.threads()));
    }

    /**
     * The light of one pixel.
     *
     * @param x column, from 0 on the left
     * @param y row, from 0 at the top
     * @return linear light; black where the lens sees nothing
     */
    public Color pixel(int x, int y) {
        return light(new Shader(scene, compiled), x, y).total();
    }

    private LightSum light(Shader shader, int x, int y) {
        long key = CounterRandom.bits(CounterRandom.bits(settings.seed(), x), y);
        return shader.light(pixelRays, x + 0.5, y + 0.5, key);
    }

    /**
     * Draws the whole picture, with as many threads as the settings say; the calling one is one of them.
     *
     * @return the finished film
     * @throws IllegalStateException if a pixel failed, which is a defect of this program; names the pixel
     */
    public Film render() {
        Film film = new Film(settings.width(), settings.height());
        TileQueue tiles = new TileQueue(settings.width(), settings.height(), settings.tileSize());
        List<Worker> workers = new ArrayList<>();
        List<Thread> helpers = new ArrayList<>();
        for (int i = 0; i < settings.threads(); i++) {
            workers.add(new Worker(film, tiles));
        }
        for (Worker worker : workers.subList(1, workers.size())) {
            Thread helper = new Thread(worker, "tiles");
            helper.setDaemon(true);
            helper.start();
            helpers.add(helper);
        }
        workers.get(0).run();
        for (Thread helper : helpers) {
            waitFor(helper);
        }
        for (Worker worker : workers) {
            worker.failure.rethrow();
        }
        return film;
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

    /** Draws tiles until none is left. What goes wrong in it stops all workers and is thrown where the film is awaited. */
    private final class Worker implements Runnable {
        private final Film film;
        private final TileQueue tiles;
        private final Shader shader = new Shader(scene, compiled);
        private final Failure failure = new Failure();

        Worker(Film film, TileQueue tiles) {
            this.film = film;
            this.tiles = tiles;
        }

        @Override
        public void run() {
            try {
                for (Optional<Tile> tile = tiles.next(); tile.isPresent(); tile = tiles.next()) {
                    draw(tile.get());
                }
            } catch (RuntimeException | Error thrown) {
                failure.keep(thrown);
                tiles.close();
            }
        }

        private void draw(Tile tile) {
            for (int y = tile.top(); y < tile.bottom(); y++) {
                for (int x = tile.left(); x < tile.right(); x++) {
                    LightSum light = named(x, y);
                    film.set(x, y, light.red(), light.green(), light.blue());
                }
            }
        }

        private LightSum named(int x, int y) {
            try {
                return light(shader, x, y);
            } catch (RuntimeException defect) {
                throw new IllegalStateException("pixel " + x + ", " + y + ": " + defect, defect);
            }
        }
    }
}
