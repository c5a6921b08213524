package raytracing.render;

import raytracing.color.Color;
import raytracing.film.Film;

/** Is told what a picture looks like while it is drawn, by several threads at once, each about other pixels. */
public interface DrawingListener {
    /** Looks away. */
    DrawingListener NONE = new Nobody();

    /**
     * How coarse the first looks at a band are, each before the next and all before its tiles: one pixel in each square
     * is drawn only to be shown.
     *
     * @return edges of the squares in pixels, the coarsest first; empty if there is no need
     */
    int[] coarseLooks();

    /**
     * A first look at some pixels.
     *
     * @param square of them; coordinates of the whole picture
     * @param light of one of them
     */
    void showSquare(Region square, Color light);

    /**
     * Pixels as they are in the picture, or, where edges are smoothed, as one ray sees them before.
     *
     * @param tile of them; coordinates of the whole picture
     * @param film that they are on
     * @param filmed what the film shows; coordinates of the whole picture
     */
    void showTile(Region tile, Film film, Region filmed);

    /** Nobody looks. */
    final class Nobody implements DrawingListener {
        private static final int[] NO_LOOKS = {};

        private Nobody() {
        }

        @Override
        public int[] coarseLooks() {
            return NO_LOOKS;
        }

        @Override
        public void showSquare(Region square, Color light) {
            // not looked at
        }

        @Override
        public void showTile(Region tile, Film film, Region filmed) {
            // not looked at
        }
    }
}
