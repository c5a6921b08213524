package raytracing.film;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.ComponentColorModel;
import java.io.IOException;
import java.util.Iterator;
import java.util.Optional;
import javax.imageio.ImageIO;
import javax.imageio.ImageReadParam;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;

/**
 * The rows of a picture file as Java's own readers decode it, some rows at a time. The values are those in the file: no
 * colour profile and no gamma is applied, and 16 bits are rounded to 8.
 */
final class ImageIoRows implements PixelRows {
    private static final int FULL = 255;

    private final ImageReader reader;
    private final int width;
    private final int height;
    private final int most;
    private BufferedImage rows;
    private int top;
    private int y;
    private int[] samples = new int[0];
    private boolean isIncomplete;

    private ImageIoRows(ImageReader reader, long mostPixels) throws IOException {
        this.reader = reader;
        width = reader.getWidth(0);
        height = reader.getHeight(0);
        most = (int) Math.max(1, Math.min(mostPixels / width, height));
        rows = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
        // The reader of JPEG files only warns of pixels that are missing. What it said about their header does not matter.
        reader.addIIOReadWarningListener((source, warning) -> isIncomplete = true);
    }

    /**
     * The rows of a file, decoded at most so many pixels at once but at least a row; empty if no reader knows its format, or
     * if the format is not one of {@link ImageFormat}.
     *
     * @throws IOException if the file is damaged
     */
    static Optional<ImageIoRows> of(ImageInputStream file, long mostPixels) throws IOException {
        Iterator<ImageReader> readers = ImageIO.getImageReaders(file);
        while (readers.hasNext()) {
            ImageReader reader = readers.next();
            if (ImageFormat.ofEnding("." + reader.getFormatName()).isPresent()) {
                reader.setInput(file, false, true);
                return Optional.of(new ImageIoRows(reader, mostPixels));
            }
        }
        return Optional.empty();
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    @Override
    public void next(int[] row) throws IOException {
        if (y == 0 || y == top + rows.getHeight()) {
            decode();
        }
        ColorModel model = rows.getColorModel();
        if (model instanceof ComponentColorModel) {
            readSamples(y - top, FULL / (double) ((1 << model.getComponentSize(0)) - 1), row);
        } else {
            readCoded(y - top, model, row);
        }
        y++;
    }

    private void decode() throws IOException {
        rows = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);      // frees the older ones first
        ImageReadParam part = reader.getDefaultReadParam();
        part.setSourceRegion(new Rectangle(0, y, width, Math.min(most, height - y)));
        rows = reader.read(0, part);
        top = y;
        if (isIncomplete) {
            throw new IOException("pixels are missing");
        }
    }

    /** Reads a row of plain numbers: grey, or red, green and blue, and alpha if there is one more. */
    private void readSamples(int line, double scale, int[] row) {
        samples = rows.getRaster().getPixels(0, line, width, 1, samples.length == 0 ? null : samples);
        int channels = samples.length / width;
        for (int i = 0; i < samples.length; i++) {
            samples[i] = (int) Math.round(scale * samples[i]);
        }
        for (int x = 0; x < width; x++) {
            int i = channels * x;
            int alpha = channels % 2 == 0 ? samples[i + channels - 1] : FULL;
            row[x] = channels < 3 ? PixelRows.pixel(samples[i], samples[i], samples[i], alpha)
                : PixelRows.pixel(samples[i], samples[i + 1], samples[i + 2], alpha);
        }
    }

    /** Reads a row with a palette, or with all channels of a pixel packed into one number. */
    private void readCoded(int line, ColorModel model, int[] row) {
        Object elements = rows.getRaster().getDataElements(0, line, null);
        for (int x = 0; x < width; x++) {
            elements = rows.getRaster().getDataElements(x, line, elements);
            int pixel = model.getRGB(elements);
            row[x] = PixelRows.pixel(pixel >> 16 & 0xff, pixel >> 8 & 0xff, pixel & 0xff, pixel >>> 24);
        }
    }
}
