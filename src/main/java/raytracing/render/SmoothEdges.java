package raytracing.render;

import java.util.Optional;
import raytracing.film.Film;

/**
 * Draws with N x N rays in each pixel where a first pass found an edge, or in all pixels if there was no first pass.
 *
 * @param film of the part, with what the first pass saw of it
 */
record SmoothEdges(PixelGrid grid, Region part, Film film, Optional<OneRayEach> first, Progress progress,
                   DrawingListener listener) implements PixelPainter {
    @Override
    public void paint(int x, int y, PixelLight light) {
        if (first.isEmpty() || first.get().isEdge(x, y)) {
            light.exposeRefined(grid, x, y, film, x - part.left(), y - part.top());
        }
    }

    @Override
    public void finished(Region tile, PixelLight light) {
        progress.addSmoothed(tile.pixelCount(), light.refinedPixels(),
            light.refinedPixels() * grid.root() * grid.root());
        listener.showTile(tile, film, part);
    }
}
