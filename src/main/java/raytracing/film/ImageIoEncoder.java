package raytracing.film;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;

/** A file that ImageIO writes, from the whole picture in memory, 4 bytes a pixel. Gaps show what stands instead. */
final class ImageIoEncoder implements Encoder {
    private static final float JPEG_QUALITY = 0.95f;

    private final BufferedImage image;
    private final ImageFormat format;

    /** Draws all bands. */
    ImageIoEncoder(Bands bands, ImageFormat format) {
        this.format = format;
        if (bands.count() == 1) {
            image = bands.band(0).toImage();
            return;
        }
        image = new BufferedImage(bands.width(), bands.height(), BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < bands.count(); i++) {
            bands.band(i).paint(image, i * bands.bandHeight());
        }
    }

    @Override
    public void writeTo(OutputStream file) throws IOException {
        encode(image, format, file);
    }

    /** One at a time: two threads that load the classes of a library in different orders may wait for each other. */
    private static synchronized void encode(BufferedImage image, ImageFormat format, OutputStream file) throws IOException {
        ImageIO.setUseCache(false);          // its cache is a file in another folder, which may be full or not writable
        ImageWriter writer = ImageIO.getImageWritersByFormatName(format.name()).next();
        try (ImageOutputStream output = ImageIO.createImageOutputStream(file)) {
            ImageWriteParam parameters = writer.getDefaultWriteParam();
            if (format == ImageFormat.JPEG) {
                parameters.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
                parameters.setCompressionQuality(JPEG_QUALITY);
            }
            writer.setOutput(output);
            writer.write(null, new IIOImage(image, null, null), parameters);
        } finally {
            writer.dispose();
        }
    }

    /**
     * Starts a thread that loads the classes that {@link #writeTo} will need: in a cold virtual machine that takes some 90 ms,
     * most of the time for writing a small picture. Writes nothing. An error here occurs again when the picture is written,
     * and is reported then.
     */
    static Thread load(ImageFormat format) {
        Thread thread = new Thread("encoder") {
            @Override
            public void run() {
                try {
                    new ImageIoEncoder(new Film(1, 1), format).writeTo(OutputStream.nullOutputStream());
                } catch (IOException | RuntimeException | Error reportedByWrite) {
                    // only the time saved is lost
                }
            }
        };
        thread.setDaemon(true);
        thread.start();
        return thread;
    }
}
