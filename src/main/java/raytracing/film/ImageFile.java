package raytracing.film;

import java.awt.image.BufferedImage;
import java.awt.image.RenderedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.List;
import java.util.Optional;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;

/**
 * A picture file that appears under its name whole or not at all: it is written beside it under another name, and
 * renamed when complete. Whatever stood there before stays until then, and its mode, group and owner go over.
 */
public final class ImageFile {
    private static final float JPEG_QUALITY = 0.95f;
    private static final String UNFINISHED = ".unfinished-picture-";

    private final Path name;
    private final Path path;
    private final ImageFormat format;

    /**
     * A file that may not exist yet.
     *
     * @param name where; a link is followed, so that what it leads to is created or replaced and not the link
     * @param format what to write, whatever the name says
     */
    public ImageFile(Path name, ImageFormat format) {
        this.name = name;
        List<Path> names = Links.from(name);
        path = names.get(names.size() - 1);
        this.format = format;
    }

    /**
     * Finds out, before any work is done, why this file could not be written. Creates an empty file beside it, and deletes
     * it: only so is it known what the file system allows.
     *
     * @param scene the file that the picture is drawn from, and is not to replace
     * @return what is in the way, a sentence without the file's name; none if nothing is
     * @throws IOException if the machine fails, as a full disk does
     */
    public Optional<String> obstacle(Path scene) throws IOException {
        Optional<String> obstacle = Files.isDirectory(folder()) ? obstacleInFolder(scene) : Optional.of("no such folder");
        return obstacle.isEmpty() || path.equals(name) ? obstacle
            : Optional.of("is a link to " + path + ": " + obstacle.get());
    }

    private Optional<String> obstacleInFolder(Path scene) throws IOException {
        boolean isNew = false;
        try {
            Optional<String> obstacle = obstacle(Files.readAttributes(name, BasicFileAttributes.class), scene);
            if (obstacle.isPresent()) {
                return obstacle;
            }
        } catch (NoSuchFileException none) {
            isNew = true;
        } catch (FileSystemException refused) {      // a name that is too long, a link that may not be followed
            return Optional.of(refused.getReason() == null ? "access denied" : refused.getReason());
        }
        Path own = unfinished();
        try {
            Files.createFile(own);
        } catch (AccessDeniedException forbidden) {
            return Optional.of("may not write in this folder");
        }
        try {
            return isNew || !new OlderFile(path).isProtected(own) ? Optional.empty()
                : Optional.of("belongs to another user, who alone may replace it in this folder; give the picture another name");
        } finally {
            Files.delete(own);
        }
    }

    private Optional<String> obstacle(BasicFileAttributes older, Path scene) throws IOException {
        if (older.isDirectory()) {
            return Optional.of("is a folder, expected a file name");
        }
        if (Files.exists(scene) && Files.isSameFile(scene, name)) {
            return Optional.of("is the scene itself, which the picture would replace; give the picture another name");
        }
        return older.isRegularFile() && Files.isWritable(name) ? Optional.empty()
            : Optional.of("exists and may not be replaced");
    }

    private Path folder() {
        return path.resolveSibling("");
    }

    private Path unfinished() {
        return path.resolveSibling(UNFINISHED + Long.toUnsignedString(System.nanoTime(), Character.MAX_RADIX));
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
        Path unfinished = unfinished();
        unfinished.toFile().deleteOnExit();  // also when a signal ends the program while it writes
        try {
            try (OutputStream stream = created(unfinished)) {
                encode(image, stream);
            }
            moveIntoPlace(unfinished);
        } finally {
            Files.deleteIfExists(unfinished);
        }
    }

    private OutputStream created(Path unfinished) throws IOException {
        try {
            return Files.exists(path) ? new OlderFile(path).createSuccessor(unfinished)
                : Files.newOutputStream(unfinished, StandardOpenOption.CREATE_NEW);
        } catch (NoSuchFileException gone) {
            throw new FileSystemException(path.toString(), null, "its folder is no longer there");
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
