package raytracing.film;

/**
 * A picture that is there already.
 *
 * @param film all of it
 */
record OneBand(Film film) implements Bands {
    @Override
    public int width() {
        return film.width();
    }

    @Override
    public int height() {
        return film.height();
    }

    @Override
    public int bandHeight() {
        return film.height();
    }

    @Override
    public Film band(int index) {
        return film;
    }
}
