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

    /**
     * Two cubes as modelling programs write them, the second with indices from the end: quads, a pentagon with a corner twice,
     * numbers of normals and textures, line ends of Windows. They are drawn as boxes are.
     */
    @Test
    void theCommandForAMeshMakesTrianglesOfAnObjFile() throws Exception {
        Skipped.unless(Shell.has("awk"), "awk is not installed");
        String corners = corners(-1.5, -0.75, 1.25) + corners(0.5, -0.5, 0);
        Files.writeString(folder.resolve("model.obj"), ("# two cubes\nmtllib a.mtl\no cubes\n" + corners + "vn 0 0 1\nvt 0 0\n"
            + "usemtl red\nf 1 2 4 3\nf 5/1/1 6/1/1 8/1/1 7/1/1\nf 1/1 2/1 6/1 5/1\nf 3//1 4//1 8//1 7//1\n"
            + "f 1 3 7 5 5\nf 2 4 8 6\n"
            + "f -8 -7 -5 -6\nf -4/-1 -3/-1 -1/-1 -2/-1\nf -8 -7 -3 -4\nf -6//1 -5//1 -1//1 -2//1\n"
            + "f -8 -6 -2 -4\nf -7 -5 -1 -3 \n").replace("\n", "\r\n"));
        run(block("mesh"));
        String head = "cam 1 2 -6  0 0 0  0 1 0  1 0.8\nset 0.2 0.3 0.4  1 0\nmtl 0.9 0.5 0.2  0 0 0  0 0 0  1 0\n"
            + "lgt -4 5 -6  1 1 1  1 1 0\nlgt 6 1 -3  0.2 0.3 0.5  1 1 0\npln 0 1 0 -1 1\n";
        String mesh = Files.readString(folder.resolve("model.txt"));
        assertEquals(24, mesh.lines().count());
        Files.writeString(folder.resolve("mesh.txt"), head + mesh);
        Files.writeString(folder.resolve("boxes.txt"), head + "box -1 -0.25 -1.75 1 1\nbox 1 0 -0.5 1 1\n");
        run("for scene in mesh boxes; do \"$JAVA\" -jar \"$JAR\" $scene.txt $scene.png 200 200 --quiet; done");
        PictureDifference difference = new PictureDifference(ImageIO.read(folder.resolve("mesh.png").toFile()),
            ImageIO.read(folder.resolve("boxes.png").toFile()));
        assertEquals(0, difference.shareOffByMoreThan(1), difference::toString);
    }

    /** The eight corners of a cube of edge 1. */
    private static String corners(double x, double y, double z) {
        StringBuilder lines = new StringBuilder();
        for (int i = 0; i < 8; i++) {
            lines.append("v ").append(x + (i & 1)).append(' ').append(y + (i >> 1 & 1)).append(' ').append(z + (i >> 2))
                .append('\n');
        }
        return lines.toString();
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
