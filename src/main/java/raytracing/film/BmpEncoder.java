package raytracing.film;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * A BMP file, to the byte that of ImageIO: 24 bits a pixel, not compressed, the rows from the bottom, each padded to a
 * multiple of four bytes. All numbers are little-endian. Format: BITMAPFILEHEADER and BITMAPINFOHEADER of the Windows GDI.
 */
final class BmpEncoder implements Encoder {
    private static final short SIGNATURE = 'B' | 'M' << 8;
    private static final int HEADERS_LENGTH = 54;
    private static final int SECOND_HEADER_LENGTH = 40;
    private static final short PLANES = 1;
    private static final short BITS_A_PIXEL = 24;

    private final BandedRows rows;
    private final int width;
    private final int height;

    /** Draws the last band. */
    BmpEncoder(Bands bands) {
        rows = new BandedRows(bands, bands.count() - 1);
        width = bands.width();
        height = bands.height();
    }

    @Override
    public void writeTo(OutputStream file) throws IOException {
        int rowLength = (3 * width + 3) / 4 * 4;
        file.write(headers(rowLength * height));
        int[] pixels = new int[width];
        byte[] row = new byte[rowLength];
        for (int y = height - 1; y >= 0; y--) {
            rows.read(y, pixels);
            for (int x = 0; x < width; x++) {
                row[3 * x] = (byte) pixels[x];
                row[3 * x + 1] = (byte) (pixels[x] >> 8);
                row[3 * x + 2] = (byte) (pixels[x] >> 16);
            }
            file.write(row);
        }
    }

    /** What is not said is 0: no compression, no palette, no size on paper. */
    private byte[] headers(int pixelsLength) {
        return ByteBuffer.allocate(HEADERS_LENGTH).order(ByteOrder.LITTLE_ENDIAN)
            .putShort(SIGNATURE).putInt(HEADERS_LENGTH + pixelsLength).putInt(0).putInt(HEADERS_LENGTH)
            .putInt(SECOND_HEADER_LENGTH).putInt(width).putInt(height).putShort(PLANES).putShort(BITS_A_PIXEL)
            .putInt(0).putInt(pixelsLength).array();
    }
}
