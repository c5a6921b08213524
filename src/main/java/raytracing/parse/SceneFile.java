package raytracing.parse;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;

/** Reads the bytes of a scene file. */
final class SceneFile {
    /** Bytes of a file that are read at once. */
    private static final int PIECE = 1 << 16;

    /** The longest array that every virtual machine has. */
    private static final int MOST_BYTES = Integer.MAX_VALUE - 8;

    private SceneFile() {
    }

    static byte[] bytes(Path file) throws RayTracerException, IOException {
        try {
            if (Files.isDirectory(file)) {
                throw new RayTracerException(file + ": is a folder, expected a scene file");
            }
            long size = Files.size(file);
            if (size > MOST_BYTES) {
                throw tooLarge(file);
            }
            return size > PIECE ? bytes(file, (int) size) : bytesOfUnknownNumber(file);
        } catch (NoSuchFileException missing) {
            throw new RayTracerException(file + ": no such file, expected a scene file");
        }
    }

    /**
     * Large files in pieces: the library, asked for all of a file, makes a second copy of it outside the heap, which
     * took half as long again (53 instead of 36 ms for 33 MB).
     */
    private static byte[] bytes(Path file, int size) throws IOException {
        byte[] bytes = new byte[size];
        int length = 0;
        try (InputStream stream = Files.newInputStream(file)) {
            int read = stream.read(bytes, 0, PIECE);
            while (read > 0) {
                length += read;
                read = stream.read(bytes, length, Math.min(PIECE, bytes.length - length));
            }
        }
        return length == bytes.length ? bytes : Arrays.copyOf(bytes, length);
    }

    /**
     * Small files, and what has no size: a pipe, or a device that may never end. Where memory does not hold it, that is
     * the machine's fault only if it would have been a scene file.
     */
    private static byte[] bytesOfUnknownNumber(Path file) throws RayTracerException, IOException {
        try (InputStream stream = Files.newInputStream(file)) {
            byte[] bytes;
            try {
                bytes = stream.readNBytes(MOST_BYTES);
            } catch (OutOfMemoryError tooMuch) {
                if (hasMoreThanAllowed(stream)) {
                    throw tooLarge(file);
                }
                throw tooMuch;
            }
            if (bytes.length == MOST_BYTES && stream.read() >= 0) {
                throw tooLarge(file);
            }
            return bytes;
        }
    }

    private static boolean hasMoreThanAllowed(InputStream stream) throws IOException {
        byte[] piece = new byte[PIECE];
        long length = 0;
        int read = stream.read(piece);
        while (read > 0 && length <= MOST_BYTES) {
            length += read;
            read = stream.read(piece);
        }
        return length > MOST_BYTES;
    }

    private static RayTracerException tooLarge(Path file) {
        return new RayTracerException(file + ": is too large, a scene file may have at most 2 GB (" + MOST_BYTES + " bytes)");
    }
}
