package raytracing.film;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Map;
import java.util.Set;

/** A file that another one is going to replace. Its rights are handled on Unix only; other systems have their own rules. */
record OlderFile(Path path) {
    private static final String UNIX = "unix";
    private static final int STICKY = 01000;
    private static final int ROOT = 0;

    /**
     * Whether this process may not replace it because it belongs to another user: in a sticky folder, such as /tmp, only its
     * owner, the folder's owner and root may replace a file, even if others may write to it.
     *
     * @param own a file of this process in the same folder, whose owner is the process's user
     */
    boolean isProtected(Path own) throws IOException {
        Path folder = path.resolveSibling("");
        if (!isOnUnix() || (number(folder, "mode") & STICKY) == 0) {
            return false;
        }
        int user = number(own, "uid");
        return user != ROOT && user != number(path, "uid") && user != number(folder, "uid");
    }

    /** Creates the file that will replace it, which no other user may read before it has this one's rights. */
    OutputStream createSuccessor(Path newer) throws IOException {
        if (!isOnUnix()) {
            return Files.newOutputStream(newer, StandardOpenOption.CREATE_NEW);
        }
        Map<String, Object> rights = Files.readAttributes(path, UNIX + ":mode,uid,gid");
        Files.createFile(newer, PosixFilePermissions.asFileAttribute(
            Set.of(PosixFilePermission.OWNER_READ, PosixFilePermission.OWNER_WRITE)));
        OutputStream stream = Files.newOutputStream(newer, StandardOpenOption.WRITE);
        boolean sameGroup = give(newer, "gid", (int) rights.get("gid"));
        int mode = (int) rights.get("mode") & 0777;
        // another group gets no more rights than all others have
        give(newer, "mode", sameGroup ? mode : mode & 0707 | (mode & 0007) << 3);
        give(newer, "uid", (int) rights.get("uid"));
        return stream;
    }

    private boolean isOnUnix() {
        return path.getFileSystem().supportedFileAttributeViews().contains(UNIX);
    }

    private static int number(Path file, String attribute) throws IOException {
        return (int) Files.getAttribute(file, UNIX + ":" + attribute);
    }

    /**
     * Sets an attribute; returns whether that was allowed. Only root may give a file to another user, and only a member may
     * give it to a group; some file systems have no rights at all.
     */
    private static boolean give(Path file, String attribute, int value) {
        try {
            Files.setAttribute(file, UNIX + ":" + attribute, value);
            return true;
        } catch (IOException notAllowed) {
            return false;
        }
    }
}
