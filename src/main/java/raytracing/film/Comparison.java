package raytracing.film;

import java.io.IOException;

/**
 * How far one picture is from another of the same size, in steps of 1/255, over red, green and blue of all pixels.
 *
 * @param pixels of one of the pictures, at least 1
 * @param squares sum of the squares of all differences
 * @param largest difference of a channel
 * @param off pixels of which a channel differs by more than one step
 */
public record Comparison(long pixels, long squares, int largest, long off) {
    private static final int CHANNELS = 3;
    private static final double FULL = 255;

    /**
     * Reads and compares two pictures of the same size.
     *
     * @throws IOException if a file cannot be read to its end
     */
    public static Comparison of(StoredPicture found, StoredPicture expected) throws IOException {
        PixelRows foundRows = found.rows();
        PixelRows expectedRows = expected.rows();
        int[] foundRow = new int[found.width()];
        int[] expectedRow = new int[found.width()];
        long squares = 0;
        int largest = 0;
        long off = 0;
        for (int y = 0; y < found.height(); y++) {
            foundRows.next(foundRow);
            expectedRows.next(expectedRow);
            for (int x = 0; x < foundRow.length; x++) {
                int largestHere = largest(foundRow[x], expectedRow[x]);
                squares += squares(foundRow[x], expectedRow[x]);
                largest = Math.max(largest, largestHere);
                off += largestHere > 1 ? 1 : 0;
            }
        }
        return new Comparison((long) found.width() * found.height(), squares, largest, off);
    }

    /** The largest difference of a channel of two pixels, each of 8 bits a channel. */
    static int largest(int found, int expected) {
        return Math.max(Math.abs(difference(found, expected, 16)),
            Math.max(Math.abs(difference(found, expected, 8)), Math.abs(difference(found, expected, 0))));
    }

    private static int squares(int found, int expected) {
        int red = difference(found, expected, 16);
        int green = difference(found, expected, 8);
        int blue = difference(found, expected, 0);
        return red * red + green * green + blue * blue;
    }

    private static int difference(int found, int expected, int shift) {
        return (found >> shift & 0xff) - (expected >> shift & 0xff);
    }

    /** The root of the mean square of the differences, in steps; 0 only for equal pictures. */
    public double rootMeanSquare() {
        return Math.sqrt(squares / ((double) CHANNELS * pixels));
    }

    /** The peak signal-to-noise ratio in decibels; infinite for equal pictures. */
    public double psnr() {
        return 10 * StrictMath.log10(FULL * FULL * CHANNELS * pixels / squares);
    }

    /** Share of the pixels of which a channel differs by more than one step. */
    public double shareOff() {
        return (double) off / pixels;
    }
}
