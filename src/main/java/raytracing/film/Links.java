package raytracing.film;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Follows symbolic links one by one, because nothing need exist where the last one leads to. */
public final class Links {
    /** How many in a row: as many as Linux follows. */
    private static final int MOST = 40;

    private Links() {
    }

    /**
     * A name, and all that it leads to.
     *
     * @param name of a file or link, or of nothing
     * @return the name itself, and if it is a link, where that leads, and so on; ends early at a link that cannot be read
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
