package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A signal ends the program, which then has to write what is finished. */
class StoppedAndFailedTest {
    /** Two tiles: one of the sky, there at once, and one of a floor whose points take a thousand million shadow rays each. */
    private static final String ENDLESS = """
        cam 0 1 -3   0 1 0   0 1 0   1 1
        set 0.25 0.5 1   1024 4
        mtl 0.5 0.5 0.5   0 0 0   0 0 0   1 0
        pln 0 1 0  0  1
        sph 0 9 0  3  1
        """ + "lgt 0 9 0   1 1 1   1 1 20\n".repeat(1000);

    @TempDir
    private Path folder;

    @BeforeEach
    void writeScene() throws Exception {
        assumeTrue(Shell.has("script"), "SKIPPED: there is no script here, which makes a terminal");
        Files.writeString(folder.resolve("scene.txt"), ENDLESS);
        Files.createDirectory(folder.resolve("disk"));
    }

    /** Draws until the sky is finished, which the line on a terminal says, and does something then. */
    private Shell drawHalf(String output, String... commands) throws Exception {
        return Shell.run(folder, "script -qefc 'echo $$ > pid; exec \"$JAVA\" -jar \"$JAR\" scene.txt " + output
            + " 16 32 --threads 1 --keep-partial' shown > /dev/null & program=$!",
            "until grep -qs '50 %' shown; do kill -0 $program || exit 99; sleep 0.1; done",
            String.join("\n", commands), "wait $program");
    }

    private void assertSaid(String sentence) throws Exception {
        String shown = Files.readString(folder.resolve("shown"));
        assertTrue(shown.contains(sentence), shown);
    }

    @Test
    void whyItCannotBeWrittenIsSaidAndTheStatusIs1() throws Exception {
        assertEquals(1, drawHalf("disk/out.png", "rm -r disk", "kill -TERM $(cat pid)").status());
        assertSaid("disk/out.png: could not be written: its folder is no longer there; the file is as it was");
    }

    @Test
    void aFullDiskIsSaidAndTheStatusIs1() throws Exception {
        Shell mount = Shell.run(folder, "mount -t tmpfs -o size=4k tmpfs disk");
        assumeTrue(mount.status() == 0, "SKIPPED: may not mount a small disk here: " + mount.text());
        try {
            assertEquals(1, drawHalf("disk/out.bmp", "head -c 4096 /dev/zero > disk/full", "kill -HUP $(cat pid)").status());
            assertSaid("disk/out.bmp: could not be written: No space left on device; the file is as it was");
        } finally {
            Shell.run(folder, "umount disk");
        }
    }

    /** It changes nothing: what is finished is still written. */
    @Test
    void aSecondSignalLeavesStatusAndPicture() throws Exception {
        assertEquals(143, drawHalf("disk/out.png", "kill -TERM $(cat pid)", "kill -TERM $(cat pid)", "true").status());
        assertSaid("what was finished is in the file; the rest is transparent");
        assertEquals(32, ImageIO.read(folder.resolve("disk/out.png").toFile()).getHeight());
    }
}
