package raytracing;

import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * Commands in a shell, as users type them.
 *
 * @param status exit status of the last
 * @param text what they wrote, to both streams
 */
record Shell(int status, String text) {
    /** Runs commands in a folder, in which {@code $JAVA} and {@code $JAR} stand for the Java at hand and the jar. */
    static Shell run(Path folder, String... commands) throws IOException, InterruptedException {
        Path log = Files.createTempFile("shell", "");
        try {
            return new Shell(Patience.awaitEnd(start(folder, Redirect.to(log.toFile()), commands)), Files.readString(log));
        } finally {
            Files.delete(log);
        }
    }

    /** Begins to run commands, both of whose streams go somewhere. */
    static Process start(Path folder, Redirect output, String... commands) throws IOException {
        ProcessBuilder builder = new ProcessBuilder(List.of("bash", "-c", String.join("\n", commands)))
            .directory(folder.toFile()).redirectErrorStream(true).redirectOutput(output);
        builder.environment().putAll(Map.of("JAR", Program.JAR.toAbsolutePath().toString(),
            "JAVA", Program.JAVA_HOME.resolve("bin/java").toString()));
        builder.environment().remove("JAVA_TOOL_OPTIONS");   // announces itself on standard error
        return builder.start();
    }

    /** Whether all these commands are installed. */
    static boolean has(String... commands) throws IOException, InterruptedException {
        return run(Path.of("."), "type " + String.join(" ", commands)).status() == 0;
    }
}
