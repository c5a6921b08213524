package raytracing.film;

import java.io.IOException;
import java.io.UncheckedIOException;

/**
 * Where two pictures of the same size differ: the largest difference of a channel of each pixel, in false colours that get
 * brighter with it. Black is no difference; between the colours below, they change evenly.
 */
public final class DifferenceMap implements Bands {
    /** What the colours mean, in steps of 1/255. */
    public static final String LEGEND = "black equal, blue 1 step, violet 4, red 16, yellow 64, white 255";

    /** Differences four times as large as the one before, so that a single step is seen and large ones are told apart. */
    private static final int[] STEPS = {1, 4, 16, 64, 255};
    private static final int[] COLORS = {0x2020b0, 0xa028d0, 0xf04838, 0xffd000, 0xffffff};

    /** Their film takes 48 MB. */
    private static final int MOST_PIXELS_IN_A_BAND = 1 << 21;

    private final StoredPicture found;
    private final StoredPicture expected;
    private PixelRows foundRows;
    private PixelRows expectedRows;
    private int y;

    /** A map of the size of the pictures, which are read while it is. */
    public DifferenceMap(StoredPicture found, StoredPicture expected) throws IOException {
        this.found = found;
        this.expected = expected;
        foundRows = found.rows();
        expectedRows = expected.rows();
    }

    @Override
    public int width() {
        return found.width();
    }

    @Override
    public int height() {
        return found.height();
    }

    @Override
    public int bandHeight() {
        return Math.min(height(), Math.max(1, MOST_PIXELS_IN_A_BAND / width()));
    }

    /**
     * {@inheritDoc} Files are read downwards, so that bands in another order take long in large pictures.
     *
     * @throws UncheckedIOException if a file cannot be read to its end
     */
    @Override
    public Film band(int index) {
        int top = index * bandHeight();
        Film film = new Film(width(), Math.min(bandHeight(), height() - top));
        int[] foundRow = new int[width()];
        int[] expectedRow = new int[width()];
        try {
            if (y > top) {
                foundRows = found.rows();
                expectedRows = expected.rows();
                y = 0;
            }
            for (; y < top + film.height(); y++) {
                foundRows.next(foundRow);
                expectedRows.next(expectedRow);
                for (int x = 0; x < width() && y >= top; x++) {
                    int color = color(Comparison.largest(foundRow[x], expectedRow[x]));
                    film.set(x, y - top, channel(color, 16), channel(color, 8), channel(color, 0));
                }
            }
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
        return film;
    }

    private static double channel(int color, int shift) {
        return (color >> shift & 0xff) / 255.0;
    }

    /** The colour for a difference from 0 to 255, as 8 bits each of red, green and blue. */
    static int color(int steps) {
        if (steps == 0) {
            return 0;
        }
        int above = 1;
        while (STEPS[above] < steps) {
            above++;
        }
        double position = (steps - STEPS[above - 1]) / (double) (STEPS[above] - STEPS[above - 1]);
        return mixed(above, position, 16) << 16 | mixed(above, position, 8) << 8 | mixed(above, position, 0);
    }

    private static int mixed(int above, double position, int shift) {
        int from = COLORS[above - 1] >> shift & 0xff;
        int to = COLORS[above] >> shift & 0xff;
        return (int) Math.round(from + position * (to - from));
    }
}
