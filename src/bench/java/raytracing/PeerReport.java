package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import raytracing.parse.RayTracerException;

/** Writes into PERFORMANCE.md how fast we are beside POV-Ray on this machine, and the error that the time bought. */
public final class PeerReport {
    private static final Path DOCUMENT = Path.of("src", "docs", "PERFORMANCE.md");
    private static final String QUICK = "quick";
    private static final String ERRORS = "errors";
    private static final String ONLY = "only=";

    private final List<String> arguments;
    private final Effort effort;
    private final Optional<PovRay> povRay = PovRay.installed();

    private PeerReport(List<String> arguments) {
        this.arguments = arguments;
        effort = arguments.contains(QUICK) ? Effort.QUICK : Effort.FULL;
    }

    /**
     * Measures and writes.
     *
     * @param arguments any of: {@code quick} for fewer runs and no errors, {@code errors} for errors all the same,
     *        {@code only=NAME,NAME} for some of the scenes, by their names in {@link TimedScene}
     */
    public static void main(String[] arguments) throws IOException, RayTracerException {
        PeerReport report = new PeerReport(List.of(arguments));
        Path folder = Files.createTempDirectory("peers");
        try {
            MeasuredPart.replace(DOCUMENT, report.measured(folder));
        } finally {
            MeasuredProcess.delete(folder);
        }
    }

    private String measured(Path folder) throws IOException, RayTracerException {
        ColdTimes cold = ColdTimes.measured(chosen(ColdTimes.SCENES), effort, povRay, folder);
        WarmTimes warm = WarmTimes.measured(chosen(WarmTimes.SCENES), effort);
        return heading() + coldSection(cold) + warmSection(warm, cold) + errorSection();
    }

    private String heading() throws IOException {
        return Machine.origin(command()) + " " + povRay.map(PovRay::version).orElse("No POV-Ray") + ".\n"
            + (povRay.isPresent() ? "" : PovRay.MISSING) + MeasuredProcess.missing() + TimedScene.missing(asked());
    }

    private String command() {
        return "gradle peers" + String.join("",
            arguments.stream().map(argument -> " -P" + argument).toList());
    }

    private String coldSection(ColdTimes cold) {
        return "\n### Whole processes, cold\n\n"
            + effort.pairs() + " pairs: ours, POV-Ray, ours, POV-Ray, and so on. Median (least - most); "
            + "a ratio is POV-Ray's wall time over ours.\n\n" + cold.table();
    }

    private String warmSection(WarmTimes warm, ColdTimes cold) {
        return "\n### Warm, in one process\n\n"
            + effort.warmWords() + " at least of warm-up; "
            + effort.frames() + " builds. Median (least - most); "
            + "processor time: mean of the frames. POV-Ray's is that of the table above.\n\n"
            + warm.table(cold)
            + warm.growth(TimedScene.FLAKE_7381, TimedScene.FLAKE_597871)
            + warm.growth(TimedScene.FLAKE_7381_SOFT, TimedScene.FLAKE_597871_SOFT);
    }

    private String errorSection() throws IOException, RayTracerException {
        if (effort == Effort.QUICK && !arguments.contains(ERRORS)) {
            return "";
        }
        int size = SamplingErrors.SIZE;
        return "\n### The error that the time bought\n\n"
            + "Pictures of " + size + " x " + size + " pixels, 8 bits, against the same scene with "
            + SamplingErrors.FACTOR + " N and another seed, in steps of 1/255.\n"
            + "Scenes with N = 1 have hard shadows, and no error of this kind.\n\n"
            + SamplingErrors.table(chosen(ColdTimes.SCENES));
    }

    /** All scenes that this run is about, also the missing ones. */
    private List<TimedScene> asked() {
        Optional<String> only = arguments.stream().filter(argument -> argument.startsWith(ONLY)).findFirst();
        return only.map(list -> Stream.of(list.substring(ONLY.length()).split(",")).map(PeerReport::scene).toList())
            .orElse(ColdTimes.SCENES);
    }

    private static TimedScene scene(String name) {
        return TimedScene.named(name).orElseThrow(() -> new IllegalArgumentException(
            "no scene " + name + ", expected some of " + List.of(TimedScene.values())));
    }

    private List<TimedScene> chosen(List<TimedScene> scenes) {
        List<TimedScene> asked = asked();
        return scenes.stream().filter(TimedScene::isThere).filter(asked::contains).toList();
    }
}
