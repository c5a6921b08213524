package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import raytracing.parse.RayTracerException;

/** Writes into TRUST.md how soon the program stops, and how well it knows when it will be done. */
public final class TrustReport {
    private static final Path DOCUMENT = Path.of("src", "docs", "TRUST.md");

    private TrustReport() {
    }

    /**
     * Measures and writes.
     *
     * @param arguments {@code quick} for fewer runs
     */
    public static void main(String[] arguments) throws IOException, RayTracerException {
        boolean isQuick = List.of(arguments).contains("quick");
        Path folder = Files.createTempDirectory("trust");
        try {
            MeasuredPart.replace(DOCUMENT, Machine.origin("gradle trust" + (isQuick ? " -Pquick" : "")) + "\n"
                + "\n### From a signal to the end, milliseconds\n\n" + StopTimes.section(isQuick ? 5 : 25, folder)
                + "\n### The time that is foreseen over the time it took\n\n" + Forecasts.section(isQuick ? 1 : 5));
        } finally {
            MeasuredProcess.delete(folder);
        }
    }
}
