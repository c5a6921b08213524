package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import raytracing.parse.RayTracerException;

/** Writes into AMBIENT.md what estimates of ambient light are worth. */
public final class AmbientReport {
    private static final Path DOCUMENT = Path.of("src", "docs", "AMBIENT.md");

    private AmbientReport() {
    }

    /**
     * Measures and writes.
     *
     * @param arguments {@code quick} for fewer rays and runs
     */
    public static void main(String[] arguments) throws IOException, RayTracerException {
        boolean isQuick = List.of(arguments).contains("quick");
        Effort effort = isQuick ? Effort.QUICK : Effort.FULL;
        Path folder = Files.createTempDirectory("ambient");
        try {
            String origin = Machine.origin("gradle ambient" + (isQuick ? " -Pquick" : "")) + " " + AmbientRoom.missing();
            MeasuredPart.replace(DOCUMENT, origin + "\n### Pictures\n\n" + AmbientErrors.pictures(effort)
                + "\n### Refinement\n\n" + AmbientErrors.refinement(effort)
                + "\n### Errors\n\n" + AmbientErrors.section(effort)
                + "\n### Times\n\n" + AmbientTimes.section(effort, folder));
        } finally {
            MeasuredProcess.delete(folder);
        }
    }
}
