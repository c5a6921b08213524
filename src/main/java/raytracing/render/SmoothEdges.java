package raytracing.render;

import java.util.ArrayList;
import java.util.List;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.math.CounterRandom;
import raytracing.shade.LightSum;
import raytracing.shade.Shader;

/**
 * Draws with N x N rays in a pixel where a first pass with one ray found an edge. The light of such a pixel is the mean
 * of what a picture of single rays would show of each: cut off at 1 before the mean, not after it, or the edge of
 * whatever is much brighter than 1 would be as jagged as with one ray.
 */
final class SmoothEdges {
    private final Renderer renderer;
    private final RenderSettings settings;
    private final PixelSampling sampling;

    SmoothEdges(Renderer renderer, RenderSettings settings) {
        this.renderer = renderer;
        this.settings = settings;
        sampling = settings.sampling();
    }

    /** The pixels that get N x N rays. */
    private interface Selection {
        boolean includes(int x, int y);
    }

    /** The whole picture. */
    Rendering draw() {
        if (sampling.where() == PixelSampling.Where.EVERYWHERE) {
            return refined(new Film(settings.width(), settings.height()), (x, y) -> true);
        }
        FirstPass seen = new FirstPass(new Tile(0, 0, settings.width(), settings.height()));
        TileQueue tiles = renderer.tiles();
        List<Looker> workers = new ArrayList<>();
        for (int i = 0; i < settings.threads(); i++) {
            workers.add(new Looker(seen, tiles));
        }
        TileWorker.runAll(workers);
        return refined(seen.film().copy(), seen::isEdge);
    }

    private Rendering refined(Film film, Selection selection) {
        TileQueue tiles = renderer.tiles();
        List<Refiner> workers = new ArrayList<>();
        for (int i = 0; i < settings.threads(); i++) {
            workers.add(new Refiner(film, tiles, selection));
        }
        TileWorker.runAll(workers);
        return new Rendering(film, workers.stream().mapToLong(worker -> worker.refined).sum());
    }

    /** One pixel of it: its neighbours are asked again whether there is an edge. */
    Color pixel(int x, int y) {
        Shader shader = renderer.shader();
        if (sampling.where() == PixelSampling.Where.EVERYWHERE) {
            return mean(shader, x, y);
        }
        Tile around = new Tile(Math.max(x - 1, 0), Math.max(y - 1, 0),
            Math.min(x + 2, settings.width()), Math.min(y + 2, settings.height()));
        FirstPass seen = new FirstPass(around);
        for (int j = around.top(); j < around.bottom(); j++) {
            for (int i = around.left(); i < around.right(); i++) {
                seen.look(renderer, shader, i, j);
            }
        }
        return seen.isEdge(x, y) ? mean(shader, x, y) : seen.film().get(x - around.left(), y - around.top());
    }

    private Color mean(Shader shader, int x, int y) {
        Film one = new Film(1, 1);
        expose(one, 0, 0, shader, x, y);
        return one.get(0, 0);
    }

    /** Every ray has random numbers of its own. */
    private void expose(Film film, int column, int row, Shader shader, int x, int y) {
        int root = sampling.root();
        long key = renderer.key(x, y);
        double red = 0;
        double green = 0;
        double blue = 0;
        for (int j = 0; j < root; j++) {
            for (int i = 0; i < root; i++) {
                LightSum light = renderer.ray(shader, x + sampling.placeX(i, j), y + sampling.placeY(i, j),
                    CounterRandom.bits(key, j * root + i));
                red += Film.shown(light.red());
                green += Film.shown(light.green());
                blue += Film.shown(light.blue());
            }
        }
        double rays = root * root;
        film.set(column, row, red / rays, green / rays, blue / rays);
    }

    /** The first pass. */
    private final class Looker extends TileWorker {
        private final FirstPass seen;

        Looker(FirstPass seen, TileQueue tiles) {
            super(renderer, seen.film(), tiles);
            this.seen = seen;
        }

        @Override
        void draw(int x, int y) {
            seen.look(renderer, shader, x, y);
        }
    }

    /** The second pass. */
    private final class Refiner extends TileWorker {
        private final Selection selection;
        private long refined;

        Refiner(Film film, TileQueue tiles, Selection selection) {
            super(renderer, film, tiles);
            this.selection = selection;
        }

        @Override
        void draw(int x, int y) {
            if (selection.includes(x, y)) {
                expose(film, x, y, shader, x, y);
                refined++;
            }
        }
    }
}
