package raytracing.watch;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;

/**
 * What tells whether a file is still the same without reading it.
 *
 * @param size in bytes
 * @param time of its last change
 * @param identity of the file under this name: another one if an editor replaced it
 */
record FileStamp(long size, FileTime time, String identity) {
    private static final FileStamp NONE = new FileStamp(-1, FileTime.fromMillis(0), "none");

    /** Of the file that a name leads to now, through links; there may be none. */
    static FileStamp of(Path file) {
        try {
            BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
            return new FileStamp(attributes.size(), attributes.lastModifiedTime(), String.valueOf(attributes.fileKey()));
        } catch (IOException missing) {
            return NONE;
        }
    }
}
