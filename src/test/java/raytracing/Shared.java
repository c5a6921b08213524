package raytracing;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;

/** What is not ours to keep here: it lies in a folder {@code shared} beside the checkout, or is missing. */
public final class Shared {
    /** The course's scenes, with pictures of them. */
    public static final Path SCENES = Path.of("..", "shared", "scenes");

    /** Tables of exact answers. */
    public static final Path NUMERICS = Path.of("..", "shared", "numerics");

    private Shared() {
    }

    /** Skips the test that asks where one of the folders is missing; one line says all that are. */
    public static void require(Path folder) {
        Skipped.unless(Files.isDirectory(folder), List.of(SCENES, NUMERICS).stream().filter(each -> !Files.isDirectory(each))
            .map(Path::toString).collect(Collectors.joining(" and ", "tests that compare with ",
                ", for that does not lie beside the checkout")));
    }
}
