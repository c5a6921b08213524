package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/**
 * Commands in a shell, as users type them.
 *
 * @param status exit status of the last
 * @param text what they wrote, to both streams
 */
record Shell(int status, String text) {
    private static final long MINUTES = 3;

    /** Runs commands in a folder, in which {@code $JAVA} and {@code $JAR} stand for the Java at hand and the jar. */
    static Shell run(Path folder, String... commands) throws IOException, InterruptedException {
        Path log = Files.createTempFile("shell", "");
        try {
            ProcessBuilder builder = new ProcessBuilder(List.of("bash", "-c", String.join("\n", commands)))
                .directory(folder.toFile()).redirectErrorStream(true).redirectOutput(log.toFile());
            builder.environment().putAll(Map.of("JAR", Program.JAR.toAbsolutePath().toString(),
                "JAVA", Program.JAVA_HOME.resolve("bin/java").toString()));
            builder.environment().remove("JAVA_TOOL_OPTIONS");   // announces itself on standard error
            Process process = builder.start();
            if (!process.waitFor(MINUTES, TimeUnit.MINUTES)) {
                process.descendants().forEach(ProcessHandle::destroyForcibly);
                process.destroyForcibly();
                throw new AssertionError("still running after " + MINUTES + " minutes");
            }
            return new Shell(process.exitValue(), Files.readString(log));
        } finally {
            Files.delete(log);
        }
    }

    /** Whether all these commands are installed. */
    static boolean has(String... commands) throws IOException, InterruptedException {
        return run(Path.of("."), "type " + String.join(" ", commands)).status() == 0;
    }
}
