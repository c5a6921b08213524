package raytracing;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** {@code --watch} on a virtual screen, with files saved as editors do it. */
class WatchTest {
    /** Lit everywhere, each pixel a bit differently. */
    private static final String SCENE = """
        cam 0 2 -6   0 0 0   0 1 0   1 1
        set 0.2 0.4 0.6   4 4
        mtl 0.8 0.4 0.2   0.5 0.5 0.5   0.2 0.2 0.2   20 0
        pln 0 1 0  -1  1
        sph 0 0 0   1  1
        lgt 3 5 -3   1 1 1   1 0.9 2
        """;

    /** Every point takes a million shadow rays, so the picture is never finished in a test. */
    private static final String ENDLESS = SCENE.replace("4 4", "1024 4").replace("0.9 2", "0.9 20");

    @TempDir
    private Path folder;

    @BeforeEach
    void writeScene() throws IOException {
        save("scene.txt", SCENE);
    }

    private void save(String name, String scene) throws IOException {
        Files.writeString(folder.resolve(name), scene);
    }

    private VirtualScreen screen() throws Exception {
        Skipped.unless(Shell.has("env", "kill", "sed"), "env, kill or sed is not here");
        return VirtualScreen.start(Files.createDirectory(folder.resolve("screen")));
    }

    private WatchedProgram start(VirtualScreen screen, String arguments) throws IOException {
        return WatchedProgram.start(screen, List.of(), folder, arguments.split(" "));
    }

    private static void await(String what, Patience.Condition condition) throws Exception {
        Patience.await(what, condition);
    }

    /** The colour of the sky in the picture's file: it tells which scene was drawn. */
    private void awaitSky(int rgb, String output) throws Exception {
        Path file = folder.resolve(output);
        await("picture with this sky", () -> Files.exists(file) && (ImageIO.read(file.toFile()).getRGB(0,
            0) & 0xffffff) == rgb);
    }

    private static String withSky(String colour) {
        return SCENE.replace("set 0.2 0.4 0.6", "set " + colour).replace("cam 0 2 -6   0 0 0", "cam 0 0 -6   0 1 0");
    }

    private void awaitEnd(WatchedProgram program, String summary) throws Exception {
        await("end of the drawing", () -> program.tell("title").matches(summary));
    }

    /** A plain run's file for the same scene. */
    private byte[] drawnPlainly(String scene, String options) throws Exception {
        save("plain.txt", scene);
        assertEquals(0, Program.run(folder, ("plain.txt plain.png " + options).split(" ")).status());
        return Files.readAllBytes(folder.resolve("plain.png"));
    }

    @Test
    void everySaveIsDrawnHoweverEditorsSave() throws Exception {
        save("scene.txt", withSky("0 0 0.2"));
        try (VirtualScreen screen = screen(); WatchedProgram program = start(screen, "scene.txt out.png 40 30 --watch")) {
            awaitSky(0x000033, "out.png");
            Shell.run(folder, "sed -i 's/set 0 0 0.2/set 0 0.2 0/' scene.txt");
            awaitSky(0x003300, "out.png");
            save("other.txt", withSky("0.2 0 0"));
            Shell.run(folder, "cp other.txt scene.txt");
            awaitSky(0x330000, "out.png");
            save("other.txt", withSky("0 0 0.4"));
            Shell.run(folder, "mv other.txt scene.txt");
            awaitSky(0x000066, "out.png");
            save("scene.txt", withSky("0 0.4 0"));
            awaitSky(0x006600, "out.png");
            Shell.run(folder, "mv scene.txt scene.txt~");
            await("sentence", () -> program.tell("message").equals("scene.txt: no such file, expected a scene file"));
            save("scene.txt", withSky("0.4 0 0"));
            awaitSky(0x660000, "out.png");
            program.order("escape");
            assertEquals(0, program.await());
        }
    }

