package raytracing.film;

import java.io.IOException;

/** The rows of a stored picture from the top, each once. */
interface PixelRows {
    /**
     * Reads the next row into an array of the picture's width: 8 bits each of red, green and blue, blue lowest.
     *
     * @throws IOException if the file is damaged or cut off, or of a kind that cannot be read
     */
    void next(int[] row) throws IOException;

    /**
     * A pixel for channels from 0 to 255. It counts as it looks in front of black: what is transparent has no colour that
     * anybody sees, and this program writes it as black.
     */
    static int pixel(int red, int green, int blue, int alpha) {
        return overBlack(red, alpha) << 16 | overBlack(green, alpha) << 8 | overBlack(blue, alpha);
    }

    private static int overBlack(int channel, int alpha) {
        return (2 * channel * alpha + 255) / 510;
    }
}
