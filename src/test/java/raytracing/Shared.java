package raytracing;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;

/** Files that may not be published here: they lie in a folder {@code shared} beside the checkout, or are missing. */
public final class Shared {
    /** The course's scenes, with pictures of them. */
    public static final Path SCENES = Path.of("..", "shared", "scenes");

    /** Tables of exact answers. */
    public static final Path NUMERICS = Path.of("..", "shared", "numerics");

    private Shared() {
    }

    /** Skips the calling test if the folder is missing; one line names all missing folders. */
    public static void require(Path folder) {
        Skipped.unless(Files.isDirectory(folder), List.of(SCENES, NUMERICS).stream().filter(each -> !Files.isDirectory(each))
            .map(Path::toString).collect(Collectors.joining(" and ", "tests that compare with ",
                ", for that does not lie beside the checkout")));
    }
}
