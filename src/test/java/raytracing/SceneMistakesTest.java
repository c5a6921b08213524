package raytracing;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedWriter;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The messages about a scene file that is wrong, or that is probably not what its author meant. */
class SceneMistakesTest {
    private static final String CAM = "cam 0 0 -5  0 0 0  0 1 0  1 1\n";
    private static final String MTL = "mtl 1 1 1  0 0 0  0 0 0  1 0\n";
    private static final String SPH = "sph 0 0 0 1 1\n";
    private static final String LGT = "lgt 5 5 -5 1 1 1 1 1 0\n";
    private static final String SCENE = CAM + "set 0 0 0 1 1\n" + MTL + SPH + LGT;
    private static final int MILLION = 1_000_000;
    private static final long GIGABYTE = 1L << 30;
    private static final String TOO_LARGE =
        ": is too large, a scene file may have at most 2 GB (2147483639 bytes)" + System.lineSeparator();

    @TempDir
    private Path folder;

    private Program draw(String scene, String... more) throws Exception {
        List<String> words = new ArrayList<>(List.of(scene, "out.png", "4", "4"));
        words.addAll(List.of(more));
        return Program.run(folder, words.toArray(String[]::new));
    }

    @Test
    void aMillionWrongLinesNeedNoMemory() throws Exception {
        try (BufferedWriter text = Files.newBufferedWriter(folder.resolve("scene.txt"))) {
            for (int i = 0; i < MILLION; i++) {
                text.write(i % 3 == 0 ? "sph 0 0 0 -1 1\n" : i % 3 == 1 ? "sph 0 0 0 1 99\n" : "ball 0 0 0\n");
            }
        }
        Program program = Program.run(Program.JAVA_HOME, List.of("-Xmx64m"), folder, "scene.txt", "out.png");
        List<String> lines = program.errors().lines().toList();
        assertEquals(21, lines.size(), program.errors());
        assertEquals("scene.txt:1: sph: radius must be above 0, got -1", lines.get(0));
        assertEquals("scene.txt:2: sph: material must be that of a mtl line, and there is none, got 99", lines.get(2));
        assertTrue(lines.get(19).startsWith("scene.txt:15: ball: "), lines.get(19));
        assertTrue(lines.get(20).matches("scene\\.txt: and 1\\d{6} more"), lines.get(20));
        assertEquals(2, program.status());
    }

    /** A file with a hole takes no room on most disks. */
    @Test
    void aSceneOfMoreThan2GigabytesIsRefusedBeforeItIsRead() throws Exception {
        try (RandomAccessFile file = new RandomAccessFile(folder.resolve("scene.txt").toFile(), "rw")) {
            file.setLength(3 * GIGABYTE);
        }
        Program program = Program.run(Program.JAVA_HOME, List.of("-Xmx24m"), folder, "scene.txt", "out.png");
        assertEquals("scene.txt" + TOO_LARGE, program.errors());
        assertEquals(2, program.status());
    }

    @Test
    void aDeviceThatNeverEndsIsTooLarge() throws Exception {
        Skipped.unless(Files.exists(Path.of("/dev/zero")), "this system has no endless device");
        Program program = Program.run(Program.JAVA_HOME, List.of("-Xmx64m"), folder, "/dev/zero", "out.png");
        assertEquals("/dev/zero" + TOO_LARGE, program.errors());
        assertEquals(2, program.status());
    }

    @Test
    void aPipeIsReadLikeAFile() throws Exception {
        Files.writeString(folder.resolve("scene.txt"), SCENE);
        Shell shell = Shell.run(folder, "cat scene.txt | $JAVA -jar $JAR /dev/stdin out.png 4 4 --quiet");
        assertEquals(0, shell.status(), shell.text());
        assertTrue(Files.exists(folder.resolve("out.png")));
    }

