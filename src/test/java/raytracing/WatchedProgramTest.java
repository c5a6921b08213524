package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What the program says while it draws and afterwards. */
class WatchedProgramTest {
    private static final String SCENE = """
        cam 0 1 -3   0 0 0   0 1 0   1 1
        set 0.25 0.5 1   3 4
        mtl 0.5 0.5 0.5   0 0 0   0.5 0.5 0.5   1 0  0.5 0.5 0.5
        pln 0 1 0  0  1
        sph 0 0.5 0  0.5  1
        box 1 0.5 0  0.5  1
        lgt 0 9 0   1 1 1   1 1 2
        """;

    @TempDir
    private Path folder;

    @BeforeEach
    void writeScene() throws Exception {
        Files.writeString(folder.resolve("scene.txt"), SCENE);
    }

    @Test
    void onATerminalOneLineIsWrittenOverAndOver() throws Exception {
        try (TerminalProgram program = TerminalProgram.start(folder, "", Endless.arguments(folder, "out.png"))) {
            program.awaitShown("50 % .* left[^\n]*50 % .* left[^\n]*50 % .* left");
            List<String> progress = List.of(program.shown().split("[\r\n]")).stream()
                .filter(line -> line.contains(" elapsed")).toList();
            // the last one may not be whole yet
            for (String line : progress.subList(0, progress.size() - 1)) {
                assertTrue(line.matches("out\\.png  ((reading|arranging|ambient light)(  \\d+ %)?|\\d+ %)  \\d:\\d\\d elapsed"
                    + "(  [\\d:]+ left)? *"), line);
                assertTrue(line.length() < 80, line);
            }
        }
    }

    /** Only pictures that take a while have a line: how large those are is up to the machine. */
    @Test
    void onATerminalTheLineIsGoneAtTheEnd() throws Exception {
        int size = 1000;
        String shown = shown(size);
        while (!shown.contains("elapsed")) {
            size *= 2;
            shown = shown(size);
        }
        assertTrue(shown.matches("(?s).*elapsed[^\n]*\r +\rout\\.png: " + size + " x " + size + " pixels in .*"), shown);
    }

    private String shown(int size) throws Exception {
        try (TerminalProgram program = TerminalProgram.start(folder, "", "scene.txt out.png " + size + " " + size)) {
            assertEquals(0, program.awaitEnd(), program.shown());
            return program.shown();
        }
    }

    @Test
    void quietMeansNoWordUnlessSomethingIsWrong() throws Exception {
        Program program = Program.run(folder, "scene.txt", "out.png", "20", "20", "--quiet");
        assertEquals(new Program(0, "", ""), program);
        assertTrue(Files.exists(folder.resolve("out.png")));
    }

    @Test
    void aRegionIsDrawnAndNamed() throws Exception {
        Program program = Program.run(folder, "scene.txt", "out.png", "20", "30", "--region", "4,5,6,7");
        assertTrue(program.errors().matches("(?s)out\\.png: drawing 6 x 7 pixels at 4, 5 of 20 x 30 of scene.txt .*"
            + "out\\.png: 6 x 7 pixels at 4, 5 of 20 x 30 in \\d+ ms.*"), program.errors());
        assertEquals(6, ImageIO.read(folder.resolve("out.png").toFile()).getWidth());
    }

    @Test
    void statisticsForProgramsAreJsonOnStandardOutput() throws Exception {
        Program program = Program.run(folder, "scene.txt", "out.png", "40", "30", "--stats=json", "--quiet", "--samples",
            "2", "--threads", "2", "--region", "0,0,40,20");
        assertEquals("", program.errors());
        JsonObject statistics = JsonParser.parseString(program.output()).getAsJsonObject();
        assertTrue(statistics.keySet().containsAll(Set.of("scene", "picture", "rays", "culled", "milliseconds")));
        JsonObject scene = statistics.getAsJsonObject("scene");
        assertEquals("scene.txt", scene.get("file").getAsString());
        assertEquals(List.of(1, 1, 1, 1, 1), List.of(scene.get("spheres").getAsInt(), scene.get("planes").getAsInt(),
            scene.get("boxes").getAsInt(), scene.get("materials").getAsInt(), scene.get("lights").getAsInt()));
        assertEquals(3, scene.get("ambient_light").getAsJsonArray().size());
        JsonObject picture = statistics.getAsJsonObject("picture");
        assertEquals("[0,0,40,20]", picture.get("region").toString());
        assertEquals(1, picture.get("share_drawn").getAsDouble());
        double refined = picture.get("share_of_pixels_smoothed").getAsDouble();
        JsonObject rays = statistics.getAsJsonObject("rays");
        // the first pass also looks at the row below the region
        assertEquals(40 * 21 + Math.round(4 * 40 * 20 * refined), rays.get("from_the_eye").getAsLong());
        JsonObject culled = statistics.getAsJsonObject("culled");
        assertTrue(culled.entrySet().stream().allMatch(
            share -> share.getValue().getAsDouble() >= 0 && share.getValue().getAsDouble() <= 1), culled.toString());
        JsonObject times = statistics.getAsJsonObject("milliseconds");
        double all = times.get("all").getAsDouble();
        assertTrue(times.entrySet().stream().allMatch(
            time -> time.getValue().getAsDouble() >= 0 && time.getValue().getAsDouble() <= all), times.toString());
    }

