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

    /**
     * Draws a part of the picture. The first pass looks at the pixels around it too, so that an edge is an edge whatever
     * part is asked for.
     *
     * @return what is finished; nothing of it is before the second pass
     */
    Exposure draw(Region part, Drawing drawing) {
        if (sampling.where() == PixelSampling.Where.EVERYWHERE) {
            return refined(new Film(part.width(), part.height()), part, drawing, (x, y) -> true);
        }
        FirstPass seen = new FirstPass(part.withNeighbours(settings.width(), settings.height()));
        TileQueue tiles = new TileQueue(seen.part(), settings.tileSize());
        List<Looker> workers = new ArrayList<>();
        for (int i = 0; i < settings.threads(); i++) {
            workers.add(new Looker(seen, part, tiles, drawing));
        }
        drawing.run(workers);
        Film film = seen.film().part(part.left() - seen.part().left(), part.top() - seen.part().top(),
            part.width(), part.height());
        return refined(film, part, drawing, seen::isEdge);
    }

    private Exposure refined(Film film, Region part, Drawing drawing, Selection selection) {
        TileQueue tiles = new TileQueue(part, settings.tileSize());
        List<Refiner> workers = new ArrayList<>();
        for (int i = 0; i < settings.threads(); i++) {
            workers.add(new Refiner(film, part, tiles, drawing, selection));
        }
        drawing.run(workers);
        return new Exposure(film, tiles.unfinished());
    }

    /** One pixel of it: its neighbours are asked again whether there is an edge. */
    Color pixel(int x, int y) {
        Shader shader = renderer.shader();
        if (sampling.where() == PixelSampling.Where.EVERYWHERE) {
            return mean(shader, x, y);
        }
        Region around = new Region(x, y, x + 1, y + 1).withNeighbours(settings.width(), settings.height());
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
        private final Region part;
        private final Drawing drawing;

        Looker(FirstPass seen, Region part, TileQueue tiles, Drawing drawing) {
            super(renderer, tiles, drawing.cancellation());
            this.seen = seen;
            this.part = part;
            this.drawing = drawing;
        }

        @Override
        void draw(int x, int y) {
            seen.look(renderer, shader, x, y);
        }

        @Override
        void finished(Region tile) {
            Region drawn = tile.within(part);
            drawing.progress().looked(drawn.pixelCount());
            drawing.listener().showTile(drawn, seen.film(), seen.part());
        }
    }

    /** The second pass. */
    private final class Refiner extends TileWorker {
        private final Film film;
        private final Region part;
        private final Drawing drawing;
        private final Selection selection;
        private long refined;

        Refiner(Film film, Region part, TileQueue tiles, Drawing drawing, Selection selection) {
            super(renderer, tiles, drawing.cancellation());
            this.film = film;
            this.part = part;
            this.drawing = drawing;
            this.selection = selection;
        }

        @Override
        void draw(int x, int y) {
            if (selection.includes(x, y)) {
                expose(film, x - part.left(), y - part.top(), shader, x, y);
                refined++;
            }
        }

        @Override
        void finished(Region tile) {
            drawing.progress().refined(tile.pixelCount(), refined);
            refined = 0;
            drawing.listener().showTile(tile, film, part);
        }
    }
}
