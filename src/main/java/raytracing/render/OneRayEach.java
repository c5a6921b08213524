package raytracing.render;

import raytracing.color.MutableColor;
import raytracing.film.Film;

/**
 * Draws with one ray through the centre of each pixel. Where edges are to be smoothed, it also draws the pixels around the
 * part, so that an edge is the same whatever part is drawn, and remembers which surfaces each ray met.
 *
 * @param filmed the part, or the part with the pixels around it
 * @param film of the filmed pixels
 * @param fingerprints of the surfaces met by the ray of each filmed pixel; empty if no edges are looked for
 */
record OneRayEach(Region part, Region filmed, Film film, long[] fingerprints, Progress progress, DrawingListener listener)
    implements PixelPainter {
    /** Neighbours whose shown channels differ by more have an edge between them (measured: DECISIONS). */
    private static final double MOST_CONTRAST = 8 / 255.0;

    /** The whole picture of a part. */
    static OneRayEach of(Region part, Progress progress, DrawingListener listener) {
        return new OneRayEach(part, part, new Film(part.width(), part.height()), new long[0], progress, listener);
    }

    /** The pass before edges are smoothed in a part. */
    static OneRayEach findingEdges(Region part, Region filmed, Progress progress, DrawingListener listener) {
        return new OneRayEach(part, filmed, new Film(filmed.width(), filmed.height()), new long[(int) filmed.pixelCount()],
            progress, listener);
    }

    @Override
    public void paint(int x, int y, PixelLight light) {
        MutableColor sum = light.ofOneRay(x, y);
        int column = x - filmed.left();
        int row = y - filmed.top();
        film.set(column, row, sum.red(), sum.green(), sum.blue());
        if (fingerprints.length > 0) {
            fingerprints[row * filmed.width() + column] = light.fingerprint();
        }
    }

    @Override
    public void finished(Region tile, PixelLight light) {
        Region drawn = tile.intersection(part);
        progress.addFirstRays(drawn.pixelCount());
        listener.showTile(drawn, film, filmed);
    }

    /** A copy without the pixels around the part. */
    Film filmOfPart() {
        return film.part(part.left() - filmed.left(), part.top() - filmed.top(), part.width(), part.height());
    }

    /** Whether a pixel differs from one of its eight neighbours, in its surfaces or in its light. */
    boolean isEdge(int x, int y) {
        int column = x - filmed.left();
        int row = y - filmed.top();
        long fingerprint = fingerprints[row * filmed.width() + column];
        for (int j = Math.max(row - 1, 0); j < Math.min(row + 2, filmed.height()); j++) {
            for (int i = Math.max(column - 1, 0); i < Math.min(column + 2, filmed.width()); i++) {
                if (fingerprints[j * filmed.width() + i] != fingerprint || film.contrast(column, row, i, j) > MOST_CONTRAST) {
                    return true;
                }
            }
        }
        return false;
    }
}
