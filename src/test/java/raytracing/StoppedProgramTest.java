package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is left when a signal ends the program. */
class StoppedProgramTest {
    /** Every point of the floor takes a million shadow rays, so that nobody sees the end of it. */
    private static final String ENDLESS = """
        cam 0 1 -3   0 0 0   0 1 0   1 1
        set 0.25 0.5 1   1024 4
        mtl 0.5 0.5 0.5   0 0 0   0 0 0   1 0
        pln 0 1 0  0  1
        sph 0 0.5 0  0.5  1
        lgt 0 9 0   1 1 1   1 1 20
        """;
    private static final long MOST_SECONDS_TO_WORK = 120;
    private static final int SIGKILL = 9;
    private static final int SIGTERM = 15;

    @TempDir
    private Path folder;

    @BeforeEach
    void writeScene() throws IOException {
        Files.writeString(folder.resolve("endless.txt"), ENDLESS);
        Files.writeString(folder.resolve("out.png"), "older");
    }

    private Process start(List<String> prefix, String... arguments) throws IOException {
        Path log = folder.resolve("log");
        return Program.start(prefix, Program.JAVA_HOME, List.of(), Map.of(), folder, log, log, arguments);
    }

    /** As long as it takes to be well into the picture, also on a busy machine. */
    private static void awaitWork(Process process, Duration work) throws IOException, InterruptedException {
        Patience.await("work", MOST_SECONDS_TO_WORK, () -> !process.isAlive()
            || process.info().totalCpuDuration().orElse(Duration.ZERO).compareTo(work) >= 0);
    }

    /** A shell that starts something in the background lets it ignore SIGINT; here it is not to be ignored. */
    @ParameterizedTest(name = "SIG{0}")
    @CsvSource({"INT, 130", "TERM, 143", "HUP, 129"})
    void aSignalEndsTheProgramWithItsStatusAndTheOlderFile(String signal, int status) throws Exception {
        assumeTrue(Shell.has("kill", "env"), "skipped: there is no kill or env here");
        Process process = start(List.of("env", "--default-signal=" + signal), "endless.txt", "out.png");
        awaitWork(process, Duration.ofMillis(900));
        Shell.run(folder, "kill -" + signal + " " + process.pid());
        assertEquals(status, process.waitFor());
        assertEquals("older", Files.readString(folder.resolve("out.png")));
        assertEquals(List.of("endless.txt", "log", "out.png"), Folders.names(folder));
        String log = Files.readString(folder.resolve("log"));
        assertTrue(log.matches("out\\.png: drawing 500 x 500 .*\\R"
            + "out\\.png: stopped at \\d+ %, the file is as it was\\R"), log);
    }

    /** A small endless picture, of which what is finished after a while is kept: the sky, and nothing of the floor. */
    private BufferedImage kept(String output) throws Exception {
        Process process = start(List.of(), "endless.txt", output, "64", "64", "--keep-partial");
        awaitWork(process, Duration.ofSeconds(2));
        process.destroy();
        assertEquals(128 + SIGTERM, process.waitFor());
        return ImageIO.read(folder.resolve(output).toFile());
    }

    @Test
    void whatIsFinishedIsKeptIfTheUserWantsThat() throws Exception {
        BufferedImage picture = kept("out.png");
        assertEquals(List.of("endless.txt", "log", "out.png"), Folders.names(folder));
        assertEquals(0xff4080ff, picture.getRGB(0, 0), "the sky");
        assertEquals(0x00000000, picture.getRGB(32, 63), "the floor");
        String log = Files.readString(folder.resolve("log"));
        assertTrue(log.matches("out\\.png: drawing 64 x 64 .*\\R"
            + "out\\.png: stopped at \\d+ %, what was finished is in the file; the rest is transparent\\R"), log);
    }

    @Test
    void aFormatWithoutTransparencyShowsTheBackgroundInstead() throws Exception {
        assertEquals(0xff4080ff, kept("out.bmp").getRGB(32, 63));
    }

    private Process startSmall(String output) throws IOException {
        return start(List.of(), "scene.txt", output, "300", "300", "--threads", "1");
    }

    /**
     * A hundred runs, two at a time, ended by SIGTERM or SIGKILL at random moments between the first instruction and a bit
     * after the end. Whenever that is, the file has all bytes of the older picture or all of the new one.
     */
    @Test
    void whenAProgramIsKilledItsFileIsTheOlderOrTheNewOneAsAWhole() throws Exception {
        Files.writeString(folder.resolve("scene.txt"), ENDLESS.replace("1024 4", "4 4"));
        long begin = System.nanoTime();
        Process[] undisturbed = {startSmall("new.png"), startSmall("another.png")};
        for (Process process : undisturbed) {
            assertEquals(0, process.waitFor());
        }
        long usual = System.nanoTime() - begin;
        byte[] newer = Files.readAllBytes(folder.resolve("new.png"));
        byte[] older = "older".getBytes();
        Random random = new Random(7);
        int untouched = 0;
        for (int i = 0; i < 50; i++) {
            Process[] processes = new Process[2];
            for (int j = 0; j < 2; j++) {
                Files.write(folder.resolve(j + ".png"), older);
                processes[j] = startSmall(j + ".png");
            }
            Thread.sleep((long) (1.5 * random.nextDouble() * usual / 1e6));
            processes[0].destroy();
            processes[1].destroyForcibly();
            for (int j = 0; j < 2; j++) {
                int status = processes[j].waitFor();
                byte[] found = Files.readAllBytes(folder.resolve(j + ".png"));
                assertTrue(Arrays.equals(found, older) || Arrays.equals(found, newer),
                    found.length + " bytes in a file of a program that ended with " + status);
                assertTrue(status == 0 || status == 128 + (j == 0 ? SIGTERM : SIGKILL), "status " + status);
                untouched += found.length == older.length ? 1 : 0;
            }
        }
        assertTrue(untouched > 5 && untouched < 100, "killed in time: " + untouched + " of 100");
    }
}
