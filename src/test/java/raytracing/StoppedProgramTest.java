package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The files that are left when a signal ends the program. */
class StoppedProgramTest {
    @TempDir
    private Path folder;

    @BeforeEach
    void writeOlderFile() throws Exception {
        Files.writeString(folder.resolve("out.png"), "older");
    }

    /** Draws the endless picture until no more of it will be finished, and sends a signal then; all that was shown. */
    private String stop(String signal, int status, String through, String output, String... options) throws Exception {
        String arguments = Endless.arguments(folder, output) + " " + String.join(" ", options);
        try (TerminalProgram program = TerminalProgram.start(folder, through, arguments)) {
            program.awaitShown(output + "  50 %");
            program.signal(signal);
            assertEquals(status, program.awaitEnd());
            return program.shown();
        }
    }

    private void assertNoOtherFiles() throws Exception {
        assertEquals(Stream.concat(Stream.of("endless.txt", "out.png"), TerminalProgram.FILES.stream()).toList(),
            Folders.names(folder));
    }

    /** If the process that starts the tests ignores signals, so do the processes that the tests start. */
    @ParameterizedTest(name = "SIG{0}")
    @CsvSource({"INT, 130", "TERM, 143", "HUP, 129"})
    void aSignalEndsTheProgramWithItsStatusAndTheOlderFile(String signal, int status) throws Exception {
        Skipped.unless(Shell.run(folder, "env --default-signal=INT true").status() == 0,
            "env cannot undo ignored signals here");
        String shown = stop(signal, status, "env --default-signal=" + signal, "out.png");
        assertTrue(shown.contains("out.png: stopped at 50 %, the file is as it was"), shown);
        assertEquals("older", Files.readString(folder.resolve("out.png")));
        assertNoOtherFiles();
    }

    /** The upper half of the endless picture, and whether the lower one has a colour all over. */
    private static void assertHalves(BufferedImage picture, int lower) {
        for (int y = 0; y < Endless.HEIGHT; y++) {
            for (int x = 0; x < Endless.WIDTH; x++) {
                assertEquals(y < Endless.HEIGHT / 2 ? Endless.BACKGROUND : lower, picture.getRGB(x, y), x + ", " + y);
            }
        }
    }

    @Test
    void whatIsFinishedIsKeptIfTheUserWantsThat() throws Exception {
        String shown = stop("TERM", 143, "", "out.png", "--keep-partial");
        assertTrue(shown.contains(
            "out.png: stopped at 50 %, what was finished is in the file; the rest is transparent"), shown);
        assertHalves(ImageIO.read(folder.resolve("out.png").toFile()), 0);
        assertNoOtherFiles();
    }

    @Test
    void aFormatWithoutTransparencyShowsTheBackgroundInstead() throws Exception {
        stop("TERM", 143, "", "out.bmp", "--keep-partial");
        assertHalves(ImageIO.read(folder.resolve("out.bmp").toFile()), Endless.BACKGROUND);
    }

    /** Ten of those that {@code gradle trust} kills by the hundred. */
    @Test
    void whenAProgramIsKilledItsFileIsTheOlderOrTheNewOneAsAWhole() throws Exception {
        assertEquals(10, Kills.of(folder, 10).count());
    }
}