    /** Half of it is a scene too: a floor without a ball. */
    @Test
    void aFileThatIsWrittenSlowlyIsDrawnWhenItIsWhole() throws Exception {
        byte[] expected = drawnPlainly(SCENE + "lgt -3 5 -3   0.5 0 0   1 0.9 2\n", "40 30");
        try (VirtualScreen screen = screen(); WatchedProgram program = start(screen, "scene.txt out.png 40 30 --watch")) {
            awaitEnd(program, "out\\.png: 40 x 30 pixels in .*");
            try (OutputStream file = Files.newOutputStream(folder.resolve("scene.txt"))) {
                for (byte b : (SCENE + "lgt -3 5 -3   0.5 0 0   1 0.9 2\n").getBytes(StandardCharsets.UTF_8)) {
                    file.write(b);
                    file.flush();
                    Thread.sleep(2);
                }
            }
            await("the whole scene's picture", () -> Arrays.equals(expected, Files.readAllBytes(folder.resolve("out.png"))));
            program.order("escape");
            assertEquals(0, program.await());
        }
    }

    /** A link in one folder to a file in another, which is saved there, and then the link leads elsewhere. */
    @Test
    void aLinkIsWatchedAndSoIsWhatItLeadsTo() throws Exception {
        Path elsewhere = Files.createDirectory(folder.resolve("elsewhere"));
        Files.writeString(elsewhere.resolve("real.txt"), withSky("0 0 0.2"));
        Files.createSymbolicLink(folder.resolve("link.txt"), Path.of("elsewhere/real.txt"));
        try (VirtualScreen screen = screen(); WatchedProgram program = start(screen, "link.txt out.png 40 30 --watch")) {
            awaitSky(0x000033, "out.png");
            Shell.run(elsewhere, "sed -i 's/set 0 0 0.2/set 0 0.2 0/' real.txt");
            awaitSky(0x003300, "out.png");
            Files.writeString(elsewhere.resolve("another.txt"), withSky("0.2 0 0"));
            Shell.run(folder, "ln -sfn elsewhere/another.txt link.txt");
            awaitSky(0x330000, "out.png");
            program.order("close");
            assertEquals(0, program.await());
        }
    }

    @Test
    void aSaveStopsTheDrawingInProgressWhichNeverTouchesTheFile() throws Exception {
        byte[] expected = drawnPlainly(SCENE, "120 90 --samples 2");
        save("out.png", "older");
        save("scene.txt", ENDLESS);
        try (VirtualScreen screen = screen();
             WatchedProgram program = start(screen, "scene.txt out.png 120 90 --samples 2 --watch")) {
            awaitEnd(program, "out\\.png - \\d+ %.*");
            save("scene.txt", ENDLESS + "# the same, stopped and begun again\n");
            await("stopped drawing", () -> program.errors().contains("out.png: stopped at "));
            assertEquals("older", Files.readString(folder.resolve("out.png")));
            save("scene.txt", SCENE);
            await("new picture", () -> Files.size(folder.resolve("out.png")) != "older".length());
            assertArrayEquals(expected, Files.readAllBytes(folder.resolve("out.png")));
            program.order("escape");
            assertEquals(0, program.await());
            assertTrue(program.errors().matches("(?s).*stopped at \\d+ %, the file is as it was\\R.*"
                + "out\\.png: 120 x 90 pixels in \\d+ m?s, [^\\n]* rays\\R"), program.errors());
        }
    }

    @Test
    void mistakesStandOverTheLastGoodPictureUntilTheyAreMended() throws Exception {
        try (VirtualScreen screen = screen(); WatchedProgram program = start(screen, "scene.txt out.png 400 300 --watch")) {
            awaitEnd(program, "out\\.png: 400 x 300 pixels in .*");
            BufferedImage good = ImageIO.read(folder.resolve("out.png").toFile());
            save("scene.txt", SCENE + "sph 0 0 0 -1 1\nbox 0 0 0 1 9\n");
            await("sentences", () -> program.tell("message").equals("scene.txt:7: sph: radius must be above 0, got -1|"
                + "scene.txt:8: box: material must be from 1 to 1, got 9"));
            assertEquals("scene.txt:7: sph: radius must be above 0, got -1", program.tell("title"));
            await("last good picture", () -> isBelowTheMessage(good, screen.screenshot()));
            save("scene.txt", ENDLESS.replace("0 0 0   0 1 0   1 1", "0 3 0   0 -1 0   1 1"));
            await("sky of the next one, below", () -> !isBelowTheMessage(good, screen.screenshot()));
            assertEquals("", program.tell("message"));
            save("scene.txt", "");
            await("sentences", () -> program.tell("message").startsWith("scene.txt: cam: missing"));
            await("last good picture, no trace of what was stopped", () -> isBelowTheMessage(good, screen.screenshot()));
            save("scene.txt", withSky("0 0 0.2"));
            awaitEnd(program, "out\\.png: 400 x 300 pixels in .*");
            assertEquals("", program.tell("message"));
            BufferedImage mended = ImageIO.read(folder.resolve("out.png").toFile());
            await("new picture", () -> isBelowTheMessage(mended, screen.screenshot()));
            program.order("escape");
            assertEquals(0, program.await());
            assertTrue(program.errors().contains("scene.txt:7: sph: radius must be above 0, got -1" + System.lineSeparator()));
        }
    }