    @Test
    void warningsAreSaidBeforeThePictureIsDrawnAndChangeNothing() throws Exception {
        Files.writeString(folder.resolve("plain.txt"), SCENE);
        Files.writeString(folder.resolve("scene.txt"), SCENE.replace("set 0 0 0 1 1", "set 0 0 0 1 1 4") + MTL);
        assertEquals(0, draw("plain.txt").status());
        byte[] picture = Files.readAllBytes(folder.resolve("out.png"));
        Program program = draw("scene.txt");
        List<String> lines = program.errors().lines().toList();
        assertTrue(lines.get(0).startsWith("scene.txt:2: warning: set: the sixth value, 4, "), program.errors());
        assertTrue(lines.get(0).endsWith("use --samples 4"), program.errors());
        assertEquals("scene.txt: warning: no surface uses material 2", lines.get(1));
        assertTrue(lines.get(2).startsWith("out.png: drawing "), program.errors());
        assertEquals(4, lines.size());
        assertEquals("", program.output());
        assertEquals(0, program.status());
        assertArrayEquals(picture, Files.readAllBytes(folder.resolve("out.png")));
        assertEquals("", draw("scene.txt", "--quiet").errors());
    }

    @Test
    void errorsComeWithoutWarnings() throws Exception {
        Files.writeString(folder.resolve("scene.txt"), "set 0 0 0 1 1 4\n" + MTL + MTL + SPH);
        assertEquals("scene.txt: cam: missing, expected exactly one" + System.lineSeparator(), draw("scene.txt").errors());
    }

    @Test
    void aWholePictureThatShowsNothingIsNamedAtTheEnd() throws Exception {
        Files.writeString(folder.resolve("scene.txt"), SCENE.replace("sph 0 0 0", "sph 0 0 -50"));
        String warning = "scene.txt: warning: no surface is in the picture; does the camera look towards them?";
        List<String> lines = draw("scene.txt").errors().lines().toList();
        assertEquals(3, lines.size());
        assertEquals(warning, lines.get(2));
        assertEquals("", draw("scene.txt", "--quiet").errors());
        assertEquals(2, draw("scene.txt", "--region", "0,0,4,3").errors().lines().count());
        Files.writeString(folder.resolve("scene.txt"), SCENE);
        assertEquals(2, draw("scene.txt").errors().lines().count());
    }

    /** Said of a scene without surfaces when it is read; once is enough. */
    @Test
    void aSceneWithoutSurfacesIsNotWarnedOfTwice() throws Exception {
        Files.writeString(folder.resolve("scene.txt"), CAM + "set 0 0 0 1 1\n" + LGT);
        List<String> lines = draw("scene.txt").errors().lines().toList();
        assertEquals("scene.txt: warning: no sph, pln, box or trg: the picture shows nothing but the background", lines.get(0));
        assertEquals(3, lines.size());
    }

    @Test
    void aFileNameInAMessageCannotColourOrMoveWhatIsAroundIt() throws Exception {
        String name = "a\u001b[31m\nb.txt";
        String shown = "a<U+001B>[31m<U+000A>b";
        assertEquals(shown + ".txt: no such file, expected a scene file" + System.lineSeparator(), draw(name).errors());
        Files.writeString(folder.resolve(name), SCENE);
        Program program = Program.run(folder, name, name.replace(".txt", ".png"), "4", "4", "--stats");
        assertEquals(0, program.status(), program.errors());
        assertTrue(program.errors().startsWith(shown + ".png: drawing 4 x 4 pixels of " + shown + ".txt with "));
        assertTrue(program.errors().contains(" " + shown + ".txt" + System.lineSeparator()), program.errors());
        assertTrue(program.errors().chars().allMatch(c -> c >= ' ' || System.lineSeparator().indexOf(c) >= 0));
        assertEquals("--x<U+001B>[2J: unknown option, see --help" + System.lineSeparator(),
            Program.run(folder, "--x\u001b[2J").errors());
    }
}
