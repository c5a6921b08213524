package raytracing.film;

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

/**
 * A picture file that appears under its name complete or not at all: it is written in the same folder under another name,
 * and renamed when complete. An older file stays until then, and the new one takes over its mode, group and owner.
 */
public final class ImageFile {
    private static final String UNFINISHED = ".unfinished-picture-";

    private final Path name;
    private final Path path;
    private final ImageFormat format;

    /**
     * A file that need not exist yet, in a format that need not be that of the name's ending. A link is followed, so that
     * the file it leads to is created or replaced and not the link.
     */
    public ImageFile(Path name, ImageFormat format) {
        this.name = name;
        List<Path> names = Links.from(name);
        path = names.get(names.size() - 1);
        this.format = format;
    }

    /** The name that was given. */
    public Path name() {
        return name;
    }

    /**
     * The reason, found out before any work is done, why this file could not be written: a sentence without the file's name;
     * none if it can be. Creates an empty file in its folder, and deletes it, as only this shows what the file system allows.
     *
     * @param scene the file from which the picture is drawn, and which it must not replace
     * @throws IOException if the machine fails, for instance with a full disk
     */
    public Optional<String> obstacle(Path scene) throws IOException {
        Optional<String> obstacle = Files.isDirectory(path.resolveSibling("")) ? obstacleInFolder(scene)
            : Optional.of("no such folder");
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
                : Optional.of("belongs to another user, who alone may replace it in this folder; "
                    + "give the picture another name");
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

    /**
     * Whether another name is one of this file, be it there already or not: the same in other words, a link that leads here,
     * or a second name of the same file. The folder of this file must exist.
     */
    public boolean isSameAs(Path other) throws IOException {
        List<Path> names = Links.from(other);
        Path last = names.get(names.size() - 1);
        if (Files.exists(path) && Files.exists(last)) {
            return Files.isSameFile(path, last);
        }
        return Files.isDirectory(last.resolveSibling("")) && real(path).equals(real(last));
    }

    /** Of a file that need not exist, in a folder that does. */
    private static Path real(Path file) throws IOException {
        return file.resolveSibling("").toRealPath().resolve(file.getFileName());
    }

    private Path unfinished() {
        return path.resolveSibling(UNFINISHED + Long.toUnsignedString(System.nanoTime(), Character.MAX_RADIX));
    }

    /**
     * Begins to load what {@link #write} will need, if that takes a while: the classes of Java for jpg and gif.
     *
     * @return the thread that loads them, for callers that must not load Java's picture classes at the same time
     */
    public Optional<Thread> prepare() {
        return format.isLossy() ? Optional.of(ImageIoEncoder.load(format)) : Optional.empty();
    }

    /**
     * Writes a picture band by band; an exception of a band is thrown on. PNG and BMP files are written while the bands are
     * drawn, and created after the first; other formats need the whole picture in memory, 4 bytes a pixel. Gaps are
     * transparent where {@link ImageFormat#showsGaps} is true.
     *
     * @throws IOException if it cannot be written; an older file is then still there
     */
    public void write(Bands bands) throws IOException {
        Encoder encoder = encoder(bands);
        Path unfinished = unfinished();
        unfinished.toFile().deleteOnExit();  // also when a signal ends the program while it writes
        try {
            try (OutputStream stream = created(unfinished)) {
                encoder.writeTo(stream);
            }
            Files.move(unfinished, path, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException rareFileSystem) {
            Files.move(unfinished, path, StandardCopyOption.REPLACE_EXISTING);
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

    private Encoder encoder(Bands bands) {
        if (format.isLossy()) {
            return new ImageIoEncoder(bands, format);
        }
        return format == ImageFormat.PNG ? new PngEncoder(bands) : new BmpEncoder(bands);
    }
}