    /** One channel of three is off by 51 steps everywhere, or none is. */
    @Test
    void everyPictureIsComparedAndTheTitleSaysSo() throws Exception {
        String blue = "cam 0 0 -5 0 0 0 0 1 0 1 1\nset 0.2 0.4 0.6 1 1\n";
        String bluer = blue.replace("0.6", "0.8");
        save("scene.txt", blue);
        BufferedImage sky = new BufferedImage(40, 30, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 40 * 30; i++) {
            sky.setRGB(i % 40, i / 40, 0x336699);
        }
        ImageIO.write(sky, "png", folder.resolve("other.png").toFile());
        try (VirtualScreen screen = screen();
             WatchedProgram program = start(screen, "scene.txt out.png 40 30 --watch --compare other.png")) {
            awaitEnd(program, ".*out\\.png: compared with other\\.png: RMS 0 steps.*");
            save("scene.txt", bluer);
            awaitEnd(program, ".*out\\.png: compared with other\\.png: RMS 29\\.44 steps.*");
            Files.delete(folder.resolve("other.png"));
            save("scene.txt", blue);
            await("sentence",
                () -> program.tell("message").equals("--compare: other.png: no such file, expected a picture"));
            ImageIO.write(sky, "png", folder.resolve("other.png").toFile());
            save("scene.txt", blue + "# again\n");
            awaitEnd(program, ".*out\\.png: compared with other\\.png: RMS 0 steps.*");
            program.order("escape");
            assertEquals(0, program.await());
        }
    }

    @Test
    void comparedWithItsOwnFileAPictureShowsWhatTheLastSaveChanged() throws Exception {
        String blue = "cam 0 0 -5 0 0 0 0 1 0 1 1\nset 0.2 0.4 0.6 1 1\n";
        save("scene.txt", blue);
        assertEquals(0, Program.run(folder, "scene.txt", "out.png", "40", "30").status());
        try (VirtualScreen screen = screen();
             WatchedProgram program = start(screen, "scene.txt out.png 40 30 --watch --compare out.png")) {
            awaitEnd(program, ".*compared with out\\.png: RMS 0 steps.*");
            save("scene.txt", blue.replace("0.6", "0.8"));
            awaitEnd(program, ".*compared with out\\.png: RMS 29\\.44 steps.*");
            save("scene.txt", blue.replace("0.6", "0.8") + "# the same\n");
            awaitEnd(program, ".*compared with out\\.png: RMS 0 steps.*");
            program.order("escape");
            assertEquals(0, program.await());
        }
    }

    /** Before the window opens. */
    @Test
    void aWatchedPictureIsNotComparedWithAFileThatIsNotThere() throws Exception {
        try (VirtualScreen screen = screen();
             WatchedProgram program = start(screen, "scene.txt out.png 40 30 --watch --compare none.png")) {
            assertEquals(2, program.await());
            assertEquals("--compare: none.png: no such file, expected a picture" + System.lineSeparator(), program.errors());
        }
    }

    /** In the smallest window too: what has no room is reached by its scroll bar. */
    @Test
    void manySentencesAreReadInASmallWindow() throws Exception {
        save("scene.txt", "sphere\n".repeat(30));
        try (VirtualScreen screen = screen(); WatchedProgram program = start(screen, "scene.txt out.png 40 30 --watch")) {
            await("sentences", () -> program.tell("message").startsWith("in part: scene.txt:1: sphere: unknown code"));
            assertTrue(program.tell("message").contains("|scene.txt:20: "), program.tell("message"));
            program.order("escape");
            assertEquals(0, program.await());
        }
    }

