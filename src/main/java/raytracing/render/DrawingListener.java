package raytracing.render;

import raytracing.color.Color;
import raytracing.film.Film;

/** Gets the pixels of a picture as they are drawn. Several threads call it at once, each about other pixels. */
public interface DrawingListener {
    /** Does nothing. */
    DrawingListener NONE = new DrawingListener() {
    };

    /**
     * The coarse looks at a band that come before its tiles, one after the other. Each draws one pixel in every square of
     * pixels, only to be shown.
     *
     * @return edges of the squares in pixels, the coarsest first; empty by default
     */
    default int[] coarseLooks() {
        return new int[0];
    }

    /**
     * Shows a square of a coarse look.
     *
     * @param square in coordinates of the whole picture
     * @param light of the pixel in its middle
     */
    default void showSquare(Region square, Color light) {
    }

    /**
     * Shows a tile: its final pixels, or, where edges are smoothed, first what one ray through each pixel sees.
     *
     * @param tile in coordinates of the whole picture
     * @param film with the tile's pixels
     * @param filmed the part of the picture that the film shows
     */
    default void showTile(Region tile, Film film, Region filmed) {
    }
}
