package raytracing.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import raytracing.MeasuredProcess;
import raytracing.RayTracer;
import raytracing.timed.ProcessCost;
import raytracing.timed.Spread;

/** Whole processes of the jar, as users wait for them: start, reading, drawing with code that is not compiled yet. */
final class ColdRuns {
    private static final Path JAR = Path.of("build", "libs", "RayTracer.jar");
    private static final Path JAVA = Path.of(System.getProperty("java.home"), "bin", "java");

    /** The scene's own settings, and those that a user would choose instead. */
    private static final List<List<String>> OPTIONS = Stream.concat(Stream.of(List.<String>of()),
        Stream.of(Setting.exact(), Setting.atEdges(4), Setting.errorLimit(1))
            .flatMap(setting -> setting.options().stream())).toList();

    private ColdRuns() {
    }

    /**
     * What one command took.
     *
     * @param options those of its command line that ask for the setting, with spaces between; may be none
     * @param seconds from the start of a process to its end
     */
    record Row(String options, Spread seconds) {
    }

    /** A row for each list of options; the processes run in turn. */
    static List<Row> measured(Path scene, Budget budget, Progress progress) throws IOException {
        List<List<Double>> seconds = new ArrayList<>();
        OPTIONS.forEach(options -> seconds.add(new ArrayList<>()));
        Path picture = Files.createTempFile("cold", ".png");
        try {
            for (int run = 0; run < budget.processes(); run++) {
                progress.in("Cold processes").say("run " + (run + 1));
                for (int i = 0; i < OPTIONS.size(); i++) {
                    ProcessCost cost = MeasuredProcess.run(command(scene, picture, budget.size(), OPTIONS.get(i)));
                    seconds.get(i).add(cost.wallSeconds());
                }
            }
        } finally {
            Files.delete(picture);
        }
        List<Row> rows = new ArrayList<>();
        for (int i = 0; i < OPTIONS.size(); i++) {
            rows.add(new Row(String.join(" ", OPTIONS.get(i)), Spread.of(seconds.get(i)).orElseThrow()));
        }
        return rows;
    }

    private static List<String> command(Path scene, Path picture, int size, List<String> options) {
        List<String> command = new ArrayList<>(List.of(JAVA.toString(), "-jar", JAR.toString(), scene.toString(),
            picture.toString(), String.valueOf(size), String.valueOf(size)));
        command.addAll(options);
        return command;
    }
}
