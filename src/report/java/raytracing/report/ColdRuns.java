package raytracing.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import raytracing.MeasuredProcess;
import raytracing.command.CommandLine;
import raytracing.timed.ProcessCost;
import raytracing.timed.Spread;

/** Whole processes of the jar, as users wait for them: start, reading, drawing with code that is not compiled yet. */
final class ColdRuns {
    private static final Path JAR = Path.of("build", "libs", "RayTracer.jar");
    private static final Path JAVA = Path.of(System.getProperty("java.home"), "bin", "java");

    private ColdRuns() {
    }

    /**
     * What one command took.
     *
     * @param options those of its command line that ask for the setting, with spaces between; may be none
     * @param seconds from the start of a process to its end; nothing where the program has no such option
     */
    record Row(String options, Optional<Spread> seconds) {
    }

    /** The scene's own settings, and those that a user would choose instead. */
    private static List<List<String>> optionLists() {
        return Stream.concat(Stream.of(List.<String>of()),
            Stream.of(Setting.exact(), Setting.atEdges(4))
                .flatMap(setting -> setting.options().stream())).toList();
    }

    /** A row for each list of options; the processes run in turn. */
    static List<Row> measured(Path scene, Budget budget, Progress progress) throws IOException {
        List<List<String>> known = optionLists().stream().filter(ColdRuns::isKnown).toList();
        List<List<Double>> seconds = new ArrayList<>();
        known.forEach(options -> seconds.add(new ArrayList<>()));
        Path picture = Files.createTempFile("cold", ".png");
        try {
            for (int run = 0; run < budget.processes(); run++) {
                progress.in("Cold processes").say("run " + (run + 1));
                for (int i = 0; i < known.size(); i++) {
                    ProcessCost cost = MeasuredProcess.run(command(scene, picture, budget.size(), known.get(i)));
                    seconds.get(i).add(cost.wallSeconds());
                }
            }
        } finally {
            Files.delete(picture);
        }
        return optionLists().stream().map(options -> new Row(String.join(" ", options), known.contains(options)
            ? Spread.of(seconds.get(known.indexOf(options))) : Optional.empty())).toList();
    }

    /** Asked of the text that the program prints about itself: a process that fails is no answer. */
    private static boolean isKnown(List<String> options) {
        return options.stream().filter(word -> word.startsWith("--"))
            .allMatch(word -> CommandLine.HELP.contains(word + " "));
    }

    private static List<String> command(Path scene, Path picture, int size, List<String> options) {
        List<String> command = new ArrayList<>(List.of(JAVA.toString(), "-jar", JAR.toString(), scene.toString(),
            picture.toString(), String.valueOf(size), String.valueOf(size)));
        command.addAll(options);
        return command;
    }
}
