package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.jar.JarFile;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.ZipEntry;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * README's commands, run as they stand there in a folder like a checkout. Its Slurm lines are tried by {@code gradle
 * slurm}, its test command by the script in {@code .ci}.
 */
class ReadmeCommandsTest {
    private static final Pattern DRAWING =
        Pattern.compile("^java -jar build/libs/RayTracer\\.jar scenes/.*$", Pattern.MULTILINE);

    @TempDir
    private Path folder;

    @BeforeEach
    void linkSources() throws IOException {
        Files.createSymbolicLink(folder.resolve("src"), Path.of("src").toAbsolutePath());
        Files.createSymbolicLink(folder.resolve("scenes"), Path.of("scenes").toAbsolutePath());
    }

    /** The folder is deleted then, and what links lead to must not be. */
    @AfterEach
    void unlink() throws IOException {
        for (String link : List.of("src", "scenes", "build/libs/RayTracer.jar")) {
            if (Files.isSymbolicLink(folder.resolve(link))) {
                Files.delete(folder.resolve(link));
            }
        }
    }

    private void linkJar() throws IOException {
        Files.createDirectories(folder.resolve("build/libs"));
        Files.createSymbolicLink(folder.resolve("build/libs/RayTracer.jar"), Program.JAR.toAbsolutePath());
    }

    private static String readme() throws IOException {
        return Files.readString(Path.of("README.md"));
    }

    /** The lines of the block that follows a mark. */
    private static String block(String mark) throws IOException {
        Matcher block = Pattern.compile("<!-- " + mark + " -->\\R```sh\\R(.*?)```", Pattern.DOTALL).matcher(readme());
        assertTrue(block.find(), mark);
        return block.group(1);
    }

    private void run(String... commands) throws Exception {
        Shell run = Shell.run(folder, "set -e", "PATH=$(dirname \"$JAVA\"):$PATH", String.join("\n", commands));
        assertEquals(0, run.status(), run.text());
    }

    private static Set<String> classes(Path jar) throws IOException {
        try (JarFile file = new JarFile(jar.toFile())) {
            return new TreeSet<>(file.stream().map(ZipEntry::getName).filter(name -> name.endsWith(".class")).toList());
        }
    }

    @Test
    void aJdkAloneBuildsTheSameProgram() throws Exception {
        Skipped.unless(Files.exists(Program.JAVA_HOME.resolve("bin/javac")), "this Java has no compiler");
        String lines = block("plain JDK");
        run(lines);
        assertEquals(classes(Program.JAR), classes(folder.resolve("build/libs/RayTracer.jar")));
        PictureDifference difference = new PictureDifference(ImageIO.read(folder.resolve("picture.png").toFile()),
            ImageIO.read(new File("scenes/fisheye_scene.png")));
        assertEquals(0, difference.shareOffByMoreThan(0), difference::toString);
    }

    @Test
    void theDrawingCommandsDraw() throws Exception {
        linkJar();
        List<String> commands = DRAWING.matcher(readme()).results().map(match -> match.group()).toList();
        assertTrue(commands.size() >= 2, commands::toString);
        run(commands.toArray(String[]::new));
    }

    @Test
    void theCommandsForManySmallPicturesDrawThem() throws Exception {
        linkJar();
        run(block("many small pictures"), "\"$JAVA\" -jar \"$JAR\" scenes/ball.txt expected.png --quiet");
        assertEquals(-1, Files.mismatch(folder.resolve("expected.png"), folder.resolve("ball.png")));
        assertTrue(Files.exists(folder.resolve("RayTracer.jsa")));
    }

    @Test
    void theComparisonPrintsWhatTheReadmeSays() throws Exception {
        linkJar();
        Matcher printed = Pattern.compile("<!-- printed by --compare -->\\R    (.*)").matcher(readme());
        assertTrue(printed.find());
        String command = DRAWING.matcher(readme()).results().map(match -> match.group())
            .filter(line -> line.contains("--compare ")).findFirst().orElseThrow();
        Shell compared = Shell.run(folder, "PATH=$(dirname \"$JAVA\"):$PATH", command + " 2> messages");
        assertEquals(printed.group(1) + "\n", compared.text());
        assertEquals(0, compared.status());
    }

    @Test
    void gnuParallelDrawsThePartsOfAPicture() throws Exception {
        Skipped.unless(Shell.has("convert", "compare", "parallel"), "ImageMagick or GNU parallel is not installed");
        linkJar();
        run(block("job array: parallel"), "\"$JAVA\" -jar \"$JAR\" scenes/boxes.txt expected.png 900 900 --quiet");
        Shell compared = Shell.run(folder, "compare -metric AE whole.png expected.png null:");
        assertEquals("0", compared.text().strip(), "pixels that differ");
    }
}
