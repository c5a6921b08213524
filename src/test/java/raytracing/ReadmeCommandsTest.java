package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * README's lines for GNU parallel, run as they stand there, give the picture that one program draws. Those for Slurm are
 * tried by {@code gradle slurm}.
 */
class JobArrayTest {
    private static final String WHOLE = "java -jar build/libs/RayTracer.jar scenes/boxes.txt expected.png 900 900 --quiet";

    @TempDir
    private Path folder;

    /** A folder like a checkout. */
    @BeforeEach
    void link() throws Exception {
        assumeTrue(Shell.has("convert", "compare"), "skipped: ImageMagick is not installed");
        Files.createDirectories(folder.resolve("build/libs"));
        Files.createSymbolicLink(folder.resolve("build/libs/RayTracer.jar"), Program.JAR.toAbsolutePath());
        Files.createSymbolicLink(folder.resolve("scenes"), Path.of("scenes").toAbsolutePath());
    }

    private static String commands() throws IOException {
        Pattern block = Pattern.compile("<!-- job array: parallel -->\\R```sh\\R(.*?)```", Pattern.DOTALL);
        return block.matcher(Files.readString(Path.of("README.md"))).results().map((MatchResult match) -> match.group(1))
            .findFirst().orElseThrow();
    }

    @Test
    void gnuParallelDrawsThePartsOfAPicture() throws Exception {
        assumeTrue(Shell.has("parallel"), "skipped: GNU parallel is not installed");
        Shell drawn = Shell.run(folder, "set -e", "PATH=$(dirname \"$JAVA\"):$PATH", commands(), WHOLE);
        assertEquals(0, drawn.status(), drawn.text());
        Shell compared = Shell.run(folder, "compare -metric AE whole.png expected.png null:");
        assertEquals("0", compared.text().strip(), "pixels that differ");
    }
}
