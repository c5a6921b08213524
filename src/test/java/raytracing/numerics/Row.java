package raytracing.numerics;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import raytracing.Shared;
import raytracing.math.Vector;

/**
 * A row of the tables of exact answers, which are not ours to keep here: they lie beside the checkout or are missing.
 * Its numbers are read from the hexadecimal columns, where there is one.
 */
record Row(Shape shape, Map<String, String> columns) {
    /** Skips the test that asks where the tables are missing. */
    static List<Row> of(Shape shape) {
        Shared.require(Shared.NUMERICS);
        try {
            List<String> lines = Files.readAllLines(Shared.NUMERICS.resolve(shape.name().toLowerCase(Locale.ROOT) + ".csv"));
            String[] names = lines.get(0).split(",");
            return lines.stream().skip(1).map(line -> new Row(shape, columns(names, line.split(",", -1)))).toList();
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    private static Map<String, String> columns(String[] names, String[] values) {
        Map<String, String> columns = new HashMap<>();
        for (int i = 0; i < names.length; i++) {
            columns.put(names[i], values[i]);
        }
        return columns;
    }

    String id() {
        return columns.get("id");
    }

    String text(String column) {
        return columns.getOrDefault(column, "");
    }

    /** Whether the table has a value there. */
    boolean has(String column) {
        return !text(column).isEmpty();
    }

    double number(String column) {
        return Double.parseDouble(has(column + "_hex") ? text(column + "_hex") : text(column));
    }

    Vector vector(String prefix) {
        return new Vector(number(prefix + "x"), number(prefix + "y"), number(prefix + "z"));
    }

    Query query() {
        return switch (shape) {
            case SPHERE -> query("c", "r");
            case PLANE -> query("N", "c");
            case BOX -> query("c", "e");
        };
    }

    private Query query(String vectorPrefix, String scalarColumn) {
        return new Query(vector("o"), vector("d"), vector(vectorPrefix), number(scalarColumn));
    }

    boolean isHit() {
        return text("hit").equals("1");
    }

    /** Whether the answer is exactly on a boundary, so that either one is right. */
    boolean isOnBoundary() {
        return number("margin") == 0;
    }

    /** What the table asks for: the first crossing between its limits. */
    ExactAnswer answer() {
        if (!isHit()) {
            return ExactAnswer.NO_CROSSING;
        }
        return new ExactAnswer(number("t"), shape == Shape.PLANE ? number("t") : otherCrossing());
    }

    private double otherCrossing() {
        boolean near = text("root").equals("1");
        if (shape == Shape.SPHERE) {
            return number(near ? "root2" : "root1");
        }
        return number(near ? "t_exit" : "t_enter");
    }

    /** Whether the search starts at 0, as every search of a formula does. */
    boolean startsAtZero() {
        return number("tmin") == 0;
    }

    /** Whether every crossing above 0 counts. */
    boolean isWithoutLimits() {
        return startsAtZero() && number("tmax") == Formula.MISS;
    }

    /** What a formula finds, where the search starts at 0. */
    double found(Formula formula) {
        double first = formula.firstCrossing(query());
        return first < number("tmax") ? first : orMiss(first);
    }

    /** What the product finds: where its first crossing comes too early, the second one. */
    double foundByTheProduct() {
        double found = found(shape.ours().formula());
        if (startsAtZero() || found > number("tmin")) {
            return found;
        }
        double second = ProductAlgorithms.secondCrossing(shape, query(), number("tmin"));
        return second > number("tmin") && second < number("tmax") ? second : orMiss(second);
    }

    /** A crossing beyond the limits is none; what is no number at all must not pass for that. */
    private static double orMiss(double t) {
        return Double.isNaN(t) ? t : Formula.MISS;
    }

    /** Both roots, wherever they are, and the start of the search: what may be reported on a boundary. */
    Stream<Double> boundaryCrossings() {
        return Stream.of("t", "root1", "root2", "t_enter", "t_exit", "tmin").filter(this::has).map(this::number);
    }
}
