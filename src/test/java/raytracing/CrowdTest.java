package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Many programs at once, as on the night before a course's deadline. */
class CrowdTest {
    private static final int PROGRAMS = 64;

    @TempDir
    private Path folder;

    /** Half of them draw the same file. */
    @Test
    void sixtyFourProgramsDoNotDisturbEachOther() throws Exception {
        String scene = Path.of("scenes/boxes.txt").toAbsolutePath().toString();
        assertEquals(0, Program.run(folder, scene, "expected.png", "40", "40").status());
        List<Process> processes = new ArrayList<>();
        for (int i = 0; i < PROGRAMS; i++) {
            Path log = folder.resolve(i + ".log");
            processes.add(Program.start(Program.JAVA_HOME, List.of("-Xmx32m"), folder, log, log,
                scene, i % 2 == 0 ? "same.png" : i + ".png", "40", "40", "--quiet"));
        }
        for (int i = 0; i < PROGRAMS; i++) {
            assertEquals(0, processes.get(i).waitFor(), Files.readString(folder.resolve(i + ".log")));
            String name = i % 2 == 0 ? "same.png" : i + ".png";
            assertEquals(-1, Files.mismatch(folder.resolve("expected.png"), folder.resolve(name)));
        }
        assertEquals(List.of(), Folders.names(folder).stream().filter(name -> name.startsWith(".")).toList());
    }
}
