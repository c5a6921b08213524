package raytracing.render;

/**
 * Draws a part under an {@link ErrorLimit} after its {@link FirstRays}, on their film.
 *
 * @param errors gets those of the finished tiles; guarded by itself
 */
record ErrorRefinement(Region part, FirstRays first, ErrorTally errors, Progress progress,
                       DrawingListener listener) implements PixelPainter {
    @Override
    public void paint(int x, int y, PixelLight light) {
        AdaptivePixel pixel = light.adaptive();
        first.look(x, y, pixel.neighbourhood());
        pixel.refine(x, y, first.film(), x - part.left(), y - part.top());
    }

    @Override
    public void finished(Region tile, PixelLight light) {
        ErrorTally tally = light.adaptive().tally();
        synchronized (errors) {
            errors.add(tally);
        }
        progress.addSmoothed(tile.pixelCount(), tally.refined(), tally.furtherRays());
        listener.showTile(tile, first.film(), part);
    }
}
