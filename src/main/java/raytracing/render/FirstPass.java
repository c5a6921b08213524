package raytracing.render;

import raytracing.film.Film;
import raytracing.shade.LightSum;
import raytracing.shade.Shader;

/**
 * What one ray through the centre of each pixel saw, in a part of a picture: the light that the pixels show and the
 * surfaces that it came from. Tells where neither is even.
 */
final class FirstPass {
    /** Neighbours whose shown channels differ by more have an edge between them (measured: DECISIONS). */
    private static final double MOST_CONTRAST = 8 / 255.0;

    private final Region part;
    private final int width;
    private final Film film;
    private final long[] fingerprints;

    FirstPass(Region part) {
        this.part = part;
        width = part.width();
        film = new Film(width, part.height());
        fingerprints = new long[width * film.height()];
    }

    /** Asks the ray of a pixel in the part. */
    void look(Renderer renderer, Shader shader, int x, int y) {
        LightSum light = renderer.oneRay(shader, x, y);
        int column = x - part.left();
        int row = y - part.top();
        film.set(column, row, light.red(), light.green(), light.blue());
        fingerprints[row * width + column] = shader.fingerprint();
    }

    /** What it sees of the picture. */
    Region part() {
        return part;
    }

    /** The light of the pixels, (0, 0) at the part's left and upper corner. */
    Film film() {
        return film;
    }

    /** Whether a pixel differs from one of its eight neighbours, as far as they are in the part. */
    boolean isEdge(int x, int y) {
        int column = x - part.left();
        int row = y - part.top();
        for (int j = Math.max(row - 1, 0); j < Math.min(row + 2, film.height()); j++) {
            for (int i = Math.max(column - 1, 0); i < Math.min(column + 2, width); i++) {
                if (differ(column, row, i, j)) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean differ(int column, int row, int i, int j) {
        return fingerprints[row * width + column] != fingerprints[j * width + i]
            || film.contrast(column, row, i, j) > MOST_CONTRAST;
    }
}
