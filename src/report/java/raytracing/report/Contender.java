package raytracing.report;

import java.io.IOException;
import raytracing.film.Film;

/** A way to draw a picture, ours or a peer's. */
interface Contender {
    /** Its name on the plot. */
    String title();

    /** Draws the picture once. */
    Drawn draw() throws IOException;

    /**
     * A picture and its price.
     *
     * @param film in linear light
     * @param milliseconds of processor time, of all threads
     */
    record Drawn(Film film, double milliseconds) {
    }
}
