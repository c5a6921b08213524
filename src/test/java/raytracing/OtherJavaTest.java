package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Properties;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The same bytes on every Java from 17 on: compares with those that are installed beside the one that runs the tests. */
class OtherJavaTest {

    @Test
    void everyInstalledJavaDrawsTheSameFiles(@TempDir Path folder) throws Exception {
        List<Path> others = otherJavas();
        Skipped.unless(!others.isEmpty(), "no other Java from 17 on is installed beside " + Program.JAVA_HOME.getFileName());
        for (Path scene : CommittedScenesTest.scenes().toList()) {
            Path expected = drawn(Program.JAVA_HOME, scene, folder);
            for (Path other : others) {
                assertEquals(-1, Files.mismatch(expected, drawn(other, scene, folder)),
                    scene.getFileName() + " on " + other.getFileName());
            }
        }
    }

    private static Path drawn(Path java, Path scene, Path folder) throws Exception {
        Path picture = folder.resolve(java.getFileName() + "-" + scene.getFileName() + ".png");
        Program program = Program.run(java, List.of(), folder, scene.toAbsolutePath().toString(), picture.toString(),
            "125", "125");
        assertEquals(0, program.status(), program.errors());
        return picture;
    }

    private static List<Path> otherJavas() throws IOException {
        try (Stream<Path> siblings = Files.list(Program.JAVA_HOME.toRealPath().getParent())) {
            return siblings.filter(path -> !Files.isSymbolicLink(path))
                .filter(path -> Files.isExecutable(path.resolve("bin/java")))
                .filter(path -> feature(path) >= 17 && feature(path) != Runtime.version().feature())
                .toList();
        }
    }

    /** The feature release, 17 of 17.0.15, that an installation says it is; 0 if it says nothing. */
    private static int feature(Path java) {
        Properties release = new Properties();
        try (Stream<String> lines = Files.lines(java.resolve("release"))) {
            release.load(new java.io.StringReader(String.join("\n", lines.toList())));
        } catch (IOException none) {
            return 0;
        }
        String version = release.getProperty("JAVA_VERSION", "0").replace("\"", "");
        return Integer.parseInt(version.split("[.+-]")[0]);
    }
}
