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

/**
 * Writes into NUMERICS.md what every crossing formula gets wrong, and what it costs: the same contenders in both. And what a
 * search finds: order, joints, climbing.
 */
public final class NumericsReport {
    private static final Path DOCUMENT = Path.of("src", "docs", "NUMERICS.md");
    private static final int ROUNDS = 6;
    private static final int QUICK_ROUNDS = 1;

    /** Name of the part of the document that has no times. */
    private static final String SEARCH = "search";

    private NumericsReport() {
    }

    /**
     * Measures and writes.
     *
     * @param arguments nothing, or {@code quick} for a single round of times, or {@code search} for the search alone
     */
    public static void main(String[] arguments) throws IOException, RunnerException {
        List<String> asked = List.of(arguments);
        MeasuredPart.replace(DOCUMENT, SEARCH,
            SearchErrors.report(asked.contains(SEARCH) ? "gradle numerics -Psearch" : "gradle numerics"));
        if (!asked.contains(SEARCH)) {
            boolean quick = asked.contains("quick");
            CrossingTimes times = CrossingTimes.measured(quick ? QUICK_ROUNDS : ROUNDS);
            MeasuredPart.replace(DOCUMENT, report(quick ? "gradle numerics -Pquick" : "gradle numerics", times));
        }
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
