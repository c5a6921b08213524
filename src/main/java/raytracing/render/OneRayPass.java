package raytracing.render;

import raytracing.film.Film;
import raytracing.shade.LightSum;

/** Draws with one ray through the centre of each pixel. */
final class OneRayPass extends TileWorker {
    private final Renderer renderer;
    private final Film film;
    private final Region filmed;
    private final Progress progress;
    private final DrawingListener listener;

    /** Exposes a film of a part of the picture. */
    OneRayPass(Renderer renderer, TileQueue tiles, Film film, Region filmed, Drawing drawing) {
        super(renderer, tiles, drawing.cancellation());
        this.renderer = renderer;
        this.film = film;
        this.filmed = filmed;
        progress = drawing.progress();
        listener = drawing.listener();
    }

    @Override
    void draw(int x, int y) {
        LightSum light = renderer.oneRay(shader, x, y);
        film.set(x - filmed.left(), y - filmed.top(), light.red(), light.green(), light.blue());
    }

    @Override
    void finished(Region tile) {
        progress.looked(tile.pixelCount());
        listener.showTile(tile, film, filmed);
    }
}
