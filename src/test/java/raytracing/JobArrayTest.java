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

/** The job arrays of README, run as they stand there, give the picture that one program draws. */
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

    private static String commands(String name) throws IOException {
        Pattern block = Pattern.compile("<!-- job array: " + name + " -->\\R```sh\\R(.*?)```", Pattern.DOTALL);
        return block.matcher(Files.readString(Path.of("README.md"))).results().map((MatchResult match) -> match.group(1))
            .findFirst().orElseThrow();
    }

    private void assertWholeIsTheExpectedPicture(String... commands) throws Exception {
        Shell drawn = Shell.run(folder, "set -e", "PATH=$(dirname \"$JAVA\"):$PATH",
            String.join("\n", commands), WHOLE);
        assertEquals(0, drawn.status(), drawn.text());
        Shell compared = Shell.run(folder, "compare -metric AE whole.png expected.png null:");
        assertEquals("0", compared.text().strip(), "pixels that differ");
    }

    @Test
    void gnuParallelDrawsThePartsOfAPicture() throws Exception {
        assumeTrue(Shell.has("parallel"), "skipped: GNU parallel is not installed");
        assertWholeIsTheExpectedPicture(commands("parallel"));
    }

    /** What Slurm does with these two options: the command, for each number of the array, in a shell of its own. */
    private static final String SBATCH = """
        sbatch() {
          local array=${1#--array=} command=${2#--wrap=}
          for i in $(seq ${array%-*} ${array#*-}); do
            SLURM_ARRAY_TASK_ID=$i sh -c "$command"
          done
        }
        """;

    @Test
    void slurmDrawsThePartsOfAPicture() throws Exception {
        assertWholeIsTheExpectedPicture(SBATCH, commands("slurm"), "convert part-0.png part-1.png part-2.png -append whole.png");
    }
}
