package raytracing;

import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;

/**
 * The program on a terminal of its own, where its line of progress says how far it is. {@code script} makes the terminal and
 * keeps what it shows.
 */
final class TerminalProgram implements AutoCloseable {
    /** Files that are left in the folder in which it runs. */
    static final List<String> FILES = List.of("pid", "shown");

    private final Process script;
    private final Path folder;

    private TerminalProgram(Process script, Path folder) {
        this.script = script;
        this.folder = folder;
    }

    /** Starts it in a folder, by a command that runs the one behind it ({@code env}, for example). */
    static TerminalProgram start(Path folder, String through, String... arguments) throws IOException, InterruptedException {
        Skipped.unless(Shell.run(folder, "script -qefc true shown").status() == 0,
            "there is no script here, which makes terminals");
        return new TerminalProgram(Shell.start(folder, Redirect.DISCARD, "exec script -qefc 'echo $$ > pid; exec " + through
            + " \"$JAVA\" -jar \"$JAR\" " + String.join(" ", arguments) + "' shown"), folder);
    }

    /** All that the terminal has shown so far, with what was written over. */
    String shown() throws IOException {
        return Files.readString(folder.resolve("shown"));
    }

    /** Waits until the terminal has shown something. */
    void awaitShown(String regex) throws IOException, InterruptedException {
        Pattern pattern = Pattern.compile(regex);
        Patience.await(regex + " on the terminal", () -> {
            boolean isRunning = script.isAlive();
            boolean isShown = pattern.matcher(shown()).find();
            if (!isShown && !isRunning) {
                throw new AssertionError("ended without " + regex + " on the terminal: " + shown());
            }
            return isShown;
        });
    }

    /** Sends the program a signal. */
    void signal(String name) throws IOException, InterruptedException {
        Shell.run(folder, "kill -" + name + " $(cat pid)");
    }

    /** Its exit status. */
    int awaitEnd() throws InterruptedException {
        return Patience.awaitEnd(script);
    }

    @Override
    public void close() {
        script.descendants().forEach(ProcessHandle::destroyForcibly);
        script.destroyForcibly();
    }
}
