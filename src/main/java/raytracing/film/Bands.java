package raytracing.film;

/**
 * A picture in bands: stacks of whole rows, from the top, each on a film of its own, so that a picture may be larger than
 * memory. All bands have {@link #bandHeight} rows but the last, which has what is left.
 */
public interface Bands {
    /**
     * Width of the picture.
     *
     * @return in pixels, at least 1
     */
    int width();

    /**
     * Height of the picture.
     *
     * @return in pixels, at least 1
     */
    int height();

    /**
     * Height of all bands but the last.
     *
     * @return in pixels, at least 1
     */
    int bandHeight();

    /**
     * A part of the picture. It may be made only now, and anew for each call.
     *
     * @param index of the band, counted from 0 at the top
     * @return as wide as the picture
     */
    Film band(int index);

    /**
     * How many bands there are.
     *
     * @return at least 1
     */
    default int count() {
        return (int) (((long) height() + bandHeight() - 1) / bandHeight());
    }

    /**
     * A picture in one band.
     *
     * @param film the picture
     * @return its only band
     */
    static Bands of(Film film) {
        return new OneBand(film);
    }
}
