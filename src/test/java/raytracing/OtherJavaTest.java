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
import raytracing.program.Command;
import raytracing.program.CommandLine;

/** The same bytes on every Java from 17 on: compares with those that are installed beside the one that runs the tests. */
class OtherJavaTest {
    private static final String SIZE = "125";

    @Test
    void everyInstalledJavaDrawsTheSameFiles(@TempDir Path folder) throws Exception {
        List<Path> others = otherJavas();
        Skipped.unless(!others.isEmpty(), "no other Java from 17 on is installed beside " + Program.JAVA_HOME.getFileName());
        Path expected = drawn(Program.JAVA_HOME, folder);
        for (Path other : others) {
            Path found = drawn(other, folder);
            for (String picture : Folders.names(expected)) {
                assertEquals(-1, Files.mismatch(expected.resolve(picture), found.resolve(picture)),
                    picture + " on " + other.getFileName());
            }
        }
    }

    /** The folder of all pictures, which one virtual machine draws as the program does. */
    private static Path drawn(Path java, Path folder) throws Exception {
        Path pictures = Files.createDirectory(folder.resolve(java.getFileName()));
        Path tests = Path.of(OtherJavaTest.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        Shell run = Shell.run(Path.of("").toAbsolutePath(), "'" + java.resolve("bin/java") + "' -cp \"$JAR\":'" + tests + "' "
            + OtherJavaTest.class.getName() + " '" + pictures + "'");
        assertEquals(0, run.status(), run.text());
        assertEquals(SceneFiles.all().count(), Folders.names(pictures).size());
        return pictures;
    }

    /** Draws every scene into a folder, the only argument. */
    public static void main(String[] arguments) throws Exception {
        for (Path scene : SceneFiles.all().toList()) {
            Command.Draw command = (Command.Draw) CommandLine.parse(scene.toString(),
                Path.of(arguments[0], scene.getFileName() + ".png").toString(), SIZE, SIZE, "--quiet");
            RayTracer.drawOnce(command);
        }
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
