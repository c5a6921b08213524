package raytracing.film;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.zip.Inflater;
import java.util.zip.InflaterInputStream;

/**
 * The rows of a PNG file of the usual kind, with only two of them in memory: 8 bits a channel, grey or red, green and blue,
 * with alpha or without, and neither a palette nor a transparent colour nor interlaced. ImageIO's reader decodes all of the
 * file for every part that is asked of it. Format: {@link PngChunk}.
 */
final class PngRows implements PixelRows {
    private static final int BUFFER = 1 << 16;

    /** Compression, filter and interlacing of the usual kind. */
    private static final int METHODS = 0;

    private final int width;
    private final int height;
    private final int channels;
    private final InputStream pixels;
    private byte[] bytes;
    private byte[] above;
    private int y;

    private PngRows(int width, int height, int channels, InputStream pixels) {
        this.width = width;
        this.height = height;
        this.channels = channels;
        this.pixels = pixels;
        bytes = new byte[channels * width];
        above = new byte[channels * width];
    }

    /**
     * The rows of a file; empty if it is no PNG file or not of the usual kind.
     *
     * @param file from its first byte on
     * @throws IOException if it ends early
     */
    static Optional<PngRows> of(InputStream file) throws IOException {
        byte[] signature = file.readNBytes(Long.BYTES);
        if (signature.length < Long.BYTES || ByteBuffer.wrap(signature).getLong() != PngChunk.SIGNATURE) {
            return Optional.empty();
        }
        DataInputStream data = new DataInputStream(file);
        boolean isUsual = data.readInt() == PngChunk.HEADER_LENGTH & data.readInt() == PngChunk.HEADER;
        int width = data.readInt();
        int height = data.readInt();
        isUsual &= data.read() == PngChunk.DEPTH;
        int channels = channels(data.read());
        isUsual &= data.read() == METHODS && data.read() == METHODS && data.read() == METHODS;
        data.readInt();
        if (!isUsual || width < 1 || height < 1 || channels == 0 || width > Film.MOST_PIXELS / 2) {
            return Optional.empty();
        }
        int length = data.readInt();
        for (int kind = data.readInt(); kind != PngChunk.PIXELS; kind = data.readInt()) {
            if (kind == PngChunk.TRANSPARENT_COLOR) {
                return Optional.empty();
            }
            data.skipNBytes(length + (long) PngChunk.CHECKSUM_LENGTH);
            length = data.readInt();
        }
        return Optional.of(new PngRows(width, height, channels,
            new InflaterInputStream(new Parts(data, length), new Inflater(), BUFFER)));
    }

    /** How many channels a kind of colours has; 0 with a palette and for what is no kind. */
    private static int channels(int kind) {
        return switch (kind) {
            case PngChunk.GREY -> 1;
            case PngChunk.GREY_AND_ALPHA -> 2;
            case PngChunk.RGB -> 3;
            case PngChunk.RGB_AND_ALPHA -> 4;
            default -> 0;
        };
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    @Override
    public void next(int[] row) throws IOException {
        int filter = pixels.read();
        byte[] older = above;
        above = bytes;
        bytes = older;
        if (filter < 0 || pixels.readNBytes(bytes, 0, bytes.length) < bytes.length) {
            throw new EOFException();
        }
        undo(filter);
        if (++y == height && pixels.read() >= 0) {       // reads the end, and with it the checksum
            throw new IOException("more pixels than the file says");
        }
        for (int x = 0; x < width; x++) {
            int i = channels * x;
            int first = bytes[i] & 0xff;
            int alpha = channels % 2 == 0 ? bytes[i + channels - 1] & 0xff : 0xff;
            row[x] = channels < 3 ? PixelRows.pixel(first, first, first, alpha)
                : PixelRows.pixel(first, bytes[i + 1] & 0xff, bytes[i + 2] & 0xff, alpha);
        }
    }

    /** Each byte was written as its difference from what the bytes to the left and above foretell. */
    private void undo(int filter) throws IOException {
        switch (filter) {
            case 0 -> { }
            case 1 -> undo((left, up, corner) -> left);
            case 2 -> undo((left, up, corner) -> up);
            case 3 -> undo((left, up, corner) -> (left + up) / 2);
            case 4 -> undo(PngRows::paeth);
            default -> throw new IOException("unknown filter " + filter);
        }
    }

    /** What a byte probably is, for those to the left, above, and above to the left; all from 0 to 255. */
    private interface Forecast {
        int of(int left, int up, int corner);
    }

    private void undo(Forecast forecast) {
        for (int i = 0; i < bytes.length; i++) {
            boolean isFirst = i < channels;
            int left = isFirst ? 0 : bytes[i - channels] & 0xff;
            int corner = isFirst ? 0 : above[i - channels] & 0xff;
            bytes[i] += (byte) forecast.of(left, above[i] & 0xff, corner);
        }
    }

    private static int paeth(int left, int up, int corner) {
        int toLeft = Math.abs(up - corner);
        int toUp = Math.abs(left - corner);
        int toCorner = Math.abs(left + up - 2 * corner);
        if (toLeft <= toUp && toLeft <= toCorner) {
            return left;
        }
        return toUp <= toCorner ? up : corner;
    }

    /** The bytes of the parts into which the compressed pixels are cut. */
    private static final class Parts extends InputStream {
        private final DataInputStream file;
        private int left;

        private Parts(DataInputStream file, int length) {
            this.file = file;
            left = length;
        }

        @Override
        public int read() throws IOException {
            byte[] one = new byte[1];
            return read(one, 0, 1) < 0 ? -1 : one[0] & 0xff;
        }

        @Override
        public int read(byte[] target, int from, int length) throws IOException {
            while (left == 0) {
                file.skipNBytes(PngChunk.CHECKSUM_LENGTH);
                left = file.readInt();
                if (file.readInt() != PngChunk.PIXELS) {
                    return -1;
                }
            }
            int read = file.read(target, from, Math.min(length, left));
            left -= Math.max(read, 0);
            return read;
        }
    }
}
