package raytracing;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.openjdk.jmh.runner.RunnerException;
import raytracing.numerics.Algorithm;
import raytracing.numerics.Shape;

/** Writes into NUMERICS.md what every crossing formula gets wrong, and what it costs: the same contenders in both. */
public final class NumericsReport {
    private static final Path DOCUMENT = Path.of("src", "docs", "NUMERICS.md");
    private static final int ROUNDS = 6;
    private static final int QUICK_ROUNDS = 1;

    private NumericsReport() {
    }

    /**
     * Measures and writes.
     *
     * @param arguments nothing, or {@code quick} for a single round of times
     */
    public static void main(String[] arguments) throws IOException, RunnerException {
        boolean quick = List.of(arguments).contains("quick");
        CrossingTimes times = CrossingTimes.measured(quick ? QUICK_ROUNDS : ROUNDS);
        String command = quick ? "gradle numerics -Pquick" : "gradle numerics";
        MeasuredPart.replace(DOCUMENT, report(command, times));
    }

    private static String report(String command, CrossingTimes times) throws IOException {
        return "`" + command + "` wrote this part. " + Machine.facts() + "\n\n"
            + CrossingErrors.HOW + "\n\n" + times.how() + "\n"
            + Stream.of(Shape.values()).map(shape -> section(shape, times)).collect(Collectors.joining());
    }

    private static String section(Shape shape, CrossingTimes times) {
        return "\n### " + title(shape) + "\n\n" + contenders(shape)
            + "\n" + CrossingErrors.CAPTION + "\n\n" + MarkdownTable.of(shape, new CrossingErrors(shape)::cell)
            + "\n" + CrossingTimes.CAPTION + "\n\n"
            + MarkdownTable.of(shape, times::cell)
            + "\n" + times.ratio(shape) + "\n";
    }

    private static String title(Shape shape) {
        return shape.name().charAt(0) + shape.name().substring(1).toLowerCase(Locale.ROOT);
    }

    private static String contenders(Shape shape) {
        return shape.algorithms().stream().map(NumericsReport::contender).collect(Collectors.joining());
    }

    private static String contender(Algorithm algorithm) {
        return "- " + algorithm.title() + ": " + algorithm.description() + "\n";
    }
}