    @Test
    void theWindowSaysWhatItsKeysDo() throws Exception {
        try (VirtualScreen screen = screen(); WatchedProgram program = start(screen, "scene.txt out.png 40 30 --watch")) {
            assertEquals("Esc closes, wheel or + - zooms, dragging moves, 0 or a double click shows all, 1 is one to one",
                program.tell("keys"));
            program.tell("point 5 5");
            await("what it waits for", () -> program.tell("status").startsWith("drawn again whenever scene.txt is saved"));
            program.order("escape");
            assertEquals(0, program.await());
        }
    }

    /** Whether the lower half of a picture of 400 x 300 is seen somewhere in the middle of the screen. */
    private static boolean isBelowTheMessage(BufferedImage picture, BufferedImage screen) {
        for (int top = 0; top < screen.getHeight() - picture.getHeight(); top++) {
            int left = (screen.getWidth() - picture.getWidth()) / 2;
            if (isThere(picture, screen, left, top)) {
                return true;
            }
        }
        return false;
    }

    private static boolean isThere(BufferedImage picture, BufferedImage screen, int left, int top) {
        for (int y = picture.getHeight() / 2; y < picture.getHeight(); y++) {
            for (int x = 0; x < picture.getWidth(); x++) {
                if ((picture.getRGB(x, y) ^ screen.getRGB(left + x, top + y)) << 8 != 0) {
                    return false;
                }
            }
        }
        return true;
    }

    @Test
    void zoomAndPlaceStayWhenThePictureIsDrawnAgain() throws Exception {
        try (VirtualScreen screen = screen(); WatchedProgram program = start(screen, "scene.txt out.png 400 300 --watch")) {
            awaitEnd(program, "out\\.png: 400 x 300 pixels in .*");
            program.tell("point 600 500");
            for (int scale = 2; scale <= 16; scale *= 2) {
                program.tell("wheel -1");
            }
            await("zoomed picture", () -> program.tell("status").endsWith(" 1600 %"));
            String place = program.tell("status").split(":")[0];
            String colour = colour(place);
            await("that pixel", () -> program.tell("status").equals(place + ":  " + colour + " 1600 %"));
            save("scene.txt", SCENE.replace("0.8 0.4 0.2", "0.2 0.4 0.8").replace("0.2 0.4 0.6", "0.6 0.4 0.2"));
            await("new picture", () -> !colour(place).equals(colour));
            await("the same pixel of the new one",
                () -> program.tell("status").equals(place + ":  " + colour(place) + " 1600 %"));
            program.order("escape");
            assertEquals(0, program.await());
        }
    }

