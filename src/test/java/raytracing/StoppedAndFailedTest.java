package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A signal ends the program, which then has to write what is finished. */
class StoppedAndFailedTest {
    @TempDir
    private Path folder;

    @BeforeEach
    void makeFolder() throws Exception {
        Files.createDirectory(folder.resolve("disk"));
    }

    /** Draws the endless picture until no more of it will be finished, and runs commands and sends signals then. */
    private String stop(int status, String output, String commands, String... signals) throws Exception {
        try (TerminalProgram program = TerminalProgram.start(folder, "", Endless.arguments(folder, output),
            "--keep-partial")) {
            program.awaitShown(output + "  50 %");
            Shell.run(folder, commands);
            for (String signal : signals) {
                program.signal(signal);
            }
            assertEquals(status, program.awaitEnd());
            return program.shown();
        }
    }

    @Test
    void whyItCannotBeWrittenIsSaidAndTheStatusIs1() throws Exception {
        String shown = stop(1, "disk/out.png", "rm -r disk", "TERM");
        assertTrue(shown.contains("disk/out.png: could not be written: its folder is no longer there; the file is as it was"),
            shown);
    }

    @Test
    void aFullDiskIsSaidAndTheStatusIs1() throws Exception {
        Shell mount = Shell.run(folder, "mount -t tmpfs -o size=4k tmpfs disk");
        Skipped.unless(mount.status() == 0, "no small disk may be mounted here, so none is full");
        try {
            String shown = stop(1, "disk/out.bmp", "head -c 4096 /dev/zero > disk/full", "HUP");
            assertTrue(shown.contains("disk/out.bmp: could not be written: No space left on device; the file is as it was"),
                shown);
        } finally {
            Shell.run(folder, "umount disk");
        }
    }

    /** It changes nothing: what is finished is still written. */
    @Test
    void aSecondSignalLeavesStatusAndPicture() throws Exception {
        String shown = stop(143, "disk/out.png", "true", "TERM", "TERM");
        assertTrue(shown.contains("what was finished is in the file; the rest is transparent"), shown);
        assertEquals(Endless.HEIGHT, ImageIO.read(folder.resolve("disk/out.png").toFile()).getHeight());
    }
}
