package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What a user of the jar sees: files, exit statuses, messages. */
class ProgramTest {
    private static final String SCENE = """
        cam 0 2 -6   0 0 0   0 1 0   1 1
        set 0.2 0.3 0.4   4 4
        mtl 0.8 0.4 0.2   0.5 0.5 0.5   0.2 0.2 0.2   20 0
        pln 0 1 0  -1  1
        sph 0 0 0   1  1
        lgt 3 5 -3   1 1 1   1 0.9 2
        """;

    private static final String DRAWING = "out\\.png: drawing 40 x 30 pixels of scene\\.txt with \\d+ threads?\\R";

    @TempDir
    private Path folder;

    @BeforeEach
    void writeScene() throws Exception {
        Files.writeString(folder.resolve("scene.txt"), SCENE);
    }

    private Program run(String... arguments) throws Exception {
        return Program.run(folder, arguments);
    }

    /** A ball alone in the sky: its ambient light is the background. */
    @Test
    void theLineNamesTheAmbientLightOfASceneThatAsksForIt() throws Exception {
        Files.writeString(folder.resolve("scene.txt"), "cam 0 0 -5 0 0 0 0 1 0 1 1\nset 0.25 0.5 1 1 1\n"
            + "mtl 0 0 0 0 0 0 0 0 0 1 0  1 1 1\nsph 0 0 0 1 1\n");
        Program program = run("scene.txt", "out.png", "4", "3");
        assertTrue(program.errors().matches(
            DRAWING.replace("40 x 30", "4 x 3") + "out\\.png: 4 x 3 pixels in \\d+ ms, in ambient light of 0\\.250 0\\.500 1\\.000\\R"), program.errors());
    }

    @Test
    void aSceneBecomesAPictureAndALineOnStandardError() throws Exception {
        Program program = run("scene.txt", "out.png", "40", "30");
        assertEquals(0, program.status(), program.errors());
        assertEquals("", program.output());
        assertTrue(program.errors().matches(DRAWING + "out\\.png: 40 x 30 pixels in \\d+ ms\\R"), program.errors());
        assertEquals(List.of("out.png", "scene.txt"), Folders.names(folder));
        BufferedImage picture = ImageIO.read(folder.resolve("out.png").toFile());
        assertEquals(40, picture.getWidth());
        assertEquals(30, picture.getHeight());
    }

    @Test
    void thePictureIs500By500UnlessTheUserSaysOtherwise() throws Exception {
        assertEquals(0, run("scene.txt", "out.bmp").status());
        BufferedImage picture = ImageIO.read(folder.resolve("out.bmp").toFile());
        assertEquals(500, picture.getWidth());
        assertEquals(500, picture.getHeight());
    }

    @Test
    void theSameFileComesOutOfEveryNumberOfThreads() throws Exception {
        run("scene.txt", "one.png", "50", "50", "--threads", "1");
        run("scene.txt", "two.png", "50", "50", "--threads", "2");
        assertEquals(-1, Files.mismatch(folder.resolve("one.png"), folder.resolve("two.png")));
    }

    @Test
    void anErrorLimitComesWithTheErrorThatCameOut() throws Exception {
        Program program = run("scene.txt", "out.png", "40", "30", "--error", "2");
        assertEquals(0, program.status(), program.errors());
        assertTrue(program.errors().matches(DRAWING + "out\\.png: 40 x 30 pixels in \\d+ ms, "
            + "error about \\d\\.\\d+ steps \\(largest \\d\\.\\d+\\), \\d+ % of the pixels with more than one ray\\R"), program.errors());
    }

    @Test
    void aFormatThatLosesMoreIsNamedBesideTheError() throws Exception {
        assertTrue(run("scene.txt", "out.jpg", "40", "30", "--error", "2").errors()
            .contains(" of the pixels with more than one ray, and jpeg itself loses more"));
    }

    @Test
    void smoothEdgesComeWithTheShareOfPixelsThatNeededThem() throws Exception {
        Program program = run("scene.txt", "out.png", "40", "30", "--samples", "3");
        assertEquals(0, program.status(), program.errors());
        assertTrue(program.errors().matches(
            DRAWING + "out\\.png: 40 x 30 pixels in \\d+ ms, \\d+\\.\\d % of them with 3 x 3 rays\\R"), program.errors());
        assertFalse(program.errors().contains(" 0.0 %") || program.errors().contains("100.0 %"), program.errors());
    }

