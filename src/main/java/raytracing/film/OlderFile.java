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

/** A file that another one is going to replace. Its rights are a matter of Unix; other systems have rules of their own. */
record OlderFile(Path path) {
    private static final String UNIX = "unix";
    private static final int STICKY = 01000;
    private static final int RIGHTS = 0777;
    private static final int RIGHTS_BUT_THE_GROUPS = 0707;
    private static final int RIGHTS_OF_ALL_OTHERS = 0007;
    private static final int FROM_ALL_OTHERS_TO_THE_GROUP = 3;
    private static final int ROOT = 0;

    /**
     * Whether it stays because it belongs to another user: in a sticky folder, as /tmp is, only its owner, the folder's and
     * root may replace a file, also if others may write it.
     *
     * @param own a file of this process in the same folder, which tells whose process it is
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
        int mode = (int) rights.get("mode") & RIGHTS;
        // another group gets no more than all others have
        give(newer, "mode", sameGroup ? mode
            : mode & RIGHTS_BUT_THE_GROUPS | (mode & RIGHTS_OF_ALL_OTHERS) << FROM_ALL_OTHERS_TO_THE_GROUP);
        give(newer, "uid", (int) rights.get("uid"));
        return stream;
    }

    private boolean isOnUnix() {
        return path.getFileSystem().supportedFileAttributeViews().contains(UNIX);
    }

    private static int number(Path file, String attribute) throws IOException {
        return (int) Files.getAttribute(file, UNIX + ":" + attribute);
    }

    /** Only root may give a file to another user, and only a member to a group; some file systems have no rights at all. */
    private static boolean give(Path file, String attribute, int value) {
        try {
            Files.setAttribute(file, UNIX + ":" + attribute, value);
            return true;
        } catch (IOException notAllowed) {
            return false;
        }
    }
}