    /** Of a pixel of the picture's file. */
    private String colour(String place) throws IOException {
        String[] numbers = place.split(", ");
        int rgb = ImageIO.read(folder.resolve("out.png").toFile())
            .getRGB(Integer.parseInt(numbers[0]), Integer.parseInt(numbers[1]));
        return (rgb >> 16 & 255) + " " + (rgb >> 8 & 255) + " " + (rgb & 255);
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({"no.txt, 'no.txt: no such file, expected a scene file'",
        "nowhere/no.txt, 'nowhere/no.txt: no such file, expected a scene file'",
        "screen, 'screen: is a folder, expected a scene file'"})
    void aSceneThatIsNotThereYetIsWaitedFor(String name, String sentence) throws Exception {
        try (VirtualScreen screen = screen(); WatchedProgram program = start(screen, name + " out.png 40 30 --watch")) {
            await("sentence", () -> program.tell("message").equals(sentence));
            if (!name.equals("screen")) {
                Files.createDirectories(folder.resolve(name).getParent());
                Files.writeString(folder.resolve(name), withSky("0 0 0.2"));
                awaitSky(0x000033, "out.png");
            }
            program.order("escape");
            assertEquals(0, program.await());
        }
    }

    @Test
    void whatCannotBeWrittenIsSaidAndTheNextOneIsDrawn() throws Exception {
        Path pictures = Files.createDirectory(folder.resolve("pictures"));
        try (VirtualScreen screen = screen();
             WatchedProgram program = start(screen, "scene.txt pictures/out.png 40 30 --watch --quiet")) {
            await("picture", () -> Files.exists(pictures.resolve("out.png")));
            Shell.run(folder, "rm -r pictures");
            save("scene.txt", SCENE + "# again\n");
            await("sentence", () -> program.tell("message").equals("pictures/out.png: no such folder"));
            Files.createDirectory(pictures);
            save("scene.txt", withSky("0 0 0.2"));
            awaitSky(0x000033, "pictures/out.png");
            await("no sentence", () -> program.tell("message").isEmpty());
            program.order("close");
            assertEquals(0, program.await());
            assertEquals("pictures/out.png: no such folder" + System.lineSeparator(), program.errors());
        }
    }

    /** Escape and closing are tried while it draws; elsewhere when it has drawn. */
    @ParameterizedTest(name = "{0}")
    @CsvSource({"escape", "close"})
    void theWindowEndsItWithStatus0AlsoWhileItDraws(String order) throws Exception {
        save("scene.txt", ENDLESS);
        save("out.png", "older");
        try (VirtualScreen screen = screen(); WatchedProgram program = start(screen, "scene.txt out.png 40 30 --watch")) {
            awaitEnd(program, "out\\.png - \\d+ %.*");
            program.order(order);
            assertEquals(0, program.await());
        }
        assertEquals("older", Files.readString(folder.resolve("out.png")));
        assertEquals(List.of("errors", "out.png", "scene.txt", "screen"), Folders.names(folder));
    }

    /** A shell makes processes in the background ignore SIGINT; this one must not. */
    @ParameterizedTest(name = "SIG{0} {2}")
    @CsvSource({"INT, 130, drawing", "TERM, 143, drawing", "INT, 130, idle", "TERM, 143, idle"})
    void aSignalEndsItWithItsStatus(String signal, int status, String state) throws Exception {
        save("scene.txt", state.equals("idle") ? SCENE : ENDLESS);
        save("out.png", "older");
        try (VirtualScreen screen = screen()) {
            Path errors = folder.resolve("errors");
            Process process = Program.start(List.of("env", "--default-signal=" + signal), Program.JAVA_HOME, List.of(),
                Map.of("DISPLAY", screen.name()), folder, errors, errors, "scene.txt", "out.png", "40", "30", "--watch");
            await("beginning or end of the drawing",
                () -> Files.readString(errors).contains(state.equals("idle") ? " pixels in " : "out.png: drawing "));
            Shell.run(folder, "kill -" + signal + " " + process.pid());
            assertEquals(status, process.waitFor());
            assertEquals(!state.equals("idle"),
                Files.readString(folder.resolve("out.png"), StandardCharsets.ISO_8859_1).equals("older"));
            assertEquals(List.of("errors", "out.png", "scene.txt", "screen"), Folders.names(folder));
        }
    }

    @Test
    void statisticsComeAfterEachPicture() throws Exception {
        try (VirtualScreen screen = screen()) {
            Path output = folder.resolve("output");
            Process process = Program.start(List.of(), Program.JAVA_HOME, List.of(), Map.of("DISPLAY", screen.name()), folder,
                output, folder.resolve("errors"), "scene.txt", "out.png", "40", "30", "--watch", "--stats=json", "--quiet");
            await("first line", () -> Files.readAllLines(output).size() == 1);
            Shell.run(folder, "sed -i 's/sph 0 0 0/box 0 0 0/' scene.txt");
            await("second line", () -> Files.readAllLines(output).size() == 2);
            process.destroy();
            assertEquals(143, process.waitFor());
            assertTrue(Files.readAllLines(output).get(0).contains("\"spheres\": 1, "), Files.readString(output));
            assertTrue(Files.readAllLines(output).get(1).contains("\"boxes\": 1, "), Files.readString(output));
            assertEquals("", Files.readString(folder.resolve("errors")));
        }
    }

    @Test
    void withoutADisplayItIsRefusedBeforeAnythingIsDrawn() throws Exception {
        Program program = Program.run(Program.JAVA_HOME, List.of(), Map.of("DISPLAY", ""), folder, "scene.txt", "out.png",
            "--watch");
        assertEquals("--watch: no display to open a window on, DISPLAY is not set" + System.lineSeparator(), program.errors());
        assertEquals(2, program.status());
        assertEquals(List.of("scene.txt"), Folders.names(folder));
    }
}
