package raytracing;

import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import raytracing.timed.ProcessCost;

/**
 * Runs whole processes and says what they took. Processor time and memory come from GNU time, which asks the system
 * after the process has ended; Java cannot, and to watch a process while it runs is to miss its end.
 */
public final class MeasuredProcess {
    private static final double NANOSECONDS = 1e9;
    static final Path JAR = Path.of("build", "libs", "RayTracer.jar");
    private static final Path JAVA = Path.of(System.getProperty("java.home"), "bin", "java");
    private static final boolean GNU_TIME = isGnuTimeThere();

    private MeasuredProcess() {
    }

    /** What cannot be measured here, and how to change that; nothing if all can. */
    static String missing() {
        return GNU_TIME ? "" : "Processor time and memory of processes are missing, as GNU time is: "
            + "`apt-get install -y time`.\n";
    }

    private static boolean isGnuTimeThere() {
        try {
            Path report = Files.createTempFile("time", "");
            try {
                return status(timed(report, List.of("true"))) == 0;
            } finally {
                Files.delete(report);
            }
        } catch (IOException noSuchProgram) {
            return false;
        }
    }

    private static List<String> timed(Path report, List<String> command) {
        List<String> time = List.of("time", "-o", report.toString(), "-f", ProcessCost.TIME_FORMAT);
        return Stream.concat(time.stream(), command.stream()).toList();
    }

    /** The command that runs a virtual machine like this one. */
    static List<String> java(String... arguments) {
        return Stream.concat(Stream.of(JAVA.toString()), Stream.of(arguments)).toList();
    }

    /** The command that runs the program. */
    static List<String> program(String... arguments) {
        return Stream.concat(java("-jar", JAR.toString()).stream(), Stream.of(arguments)).toList();
    }

    /** Runs a command to its end, which must be a good one. */
    public static ProcessCost run(List<String> command) throws IOException {
        Path report = Files.createTempFile("time", "");
        try {
            long start = System.nanoTime();
            int status = status(GNU_TIME ? timed(report, command) : command);
            double seconds = (System.nanoTime() - start) / NANOSECONDS;
            if (status != 0) {
                throw new IOException("exit status " + status + ": " + String.join(" ", command));
            }
            return GNU_TIME ? ProcessCost.of(seconds, Files.readString(report)) : ProcessCost.of(seconds);
        } finally {
            Files.delete(report);
        }
    }

    /** Deletes a folder of files that processes left. */
    public static void delete(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.toList()) {
                Files.delete(file);
            }
        }
        Files.delete(folder);
    }

    private static int status(List<String> command) throws IOException {
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(Redirect.DISCARD);
        builder.environment().remove("JAVA_TOOL_OPTIONS");   // would measure another Java than users run
        try {
            return builder.start().waitFor();
        } catch (InterruptedException request) {
            throw new IOException("interrupted: " + String.join(" ", command), request);
        }
    }
}
