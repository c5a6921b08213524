package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * What the line on a terminal says before the first pixel. {@code script} runs the program on a terminal of its own and
 * keeps what it shows. The program is held at a step until the line has said so, however fast or slow it is.
 */
class PreparationOnATerminalTest {
    private static final String SCENE = "cam 0 1 -3  0 0 0  0 1 0  1 1\nset 0.2 0.5 1  3 4\n"
        + "mtl 0.5 0.5 0.5  0 0 0  0 0 0  1 0  0.5 0.5 0.5\npln 0 1 0 0 1\nsph 0 0.5 0 0.5 1\n";

    @TempDir
    private Path folder;

    @BeforeEach
    void needsATerminal() throws Exception {
        Skipped.unless(Shell.has("script", "mkfifo"), "there is no script here, which makes a terminal, or no mkfifo");
    }

    private static String begin(String scene) {
        return "script -qefc 'echo $$ > pid; exec \"$JAVA\" -jar \"$JAR\" " + scene + " out.png 20 20' shown > log & program=$!";
    }

    private static String await(String words) {
        return "until grep -aqE '" + words + "' shown; do sleep 0.1; done";
    }

    private String shown() throws Exception {
        return Files.readString(folder.resolve("shown"));
    }

    /** Through a pipe that stays open. How much will come is not known, so there is no share. */
    @Test
    void readingIsSaid() throws Exception {
        Files.writeString(folder.resolve("scene.txt"), SCENE);
        Shell shell = Shell.run(folder, "mkfifo pipe", begin("pipe"), "exec 3> pipe", await("reading"),
            "cat scene.txt >&3", "exec 3>&-", "wait $program");
        assertEquals(0, shell.status(), shell + shown());
        assertTrue(shown().contains("\rout.png  reading  0:"), shown());
        assertTrue(shown().lines().anyMatch(line -> line.matches("(?s)(.*\r)?out\\.png: 20 x 20 pixels in .*")), shown());
    }

    /** The mistakes stand where the line was. */
    @Test
    void theLineIsGoneBeforeMistakesAreNamed() throws Exception {
        Shell shell = Shell.run(folder, "mkfifo pipe", begin("pipe"), "exec 3> pipe", await("reading"),
            "echo sphere >&3", "exec 3>&-", "wait $program");
        assertEquals(2, shell.status(), shell + shown());
        assertTrue(shown().matches("(?s).*elapsed *\r +\rpipe:1: sphere: .*"), shown());
    }

    /** A hundred thousand lamps take minutes to light the places; the program is ended once the line has said so. */
    @Test
    void ambientLightAndItsShareAreSaid() throws Exception {
        Files.writeString(folder.resolve("scene.txt"), SCENE + "lgt 3 9 -9  1 1 1  1 1 1\n".repeat(100_000));
        Shell shell = Shell.run(folder, begin("scene.txt"), await("ambient light  [0-9]+ %"), "kill $(cat pid)",
            "wait $program");
        List<String> lines = List.of(shown().split("[\r\n]"));
        assertTrue(lines.stream().anyMatch(line -> line.matches("out\\.png  ambient light  \\d+ %  [\\d:]+ elapsed *")),
            shell + shown());
    }
}
