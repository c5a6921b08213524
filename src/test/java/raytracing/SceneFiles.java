package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/** The scenes folder, for tests and measurements. */
public final class SceneFiles {
    private static final Path FOLDER = Path.of("scenes");

    private SceneFiles() {
    }

    /** All scenes, in alphabetical order. */
    public static Stream<Path> all() throws IOException {
        return endingIn(".txt");
    }

    /** All files whose names end so, in alphabetical order. */
    static Stream<Path> endingIn(String ending) throws IOException {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.filter(file -> file.toString().endsWith(ending)).sorted().toList().stream();
        }
    }
}
