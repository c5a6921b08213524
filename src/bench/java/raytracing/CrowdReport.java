package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import raytracing.timed.ProcessCost;

/** Writes into PERFORMANCE.md what scenes with very many of one thing take, and how that grows with their number. */
public final class CrowdReport {
    private static final Path DOCUMENT = Path.of("src", "docs", "PERFORMANCE.md");
    private static final String PART = "crowds";
    private static final String BEFORE = "before=";
    private static final String ONLY = "only=";
    private static final int SIZE = 200;
    private static final String NONE = "-";

    /** A process that takes longer is ended, and has no figures. */
    private static final int MOST_SECONDS = 120;

    private final Optional<Path> before;
    private final List<String> names;
    private final Path folder;

    private CrowdReport(List<String> arguments, Path folder) {
        before = value(arguments, BEFORE).map(Path::of);
        names = value(arguments, ONLY).map(list -> List.of(list.toUpperCase(Locale.ROOT).split(","))).orElse(List.of());
        this.folder = folder;
    }

    /**
     * Measures and writes.
     *
     * @param arguments any of: {@code before=FILE}, the jar of an older version, to be measured in turn with the present one;
     *        {@code only=NAME,NAME} for some of the scenes, by their names in {@link CrowdedScene}; this prints the table
     */
    public static void main(String[] arguments) throws IOException {
        Path folder = Files.createTempDirectory("crowds");
        try {
            CrowdReport report = new CrowdReport(List.of(arguments), folder);
            String measured = report.measured();
            if (report.names.isEmpty()) {
                MeasuredPart.replace(DOCUMENT, PART, measured);
            } else {
                System.out.println(measured);
            }
        } finally {
            MeasuredProcess.delete(folder);
        }
    }

    private static Optional<String> value(List<String> arguments, String name) {
        return arguments.stream().filter(argument -> argument.startsWith(name)).findFirst()
            .map(argument -> argument.substring(name.length()));
    }

    private String measured() throws IOException {
        List<List<String>> rows = new ArrayList<>();
        for (CrowdedScene scene : CrowdedScene.values()) {
            if (names.isEmpty() || names.contains(scene.name())) {
                rows.add(row(scene));
                System.out.println(rows.get(rows.size() - 1));
            }
        }
        return "\n" + Machine.origin("gradle crowds") + "\nPictures of " + SIZE + " x " + SIZE + " pixels, one process each"
            + before.map(jar -> "; before: " + jar.getFileName()).orElse("")
            + ". No figures: it failed, or took more than " + MOST_SECONDS
            + " s.\n" + MeasuredProcess.missing() + "\n"
            + MarkdownTable.of(List.of("scene", "things", "before, s", "before, CPU s", "before, MiB", "now, s", "now, CPU s",
                "now, MiB", "half as many, CPU s", "things grow by", "CPU time grows by"), rows).strip();
    }

    private List<String> row(CrowdedScene scene) throws IOException {
        Path file = file(scene, scene.count());
        Optional<ProcessCost> older = before.isPresent() ? cost(before.get(), scene, file) : Optional.empty();
        Optional<ProcessCost> now = cost(MeasuredProcess.JAR, scene, file);
        Optional<ProcessCost> half = cost(MeasuredProcess.JAR, scene, file(scene, scene.half()));
        return Stream.of(
            Stream.of(scene.title(), String.format(Locale.ROOT, "%,d", scene.count())), cells(older), cells(now),
            Stream.of(shown(half.map(ProcessCost::cpuSeconds), "%.1f"),
                String.format(Locale.ROOT, "%.2f", (double) scene.count() / scene.half()),
                now.isPresent() && half.isPresent()
                    ? shown(Optional.of(ratio(now.get().cpuSeconds(), half.get().cpuSeconds())), "%.2f") : NONE))
            .flatMap(cells -> cells).toList();
    }

    private static Stream<String> cells(Optional<ProcessCost> cost) {
        return Stream.of(cost.map(known -> String.format(Locale.ROOT, "%.1f", known.wallSeconds())).orElse(NONE),
            shown(cost.map(ProcessCost::cpuSeconds), "%.1f"), shown(cost.map(ProcessCost::peakMebibytes), "%.0f"));
    }

    private static OptionalDouble ratio(OptionalDouble one, OptionalDouble other) {
        return one.isPresent() && other.isPresent() ? OptionalDouble.of(one.getAsDouble() / other.getAsDouble())
            : OptionalDouble.empty();
    }

    private static String shown(Optional<OptionalDouble> figure, String format) {
        return figure.isPresent() && figure.get().isPresent()
            ? String.format(Locale.ROOT, format, figure.get().getAsDouble()) : NONE;
    }

    private Path file(CrowdedScene scene, int things) throws IOException {
        return Files.writeString(folder.resolve(scene.name() + things + ".txt"), scene.text(things));
    }

    /** What a whole process takes; nothing if it fails, as with too little memory, or does not end soon. */
    private Optional<ProcessCost> cost(Path jar, CrowdedScene scene, Path file) throws IOException {
        List<String> command = new ArrayList<>(List.of("timeout", String.valueOf(MOST_SECONDS)));
        command.addAll(MeasuredProcess.java());
        command.addAll(scene.javaOptions());
        command.addAll(List.of("-jar", jar.toString(), file.toString(), folder.resolve("crowd.png").toString(),
            String.valueOf(SIZE), String.valueOf(SIZE)));
        command.addAll(scene.programOptions());
        try {
            return Optional.of(MeasuredProcess.run(command));
        } catch (IOException failed) {
            System.out.println(failed.getMessage());
            return Optional.empty();
        }
    }
}
