package raytracing.render;

import raytracing.film.Film;
import raytracing.render.Cancellation.Leftovers;

/**
 * A finished picture and what it took.
 *
 * @param film the whole picture in one band
 * @param refinedPixels how many of its pixels got N x N rays, where N is above 1
 */
public record Rendering(Film film, long refinedPixels) {
    /** Draws the region of a renderer's settings. */
    public static Rendering of(Renderer renderer) {
        Drawing drawing = new Drawing(renderer, renderer.settings().region().height(),
            new Cancellation(), Leftovers.DISCARD, DrawingListener.NONE);
        return new Rendering(drawing.band(0), drawing.progress().refined());
    }

    /** How much of the picture got N x N rays, from 0 to 1. */
    public double refinedShare() {
        return (double) refinedPixels / ((double) film.width() * film.height());
    }
}
