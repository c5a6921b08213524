package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import raytracing.parse.RayTracerException;

/**
 * Writes into TRUST.md what killed programs leave, how soon the program stops, and how well it knows when it will be done.
 * Fails where a promise is broken.
 */
public final class TrustReport {
    private static final Path DOCUMENT = Path.of("src", "docs", "TRUST.md");
    private static final int PROGRAMS_KILLED = 100;
    private static final int PROGRAMS_AT_ONCE = 64;

    private TrustReport() {
    }

    /**
     * Measures and writes.
     *
     * @param arguments {@code quick} for fewer runs
     */
    public static void main(String[] arguments) throws IOException, InterruptedException, RayTracerException {
        boolean isQuick = List.of(arguments).contains("quick");
        Path folder = Files.createTempDirectory("trust");
        try {
            MeasuredPart.replace(DOCUMENT, Machine.origin("gradle trust" + (isQuick ? " -Pquick" : "")) + "\n"
                + "\n### Killed, and in a crowd\n\n" + kills(folder) + crowd(folder)
                + "\n### From a signal to the end, milliseconds\n\n" + StopTimes.section(isQuick ? 5 : 25, folder)
                + "\n### The time that is foreseen over the time it took\n\n" + Forecasts.section(isQuick ? 1 : 5));
        } finally {
            MeasuredProcess.delete(folder);
        }
    }

    private static String kills(Path folder) throws IOException, InterruptedException {
        Kills kills = Kills.of(folder, PROGRAMS_KILLED);
        return "Of " + kills.count() + " programs, half of them ended by SIGTERM and half by SIGKILL, " + kills.older()
            + " left the older\nfile and " + kills.newer() + " the new one, each with all its bytes. In " + kills.withoutJava()
            + " of them the signal came while Java itself\nstarted, which then ended with its own message.\n";
    }

    private static String crowd(Path folder) throws IOException, InterruptedException {
        Crowd.draw(folder, PROGRAMS_AT_ONCE);
        return "\n" + PROGRAMS_AT_ONCE + " programs at once, half of them for the same file: each found its picture there.\n";
    }
}
