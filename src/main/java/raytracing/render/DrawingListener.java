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
     * @return edges of the squares in pixels, the coarsest first; empty, as it is unless said otherwise, if there is no need
     */
    default int[] coarseLooks() {
        return new int[0];
    }

    /**
     * A first look at some pixels, for those who asked for such looks.
     *
     * @param square of them; coordinates of the whole picture
     * @param light of one of them
     */
    default void showSquare(Region square, Color light) {
        throw new IllegalStateException("no coarse look was asked for");
    }

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
        private Nobody() {
        }

        @Override
        public void showTile(Region tile, Film film, Region filmed) {
            // not looked at
        }
    }
}
