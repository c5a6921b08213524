package raytracing.film;

import java.io.BufferedInputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.channels.Channels;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import javax.imageio.stream.FileImageInputStream;
import javax.imageio.stream.ImageInputStream;

/**
 * A picture in a file, in one of the formats of {@link ImageFormat} whatever the file's name, as 8 bits each of red, green
 * and blue: grey is all three, a palette is looked up, 16 bits are rounded to 8, and a pixel with alpha counts as it looks
 * in front of black. The open file is read even if another one takes over its name, where the system allows that.
 */
public final class StoredPicture implements Closeable {
    /**
     * A pixel that is kept takes 4 bytes and one that is decoded up to 8; a picture may be kept and two others decoded at the
     * same time. So all take less than a third of the memory.
     */
    private static final long BYTES_OF_MEMORY_FOR_A_PIXEL = 64;

    private static final int BUFFER = 1 << 16;
    private static final String UNREADABLE =
        "cannot be read to its end, as it is damaged, cut off or of a rare kind; save it again as png";

    private final Path path;
    private final RandomAccessFile file;

    /** The same file for ImageIO; always the same stream, as a forgotten one would close the file when it is collected. */
    private final ImageInputStream stream;
    private final int width;
    private final int height;

    /** All pixels row by row, if they are kept. */
    private Optional<int[]> kept = Optional.empty();

    private StoredPicture(Path path, RandomAccessFile file) throws IOException {
        this.path = path;
        this.file = file;
        stream = new FileImageInputStream(file) {
            @Override
            public void flushBefore(long position) {
                // a reader wants no way back behind the header, but the next reader begins there
            }
        };
        Optional<PngRows> png = pngRows();
        Optional<ImageIoRows> other = png.isPresent() ? Optional.empty() : otherRows();
        if (png.isEmpty() && other.isEmpty()) {
            throw refusal("is no picture that can be read, expected a png, jpg, bmp or gif");
        }
        width = png.isPresent() ? png.get().width() : other.get().width();
        height = png.isPresent() ? png.get().height() : other.get().height();
    }

    /**
     * Opens a file and finds out the size of its picture.
     *
     * @throws FileSystemException if it is missing, no picture or damaged; its reason is a sentence
     * @throws IOException if the machine fails
     */
    public static StoredPicture open(Path path) throws IOException {
        Optional<String> obstacle = obstacle(path);
        if (obstacle.isPresent()) {
            throw new FileSystemException(path.toString(), null, obstacle.get());
        }
        RandomAccessFile file = new RandomAccessFile(path.toFile(), "r");
        try {
            return new StoredPicture(path, file);
        } catch (FileSystemException refused) {
            file.close();
            throw refused;
        } catch (IOException | RuntimeException damaged) {
            file.close();
            throw new FileSystemException(path.toString(), null, UNREADABLE);
        }
    }

    private static Optional<String> obstacle(Path path) throws IOException {
        if (!Files.exists(path)) {
            return Optional.of("no such file, expected a picture");
        }
        if (!Files.isRegularFile(path)) {
            return Optional.of("is " + (Files.isDirectory(path) ? "a folder" : "no file") + ", expected a picture");
        }
        if (!Files.isReadable(path)) {
            return Optional.of("may not be read");
        }
        return Files.size(path) > 0 ? Optional.empty() : Optional.of("is empty, expected a picture");
    }

    private FileSystemException refusal(String reason) {
        return new FileSystemException(path.toString(), null, reason);
    }

    private Optional<PngRows> pngRows() throws IOException {
        file.seek(0);
        return PngRows.of(new BufferedInputStream(Channels.newInputStream(file.getChannel()), BUFFER));
    }

    private Optional<ImageIoRows> otherRows() throws IOException {
        stream.seek(0);
        return ImageIoRows.of(stream, mostPixels());
    }

    /** How many pixels may be kept, and how many decoded at once. */
    private static long mostPixels() {
        return Math.min(Runtime.getRuntime().maxMemory() / BYTES_OF_MEMORY_FOR_A_PIXEL, Film.MOST_PIXELS);
    }

    /** In pixels, at least 1. */
    public int width() {
        return width;
    }

    /** In pixels, at least 1. */
    public int height() {
        return height;
    }

    /**
     * Reads all pixels, so that a damaged file is noticed now. Unless there are too many, they are kept in memory and the
     * file is closed: what later becomes of it does not matter.
     *
     * @throws FileSystemException if the file is damaged; its reason is a sentence
     */
    public void load() throws IOException {
        PixelRows rows = rows();
        int[] row = new int[width];
        boolean isKept = (long) width * height <= mostPixels();
        int[] pixels = new int[isKept ? width * height : 0];
        for (int y = 0; y < height; y++) {
            rows.next(row);
            if (isKept) {
                System.arraycopy(row, 0, pixels, y * width, width);
            }
        }
        if (isKept) {
            kept = Optional.of(pixels);
            close();
        }
    }

    /** The rows of all pixels, from the top. Only the rows that this returned last can be read. */
    PixelRows rows() throws IOException {
        if (kept.isPresent()) {
            int[] pixels = kept.get();
            int[] next = new int[1];
            return row -> System.arraycopy(pixels, width * next[0]++, row, 0, width);
        }
        Optional<PngRows> png = pngRows();
        PixelRows rows = png.isPresent() ? png.get() : otherRows().orElseThrow(() -> refusal(UNREADABLE));
        return row -> {
            try {
                rows.next(row);
            } catch (IOException | RuntimeException damaged) {
                throw refusal(UNREADABLE);
            }
        };
    }

    /** What was kept in memory can still be read. */
    @Override
    public void close() throws IOException {
        file.close();       // and with it what the stream would close
    }
}
