package raytracing;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The program with its window on a screen, and a {@link PreviewUser} who uses it. */
final class WatchedProgram implements AutoCloseable {
    private final Process process;
    private final Writer orders;
    private final BufferedReader answers;
    private final Path errors;

    private WatchedProgram(Process process, Path errors) {
        this.process = process;
        this.errors = errors;
        orders = process.outputWriter(StandardCharsets.UTF_8);
        answers = process.inputReader(StandardCharsets.UTF_8);
    }

    static WatchedProgram start(VirtualScreen screen, List<String> javaOptions, Path folder, String... arguments)
            throws IOException {
        List<String> command = new ArrayList<>(List.of(Program.JAVA_HOME.resolve("bin/java").toString()));
        command.addAll(javaOptions);
        command.addAll(List.of("-cp", Program.JAR.toAbsolutePath() + ":" + testClasses(), PreviewUser.class.getName()));
        command.addAll(List.of(arguments));
        Path errors = folder.resolve("errors");
        ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile()).redirectError(errors.toFile());
        builder.environment().remove("JAVA_TOOL_OPTIONS");
        builder.environment().put("DISPLAY", screen.name());
        return new WatchedProgram(builder.start(), errors);
    }

    private static Path testClasses() {
        return Path.of(PreviewUser.class.getProtectionDomain().getCodeSource().getLocation().getPath());
    }

    /** Has the user do something that may end the program, which then gives no answer. */
    void order(String order) throws IOException {
        orders.write(order + "\n");
        orders.flush();
    }

    /** Has the user do something, once there is a window, and awaits that. */
    String tell(String order) throws IOException {
        order(order);
        StringBuilder answer = new StringBuilder();
        for (String line = answers.readLine(); !"done".equals(line); line = answers.readLine()) {
            if (line == null) {
                throw new AssertionError(order + ": no answer. " + errors());
            }
            answer.append(line);
        }
        return answer.toString();
    }

    String errors() throws IOException {
        return Files.readString(errors);
    }

    /** Its exit status. */
    int await() throws InterruptedException {
        return Patience.awaitEnd(process);
    }

    boolean isRunning() {
        return process.isAlive();
    }

    @Override
    public void close() {
        process.destroyForcibly();
    }
}
