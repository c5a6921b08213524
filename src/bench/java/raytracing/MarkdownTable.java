package raytracing;

import java.util.List;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import raytracing.numerics.Algorithm;
import raytracing.numerics.Family;
import raytracing.numerics.Shape;

/** Tables of figures. */
public final class MarkdownTable {
    private MarkdownTable() {
    }

    /** The first column has the names of the rows. */
    public static String of(List<String> heads, List<List<String>> rows) {
        List<String> columns = heads.subList(1, heads.size());
        return row(heads.get(0), columns)
            + "|---|" + "---:|".repeat(columns.size()) + "\n"
            + rows.stream().map(cells -> row(cells.get(0), cells.subList(1, cells.size())))
                .collect(Collectors.joining());
    }

    /** A row for every family and a column for every contender: families are the longer list. */
    static String of(Shape shape, BiFunction<Algorithm, Family, String> cell) {
        List<Algorithm> algorithms = shape.algorithms();
        return of(Stream.concat(Stream.of(""), algorithms.stream().map(Algorithm::title)).toList(),
            shape.families().stream()
                .map(family -> Stream.concat(Stream.of(family.title()),
                    algorithms.stream().map(algorithm -> cell.apply(algorithm, family))).toList())
                .toList());
    }

    private static String row(String head, List<String> cells) {
        return "| " + head + " | " + String.join(" | ", cells) + " |\n";
    }
}
