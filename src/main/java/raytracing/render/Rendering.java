package raytracing.render;

import raytracing.film.Film;

/**
 * A finished picture and what it took.
 *
 * @param film the picture
 * @param refinedPixels how many of its pixels got N x N rays, where N is above 1
 */
public record Rendering(Film film, long refinedPixels) {
    /**
     * How much of the picture got N x N rays.
     *
     * @return from 0 to 1
     */
    public double refinedShare() {
        return (double) refinedPixels / ((double) film.width() * film.height());
    }
}
