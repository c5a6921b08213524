package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** If Java or the jar lacks something, the program prints sentences and never a stack trace. */
class BrokenJavaTest {
    private static final String SCENE = "cam 0 0 -5 0 0 0 0 1 0 1 1\nset 0.25 0.5 1 1 1\n";

    @TempDir
    private Path folder;

    @BeforeEach
    void writeScene() throws Exception {
        Files.writeString(folder.resolve("scene.txt"), SCENE);
    }

    /** With fewer, Java 17 ends with its own message before it starts the program. */
    @ParameterizedTest
    @ValueSource(ints = {6, 7, 8, 10, 16})
    void fewFileHandlesAreEnoughOrSaid(int handles) throws Exception {
        Shell shell = Shell.run(folder, "ulimit -n " + handles, "\"$JAVA\" -jar \"$JAR\" scene.txt out.png 8 4 --quiet");
        if (shell.status() != 0) {
            assertEquals(new Shell(1, "the system allows too few open files; after ulimit -n 64 there are enough\n"), shell);
        }
    }

    private Program runWithoutPictures(String output) throws Exception {
        return Program.run(Program.JAVA_HOME, List.of("--limit-modules", "java.base"), folder,
            "scene.txt", output, "8", "4", "--quiet");
    }

    @ParameterizedTest
    @ValueSource(strings = {"jpg", "gif"})
    void aJavaWithoutPicturesIsSaid(String ending) throws Exception {
        assertEquals(new Program(1, "", "this Java has no java.desktop, which jpg, gif, windows and --compare need; "
            + "a whole Java runtime has it" + System.lineSeparator()), runWithoutPictures("out." + ending));
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "bmp"})
    void aJavaWithoutPicturesIsEnoughForPicturesWithoutLoss(String ending) throws Exception {
        assertEquals(new Program(0, "", ""), runWithoutPictures("out." + ending));
        assertTrue(Files.exists(folder.resolve("out." + ending)));
    }

    /** All zeros instead of what is not loaded yet, while the program waits for its scene. */
    @Test
    void aJarThatIsOverwrittenWhileItRunsIsSaid() throws Exception {
        Shell shell = Shell.run(folder, "cp \"$JAR\" own.jar", "mkfifo scene",
            "\"$JAVA\" -jar own.jar scene out.png 8 4 --quiet & program=$!",
            "exec 3> scene", "head -c $(stat -c %s own.jar) /dev/zero > own.jar", "cat scene.txt >&3", "exec 3>&-",
            "wait $program");
        assertTrue(shell.text().matches("a part of Java or of the program cannot be loaded \\(.*\\); "
            + "if none was replaced now, install both again\n"), shell.text());
        assertEquals(1, shell.status());
        assertFalse(Files.exists(folder.resolve("out.png")));
    }

    @Test
    void aThreadThatFailsBesideTheDrawingIsSaid() throws Exception {
        Shell shell = Shell.run(folder, "mkfifo scene", "\"$JAVA\" -cp \"$JAR:" + classes() + "\" "
            + LostThread.class.getName() + " scene out.png 8 4 --quiet");
        assertEquals(new Shell(0, "out.png: drawing goes on without its thread lost (java.lang.IllegalStateException: "
            + "as expected)\n"), shell);
        assertTrue(Files.exists(folder.resolve("out.png")));
    }

    private static Path classes() {
        return Path.of(LostThread.class.getProtectionDomain().getCodeSource().getLocation().getPath());
    }
}
