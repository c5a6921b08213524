package raytracing.film;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.util.zip.CRC32;
import java.util.zip.Deflater;

/**
 * A PNG file, to the byte that of ImageIO, whose classes and those that they need take most of the time in which a small
 * picture is drawn by a cold virtual machine. Its pixels have 8 bits a channel and are not filtered. Gaps are transparent
 * where {@link ImageFormat#showsGaps} is true. Format: {@link PngChunk}.
 */
final class PngEncoder implements Encoder {
    /** From 0 to 9: how much time zlib takes to make the file smaller. */
    private static final int COMPRESSION = 4;

    /** Most bytes of compressed pixels in a chunk. */
    private static final int PART = 1 << 15;

    private final BandedRows rows;
    private final int width;
    private final int height;
    private final boolean isTransparent;
    private final CRC32 checksum = new CRC32();
    private final ByteBuffer chunk = ByteBuffer.allocate(PngChunk.START_LENGTH + PART + PngChunk.CHECKSUM_LENGTH);

    /** Draws the first band. */
    PngEncoder(Bands bands) {
        rows = new BandedRows(bands, 0);
        width = bands.width();
        height = bands.height();
        isTransparent = ImageFormat.PNG.showsGaps(bands) && rows.hasGaps();
    }

    @Override
    public void writeTo(OutputStream file) throws IOException {
        file.write(ByteBuffer.allocate(Long.BYTES).putLong(PngChunk.SIGNATURE).array());
        begin(PngChunk.HEADER).putInt(width).putInt(height).put((byte) PngChunk.DEPTH)
            .put((byte) (isTransparent ? PngChunk.RGB_AND_ALPHA : PngChunk.RGB)).put((byte) 0).put((byte) 0).put((byte) 0);
        end(file);
        Deflater deflater = new Deflater(COMPRESSION);
        try {
            writePixels(deflater, file);
        } finally {
            deflater.end();                  // its memory is outside the heap
        }
        begin(PngChunk.END);
        end(file);
    }

    private void writePixels(Deflater deflater, OutputStream file) throws IOException {
        int[] pixels = new int[width];
        byte[] row = new byte[1 + (isTransparent ? 4 : 3) * width];
        begin(PngChunk.PIXELS);
        for (int y = 0; y < height; y++) {
            rows.read(y, pixels);
            fill(row, pixels, y);
            deflater.setInput(row);
            deflate(deflater, file);
        }
        deflater.finish();
        deflate(deflater, file);
        if (chunk.position() > PngChunk.START_LENGTH) {
            end(file);
        }
    }

    /** Fills in the bytes of a row after the first, which is 0 as there is no filter. */
    private void fill(byte[] row, int[] pixels, int y) {
        int i = 1;
        for (int x = 0; x < width; x++) {
            boolean isGap = isTransparent && rows.isGap(x, y);
            int pixel = isGap ? 0 : pixels[x];
            row[i] = (byte) (pixel >> 16);
            row[i + 1] = (byte) (pixel >> 8);
            row[i + 2] = (byte) pixel;
            i += 3;
            if (isTransparent) {
                row[i++] = (byte) (isGap ? 0 : 0xff);
            }
        }
    }

    /** Adds what the compressor has ready to the chunk, and begins another one whenever there is more than it may hold. */
    private void deflate(Deflater deflater, OutputStream file) throws IOException {
        int end = PngChunk.START_LENGTH + PART;
        int length = deflater.deflate(chunk.array(), chunk.position(), end - chunk.position());
        while (length > 0) {
            chunk.position(chunk.position() + length);
            if (chunk.position() == end) {
                end(file);
                begin(PngChunk.PIXELS);
            }
            length = deflater.deflate(chunk.array(), chunk.position(), end - chunk.position());
        }
    }

    private ByteBuffer begin(int kind) {
        return chunk.clear().putInt(0).putInt(kind);
    }

    /** Completes the chunk by its length and checksum, and writes it. */
    private void end(OutputStream file) throws IOException {
        chunk.putInt(0, chunk.position() - PngChunk.START_LENGTH);
        checksum.reset();
        checksum.update(chunk.array(), Integer.BYTES, chunk.position() - Integer.BYTES);
        chunk.putInt((int) checksum.getValue());
        file.write(chunk.array(), 0, chunk.position());
    }
}
