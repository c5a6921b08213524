package raytracing;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import raytracing.parse.RayTracerException;

/** Writes into SAMPLING.md whether {@code --error} keeps its promises, and how fast, beside grids of rays. */
public final class ErrorReport {
    private static final Path DOCUMENT = Path.of("src", "docs", "SAMPLING.md");
    private static final String CALIBRATION = "errors";
    private static final String SPEED = "times at equal error";

    private ErrorReport() {
    }

    /**
     * Measures and writes, the errors before the times are measured.
     *
     * @param arguments {@code quick} for fewer points and rounds
     */
    public static void main(String[] arguments) throws IOException, RayTracerException {
        boolean isQuick = List.of(arguments).contains("quick");
        Effort effort = isQuick ? Effort.QUICK : Effort.FULL;
        String origin =
            Machine.origin("gradle errors" + (isQuick ? " -Pquick" : "")) + "\n" + ErrorScenes.missing() + "\n";
        MeasuredPart.replace(DOCUMENT, CALIBRATION, origin + ErrorCalibration.section(effort));
        MeasuredPart.replace(DOCUMENT, SPEED, origin + ErrorSpeed.section(effort));
    }
}