    @Test
    void helpAndVersionGoToStandardOutput() throws Exception {
        Program help = run("--help");
        assertEquals(0, help.status());
        assertEquals("", help.errors());
        assertTrue(help.output().startsWith("usage: java -jar RayTracer.jar SCENE OUTPUT"));
        assertTrue(run("--version").output().matches("RayTracer \\d+\\.\\d+\\R"));
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource(delimiter = '|', quoteCharacter = '"', value = {
        "no.txt out.png                 | no.txt: no such file, expected a scene file",
        "scene.txt out.tiff             | out.tiff: unknown picture format, expected a name ending in .png, .jpg, .bmp or .gif",
        "scene.txt none/out.png         | none/out.png: no such folder",
        "scene.txt out.png 40           | a width without a height, did you mean scene.txt out.png 40 40? See --help",
        "scene.txt out.png 40 0         | height: must be a whole number from 1 to 715827879, got 0",
        "scene.txt out.png --fast       | --fast: unknown option, see --help",
        "scene.txt                      | no output: expected SCENE OUTPUT [WIDTH HEIGHT] [options], see --help",
    })
    void theUsersMistakesEndWithStatus2AndOneSentence(String line, String expected) throws Exception {
        Program program = run(line.split(" "));
        assertEquals(expected + System.lineSeparator(), program.errors());
        assertEquals("", program.output());
        assertEquals(2, program.status());
        assertEquals(List.of("scene.txt"), Folders.names(folder));
    }

    @Test
    void aWrongSceneEndsWithStatus2AndALineForEveryError() throws Exception {
        Files.writeString(folder.resolve("scene.txt"), SCENE + "sph 0 0 0 -1 1\nbox 0 0 0 1 9\n");
        Files.writeString(folder.resolve("out.png"), "older");
        Program program = run("scene.txt", "out.png");
        assertEquals(List.of("scene.txt:7: sph: radius must be above 0, got -1",
            "scene.txt:8: box: material must be from 1 to 1, got 9"), program.errors().lines().toList());
        assertEquals(2, program.status());
        assertEquals("older", Files.readString(folder.resolve("out.png")));
    }

    @Test
    void tooLittleMemoryEndsWithStatus1AndASentence() throws Exception {
        Files.writeString(folder.resolve("out.png"), "older");
        Program program = Program.run(Program.JAVA_HOME, List.of("-Xmx24m"), folder,
            "scene.txt", "out.png", "3000", "3000", "--quiet");
        assertTrue(program.errors().startsWith("not enough memory for this scene and picture size"), program.errors());
        assertEquals(1, program.errors().lines().count());
        assertEquals(1, program.status());
        assertEquals("older", Files.readString(folder.resolve("out.png")));
    }

    /** The picture's 6.4 GB are allocated at once and never used. */
    @ParameterizedTest
    @CsvSource({"-Xmx64m, -Xmx4g, 4 GB", "-Xmx5g, -Xmx10g, 10 GB"})
    void whatIsAdvisedForMemoryIsMoreThanThereWas(String there, String option, String advised) throws Exception {
        Program program = Program.run(Program.JAVA_HOME, List.of(there), folder,
            "scene.txt", "out.jpg", "40000", "40000", "--quiet");
        assertEquals("not enough memory for this scene and picture size; java " + option + " -jar RayTracer.jar ... allows "
            + advised + System.lineSeparator(), program.errors());
        assertEquals(1, program.status());
    }

    /** As root, a move onto a device would replace it. */
    @Test
    void aDeviceIsNeverReplacedByAPicture() throws Exception {
        Path device = Path.of("/dev/null");
        if (Files.exists(device)) {
            Files.createSymbolicLink(folder.resolve("out.png"), device);
            Program program = run("scene.txt", "out.png", "4", "4");
            assertEquals("out.png: is a link to /dev/null: exists and may not be replaced" + System.lineSeparator(),
                program.errors());
            assertEquals(2, program.status());
            assertFalse(Files.isRegularFile(device));
            Files.delete(folder.resolve("out.png"));
        }
    }
}
