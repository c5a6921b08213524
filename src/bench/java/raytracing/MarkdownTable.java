package raytracing;

import java.util.List;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import raytracing.numerics.Algorithm;
import raytracing.numerics.Family;
import raytracing.numerics.Shape;

/** A table with a row for every family and a column for every contender: families are the longer list. */
final class MarkdownTable {
    private MarkdownTable() {
    }

    static String of(Shape shape, BiFunction<Algorithm, Family, String> cell) {
        List<Algorithm> algorithms = shape.algorithms();
        return row("", algorithms.stream().map(Algorithm::title).toList())
            + "|---|" + "---:|".repeat(algorithms.size()) + "\n"
            + shape.families().stream()
                .map(family -> row(family.title(),
                    algorithms.stream().map(algorithm -> cell.apply(algorithm, family)).toList()))
                .collect(Collectors.joining());
    }

    private static String row(String head, List<String> cells) {
        return "| " + head + " | " + String.join(" | ", cells) + " |\n";
    }
}
