package raytracing.film;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Follows symbolic links one by one, as the last one may lead to a file that does not exist yet. */
public final class Links {
    /** As many links in a row as Linux follows. */
    private static final int MOST = 40;

    private Links() {
    }

    /**
     * The name itself, which may be that of a file, a link or nothing; if it is a link, where that leads, and so on. Ends
     * early at a link that cannot be read.
     */
    public static List<Path> from(Path name) {
        List<Path> names = new ArrayList<>();
        Path last = name;
        names.add(last);
        try {
            while (names.size() <= MOST && Files.isSymbolicLink(last)) {
                last = last.resolveSibling(Files.readSymbolicLink(last));
                names.add(last);
            }
        } catch (IOException unreadable) {
            // it leads no further
        }
        return names;
    }
}
