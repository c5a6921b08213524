package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Many programs at once, as on the night before a course's deadline. */
final class Crowd {
    private Crowd() {
    }

    /** Starts many programs that draw one scene, half of them into the same file, and checks the picture of each. */
    static void draw(Path folder, int count) throws IOException, InterruptedException {
        assertDrawn(folder, start(folder, "expected.png", "expected.log"), "expected.png", "expected.log");
        List<Process> programs = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            programs.add(start(folder, picture(i), i + ".log"));
        }
        for (int i = 0; i < count; i++) {
            assertDrawn(folder, programs.get(i), picture(i), i + ".log");
        }
    }

    private static String picture(int program) {
        return program % 2 == 0 ? "same.png" : program + ".png";
    }

    private static Process start(Path folder, String picture, String log) throws IOException {
        String scene = Path.of("scenes/boxes.txt").toAbsolutePath().toString();
        return Program.start(Program.JAVA_HOME, List.of("-Xmx32m"), folder, folder.resolve(log), folder.resolve(log),
            scene, picture, "40", "40", "--quiet");
    }

    /** The others may be at work still. */
    private static void assertDrawn(Path folder, Process program, String picture, String log)
            throws IOException, InterruptedException {
        int status = Patience.awaitEnd(program);
        if (status != 0 || Files.mismatch(folder.resolve("expected.png"), folder.resolve(picture)) >= 0) {
            throw new AssertionError(picture + ": status " + status + ", " + Files.readString(folder.resolve(log)));
        }
    }
}
