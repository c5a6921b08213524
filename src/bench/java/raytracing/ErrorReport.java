package raytracing;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import raytracing.parse.RayTracerException;

/** Writes into SAMPLING.md whether {@code --error} keeps its promises, and how fast, beside grids of rays. */
public final class ErrorReport {
    private static final Path DOCUMENT = Path.of("src", "docs", "SAMPLING.md");
    private static final String CALIBRATION = "errors";
    private static final String SPEED = "times at equal error";
    private static final String ONLY = "only=";

    private ErrorReport() {
    }

    /**
     * Measures and writes, the errors before the times are measured.
     *
     * @param arguments {@code quick} for fewer points and rounds; {@code only=} and names of scenes, with commas, for the
     *        times of these scenes and nothing else
     */
    public static void main(String[] arguments) throws IOException, RayTracerException {
        boolean isQuick = List.of(arguments).contains("quick");
        Optional<String> only = Stream.of(arguments).filter(word -> word.startsWith(ONLY)).findFirst();
        Effort effort = isQuick ? Effort.QUICK : Effort.FULL;
        String command = "gradle errors" + (isQuick ? " -Pquick" : "") + only.map(names -> " -P" + names).orElse("");
        String origin = Machine.origin(command) + "\n" + ErrorScenes.missing() + "\n";
        if (only.isEmpty()) {
            MeasuredPart.replace(DOCUMENT, CALIBRATION, origin + ErrorCalibration.section(effort));
        }
        List<String> names = only.map(word -> List.of(word.substring(ONLY.length()).split(","))).orElse(List.of());
        MeasuredPart.replace(DOCUMENT, SPEED, origin + ErrorSpeed.section(effort, names));
    }
}
