package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import raytracing.parse.RayTracerException;

/** Writes into SAMPLING.md how exact shadows and smooth edges compare with many rays. */
public final class SamplingReport {
    private static final Path DOCUMENT = Path.of("src", "docs", "SAMPLING.md");

    private SamplingReport() {
    }

    /**
     * Measures and writes.
     *
     * @param arguments {@code quick} for fewer questions, runs and scenes
     */
    public static void main(String[] arguments) throws IOException, RayTracerException {
        boolean isQuick = List.of(arguments).contains("quick");
        Effort effort = isQuick ? Effort.QUICK : Effort.FULL;
        Path folder = Files.createTempDirectory("sampling");
        try {
            MeasuredPart.replace(DOCUMENT, Machine.origin("gradle sampling" + (isQuick ? " -Pquick" : "")) + " "
                + TimedScene.missing(ShadowPictures.SCENES) + MeasuredProcess.missing()
                + "\n### Exact shadows against the limit of sampling\n\n" + ShadowLimits.section(effort)
                + "\n### Exact shadows in whole pictures\n\n" + ShadowPictures.section(effort, folder)
                + "\n### Which pixels are on an edge\n\n" + EdgeRules.section(effort));
        } finally {
            MeasuredProcess.delete(folder);
        }
    }
}