    /** As Linux counts it: every virtual machine takes more than 10 MB, and this one has a heap of at most 16 MB. */
    @Test
    void theMemoryOfStatisticsIsThePeakOfTheProcess() throws Exception {
        Skipped.unless(Files.exists(Path.of("/proc/self/status")), "this system does not tell the memory of a process");
        Program program = Program.run(Program.JAVA_HOME, List.of("-Xmx16m"), folder, "scene.txt", "out.png", "40", "30",
            "--stats=json", "--quiet");
        JsonObject bytes = JsonParser.parseString(program.output()).getAsJsonObject().getAsJsonObject("bytes");
        assertEquals(Set.of("peak_of_the_process"), bytes.keySet());
        long peak = bytes.get("peak_of_the_process").getAsLong();
        assertTrue(peak > 10_000_000 && peak < 1_000_000_000, "bytes: " + peak);
    }

    @Test
    void statisticsForPeopleAreATableOnStandardError() throws Exception {
        Program program = Program.run(folder, "scene.txt", "out.png", "40", "30", "--stats", "--quiet");
        assertEquals("", program.output());
        assertTrue(program.errors().lines().anyMatch(line -> line.matches("  from the eye +1,200")), program.errors());
        assertTrue(program.errors().lines().anyMatch(line -> line.matches("  share drawn +100\\.0 %")), program.errors());
        assertTrue(program.errors().lines().allMatch(line -> line.length() <= 80), program.errors());
    }

    @Test
    void aNameWithQuotesIsStillJson() throws Exception {
        Files.writeString(folder.resolve("a \"b\" \\ c.txt"), SCENE);
        Program program = Program.run(folder, "a \"b\" \\ c.txt", "out.png", "4", "3", "--stats=json", "--quiet");
        assertEquals("a \"b\" \\ c.txt", JsonParser.parseString(program.output()).getAsJsonObject()
            .getAsJsonObject("scene").get("file").getAsString());
    }

    /** What was to read has closed the pipe before; the picture is there. */
    @Test
    void aBrokenPipeEndsWithStatus1ASentenceAndThePicture() throws Exception {
        Shell shell = Shell.run(folder, "mkfifo pipe; exec 3<>pipe 4>pipe 3>&-",
            "\"$JAVA\" -jar \"$JAR\" scene.txt out.png 4 4 --stats=json --quiet >&4; echo $?");
        assertEquals(List.of("standard output: could not be written", "1"), shell.text().lines().toList());
        assertEquals(4, ImageIO.read(folder.resolve("out.png").toFile()).getWidth());
    }

    /** 10 million pixels on one film would be 245 MB. */
    @Test
    void memoryDoesNotGrowWithThePicture() throws Exception {
        Files.writeString(folder.resolve("sky.txt"), "cam 0 0 -5 0 0 0 0 1 0 1 1\nset 0.25 0.5 1 1 1\n");
        Program program = Program.run(Program.JAVA_HOME, List.of("-Xmx160m"), folder,
            "sky.txt", "out.png", "3200", "3200", "--quiet");
        assertEquals(new Program(0, "", ""), program);
    }

    @Test
    void aFolderInTheWayIsSaidBeforeAnythingIsDrawn() throws Exception {
        Files.createDirectory(folder.resolve("out.png"));
        Program program = Program.run(folder, "scene.txt", "out.png");
        assertEquals(new Program(2, "", "out.png: is a folder, expected a file name" + System.lineSeparator()), program);
    }

    @Test
    void aFolderInsteadOfASceneIsSaid() throws Exception {
        Files.createDirectory(folder.resolve("scenes"));
        Program program = Program.run(folder, "scenes", "out.png");
        assertEquals(1, program.errors().lines().count(), program.errors());
        assertTrue(program.errors().startsWith("scenes: "), program.errors());
        assertEquals(2, program.status());
    }
}
