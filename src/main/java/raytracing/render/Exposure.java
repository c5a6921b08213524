package raytracing.render;

import java.util.List;
import raytracing.film.Film;

/**
 * What workers leave behind.
 *
 * @param film a part of the picture
 * @param unfinished those of its tiles that the film does not show as they should be, in the picture's coordinates; none
 *        unless the work was cancelled
 */
record Exposure(Film film, List<Region> unfinished) {
}
