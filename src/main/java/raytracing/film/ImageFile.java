package raytracing.film;

import java.awt.image.BufferedImage;
import java.awt.image.RenderedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;

/**
 * A picture file that appears under its name whole or not at all: it is written beside it under another name, and
 * renamed when complete. Whatever stood there before stays until then.
 */
public final class ImageFile {
    private static final float JPEG_QUALITY = 0.95f;
    private static final String UNFINISHED = ".unfinished-picture-";

    private final Path path;
    private final ImageFormat format;

    /**
     * A file that may not exist yet.
     *
     * @param path where; a link is followed, so that what it points to is replaced and not the link
     * @param format what to write, whatever the name says
     */
    public ImageFile(Path path, ImageFormat format) {
        this.path = followed(path);
        this.format = format;
    }

    private static Path followed(Path path) {
        try {
            return path.toRealPath();
        } catch (IOException notThereYet) {
            return path.toAbsolutePath();
        }
    }

    /**
     * Finds out, before any work is done, why this file could not be written.
     *
     * @return what is in the way, a sentence without the file's name; none if nothing is
     */
    public Optional<String> obstacle() {
        Path folder = folder();
        if (!Files.isDirectory(folder)) {
            return Optional.of("no such folder");
        }
        if (!Files.isWritable(folder)) {
            return Optional.of("may not write in this folder");
        }
        if (Files.isDirectory(path)) {
            return Optional.of("is a folder, expected a file name");
        }
        if (Files.exists(path) && !(Files.isRegularFile(path) && Files.isWritable(path))) {
            return Optional.of("exists and may not be replaced");
        }
        return Optional.empty();
    }

    private Path folder() {
        Path parent = path.getParent();
        return parent == null ? path : parent;
    }

    /**
     * Begins to load what {@link #write} will need, beside whatever is done until then: in a cold virtual machine that
     * takes some 90 ms, most of what writing a small picture takes. Writes nothing. What fails here fails again when the
     * picture is written, and is reported then.
     *
     * @return the thread, for those who must not meet Java's picture classes at the same time
     */
    public Thread prepare() {
        Thread thread = new Thread("encoder") {
            @Override
            public void run() {
                try {
                    encode(new Film(1, 1).toImage(), OutputStream.nullOutputStream());
                } catch (IOException | RuntimeException | Error reportedByWrite) {
                    // nothing is lost but the head start
                }
            }
        };
        thread.setDaemon(true);
        thread.start();
        return thread;
    }

    /**
     * Writes a picture that is there.
     *
     * @param film the picture
     * @throws IOException if it cannot be written; then whatever stood there before still does
     */
    public void write(Film film) throws IOException {
        write(Bands.of(film));
    }

    /**
     * Writes a picture band by band. PNG and BMP files are written as the bands come, the first of which is awaited before
     * there is a file; other formats need the whole picture in memory, 4 bytes a pixel. Gaps are transparent where
     * {@link ImageFormat#showsGaps} says so.
     *
     * @param bands of the picture; what they throw is thrown
     * @throws IOException if it cannot be written; then whatever stood there before still does
     */
    public void write(Bands bands) throws IOException {
        RenderedImage image = image(bands);
        Path unfinished = folder().resolve(UNFINISHED + Long.toUnsignedString(System.nanoTime(), Character.MAX_RADIX));
        unfinished.toFile().deleteOnExit();  // also when a signal ends the program while it writes
        try {
            try (OutputStream stream = Files.newOutputStream(unfinished, StandardOpenOption.CREATE_NEW)) {
                encode(image, stream);
            }
            moveIntoPlace(unfinished);
        } finally {
            Files.deleteIfExists(unfinished);
        }
    }

    private RenderedImage image(Bands bands) {
        if (bands.count() == 1) {
            Film film = bands.band(0);
            return film.hasGaps() && format.showsGaps(bands) ? film.toImageWithGaps() : film.toImage();
        }
        if (format.reading() != ImageFormat.Reading.WHOLE) {
            return new BandedImage(bands, format.reading() == ImageFormat.Reading.DOWN ? 0 : bands.count() - 1);
        }
        BufferedImage whole = new BufferedImage(bands.width(), bands.height(), BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < bands.count(); i++) {
            bands.band(i).paint(whole, i * bands.bandHeight());
        }
        return whole;
    }

    /** One at a time: threads that first meet the classes of a library in different orders may wait for each other. */
    private synchronized void encode(RenderedImage image, OutputStream stream) throws IOException {
        ImageIO.setUseCache(false);          // its cache is a file in another folder, which may be full or forbidden
        ImageWriter writer = ImageIO.getImageWritersByFormatName(format.imageIoName()).next();
        try (ImageOutputStream output = ImageIO.createImageOutputStream(stream)) {
            writer.setOutput(output);
            writer.write(null, new IIOImage(image, null, null), parameters(writer));
        } finally {
            writer.dispose();
        }
    }

    private ImageWriteParam parameters(ImageWriter writer) {
        ImageWriteParam parameters = writer.getDefaultWriteParam();
        if (format == ImageFormat.JPEG) {
            parameters.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
            parameters.setCompressionQuality(JPEG_QUALITY);
        }
        return parameters;
    }

    private void moveIntoPlace(Path unfinished) throws IOException {
        try {
            Files.move(unfinished, path, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException rareFileSystem) {
            Files.move(unfinished, path, StandardCopyOption.REPLACE_EXISTING);
        }
    }
}
