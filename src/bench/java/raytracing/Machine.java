package raytracing;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.OptionalDouble;
import java.util.stream.Stream;

/** Where a figure was measured. */
public final class Machine {
    private static final Path LINUX_PROCESSORS = Path.of("/proc/cpuinfo");

    private Machine() {
    }

    public static String facts() throws IOException {
        return Runtime.getRuntime().availableProcessors() + " processors (" + processor() + "), "
            + System.getProperty("os.name") + "; " + System.getProperty("java.vm.name") + " "
            + System.getProperty("java.runtime.version") + "; commit " + commit() + ".";
    }

    /** How much work all programs gave it in the last minute, in processors; nothing where the system does not say. */
    public static OptionalDouble load() {
        double load = ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
        return load < 0 ? OptionalDouble.empty() : OptionalDouble.of(load);
    }

    /** Which command measured, where, and with which sources: the sentences that stand before its figures. */
    public static String origin(String command) throws IOException {
        return "`" + command + "` wrote this part. " + facts() + "\nDate of the commit: " + commitDate() + ".";
    }

    private static String processor() throws IOException {
        if (!Files.exists(LINUX_PROCESSORS)) {
            return System.getProperty("os.arch");
        }
        try (Stream<String> lines = Files.lines(LINUX_PROCESSORS)) {
            return lines.filter(line -> line.startsWith("model name")).map(line -> line.split(":\\s*", 2)[1])
                .findFirst().orElse(System.getProperty("os.arch"));
        }
    }

    /** Says so if the sources are not exactly those of the commit. */
    private static String commit() {
        String commit = output("git", "rev-parse", "--short", "HEAD");
        String changes = output("git", "status", "--porcelain", "--",
            "src/main", "src/test", "src/bench", "src/report");
        return commit.isEmpty() ? "unknown" : commit + (changes.isEmpty() ? "" : " with changes");
    }

    /** Year, month and day of the commit. */
    public static String commitDate() {
        String date = output("git", "log", "-1", "--format=%cs");
        return date.isEmpty() ? "unknown" : date;
    }

    /** What a command says; nothing if there is no such program. */
    private static String output(String... command) {
        try {
            Process process = new ProcessBuilder(command).start();
            return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip();
        } catch (IOException noSuchProgram) {
            return "";
        }
    }
}
