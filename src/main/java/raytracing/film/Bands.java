package raytracing.film;

/**
 * A picture in bands of whole rows, from the top, each on a film of its own, so that a picture may be larger than memory.
 * All bands have {@link #bandHeight} rows but the last, which has those that are left.
 */
public interface Bands {
    /** Width of the picture in pixels, at least 1. */
    int width();

    /** Height of the picture in pixels, at least 1. */
    int height();

    /** Height of all bands but the last in pixels, at least 1. */
    int bandHeight();

    /** A band, from 0 at the top, as wide as the picture. It may be drawn during the call, and again at each call. */
    Film band(int index);

    /** How many bands there are, at least 1. */
    default int count() {
        return (int) (((long) height() + bandHeight() - 1) / bandHeight());
    }
}
