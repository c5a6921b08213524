package raytracing.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import raytracing.Machine;
import raytracing.MeasuredPart;
import raytracing.MeasuredProcess;
import raytracing.PovRay;
import raytracing.Steps;
import raytracing.parse.RayTracerException;
import raytracing.render.RenderSettings;
import raytracing.scene.Scene;

/** Draws a scene with all methods of POV-Ray and of ours, and writes the error that each time bought into PERFORMANCE.md. */
public final class PeerCurves {
    private static final Path DOCUMENT = Path.of("src", "docs", "PERFORMANCE.md");
    private static final String PART = "curves";
    private static final Path PICTURES = Path.of("src", "docs", "report");
    private static final Path SCENE = Path.of("scenes", "three_lamps.txt");
    private static final int SIZE = 250;
    private static final int ROUNDS = 5;
    private static final int QUICK_ROUNDS = 3;
    private static final int USER_IS_WRONG = 2;

    private PeerCurves() {
    }

    /**
     * Measures and writes; says so and leaves all as it was where there is no POV-Ray.
     *
     * @param arguments any of: {@code quick} for fewer rounds, {@code size=N}
     */
    public static void main(String[] arguments) throws IOException, RayTracerException {
        Optional<PovRay> povRay = PovRay.installed();
        if (povRay.isEmpty()) {
            System.err.println("The curves of POV-Ray are not measured: " + PovRay.MISSING.strip());
            return;
        }
        try {
            measure(povRay.get(), List.of(arguments));
        } catch (RayTracerException wrong) {
            wrong.messages().forEach(System.err::println);
            System.exit(USER_IS_WRONG);
        }
    }

    private static void measure(PovRay povRay, List<String> arguments) throws IOException, RayTracerException {
        Fonts.check();
        OptionalDouble before = Machine.load();
        int size = Request.size(arguments).orElse(SIZE);
        int rounds = arguments.contains("quick") ? QUICK_ROUNDS : ROUNDS;
        Scene scene = Steps.parseScene(SCENE);
        RenderSettings common = RenderSettings.DEFAULT.withSize(size, size);
        Path folder = Files.createTempDirectory("peers");
        List<PeerStudy> studies = new ArrayList<>();
        try {
            WarmUp.run(scene, common, Progress.of(1, 1, "peers"));
            for (PeerQuestion question : PeerQuestion.values()) {
                Progress progress = Progress.of(question.ordinal() + 1, PeerQuestion.values().length, question.title());
                studies.add(PeerStudy.of(question, new PeerQuestion.Peer(povRay, scene, folder, size), common, rounds,
                    progress));
                progress.end();
            }
        } finally {
            MeasuredProcess.delete(folder);
        }
        String command = "gradle peerCurves"
            + arguments.stream().map(argument -> " -P" + argument).collect(Collectors.joining());
        write(studies, Machine.origin(command) + " " + povRay.version() + ". " + SceneStudy.title(SCENE) + ", " + size
            + " x " + size + " pixels, " + rounds + " rounds in turn. " + MachineLoad.since(before).sentences());
    }

    private static void write(List<PeerStudy> studies, String origin) throws IOException {
        Files.createDirectories(PICTURES);
        StringBuilder text = new StringBuilder(origin + "\n\n");
        for (PeerStudy study : studies) {
            text.append("- ").append(study.sentence()).append('\n');
        }
        for (PeerStudy study : studies) {
            String name = "peers_" + study.question().name().toLowerCase(Locale.ROOT) + ".svg";
            Files.writeString(PICTURES.resolve(name), study.plot().onWhite());
            text.append("\n![").append(study.question().title()).append(": error against processor time](report/")
                .append(name).append(")\n\n").append(study.equalError().markdown()).append('\n')
                .append(study.settings().markdown());
        }
        MeasuredPart.replace(DOCUMENT, PART, text.toString());
        System.err.println("Written: " + DOCUMENT);
    }
}
