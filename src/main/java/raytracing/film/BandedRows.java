package raytracing.film;

/** The rows of a picture as its file has them, read from the top or from the bottom, with only one band in memory. */
final class BandedRows {
    private final Bands bands;
    private Film band;
    private int index;

    /** Of a picture whose band {@code first} will be read first, which is drawn here. */
    BandedRows(Bands bands, int first) {
        this.bands = bands;
        index = first;
        band = bands.band(first);
    }

    /** Writes a row, from 0 at the top, into an array of the picture's width, each pixel as {@link Film#encoded(int, int)}. */
    void read(int y, int[] row) {
        if (y / bands.bandHeight() != index) {
            index = y / bands.bandHeight();
            band = new Film(1, 1);           // frees the old band first: memory may hold only one
            band = bands.band(index);
        }
        band.encodeRow(y - index * bands.bandHeight(), row);
    }

    /** Whether the band of the row that was read last has gaps; before that, whether the first band has some. */
    boolean hasGaps() {
        return band.hasGaps();
    }

    /** Whether a pixel of the row that was read last is a gap. */
    boolean isGap(int x, int y) {
        return band.isGap(x, y - index * bands.bandHeight());
    }
}
