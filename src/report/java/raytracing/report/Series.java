package raytracing.report;

import java.util.EnumSet;
import java.util.Set;
import java.util.function.Function;

/** Ways to draw that differ in one number: a line of the plot, and its shape and colour there. */
enum Series {
    SAMPLED("sampled shadows", n -> "N = " + n, Ink.BLUE, Shape.CIRCLE),
    EXACT("exact shadows", n -> "exact", Ink.VERMILION, Shape.DIAMOND),
    ONE_RAY("one ray a pixel", n -> "one ray", Ink.PURPLE, Shape.SQUARE),
    AT_EDGES("n x n rays at edges", n -> "edges, " + n + " x " + n, Ink.VERMILION, Shape.DIAMOND),
    EVERYWHERE("n x n rays everywhere", n -> "everywhere, " + n + " x " + n, Ink.BLUE, Shape.CIRCLE),
    ERROR_LIMIT("rays as an error E needs", e -> "E = " + e, Ink.GREEN, Shape.TRIANGLE);

    /** Those whose first settings lie next to each other. */
    static final Set<Series> AFTER_ONE_RAY = EnumSet.of(AT_EDGES, EVERYWHERE);

    private final String title;
    private final Function<String, String> settingTitle;
    private final Ink ink;
    private final Shape shape;

    /** Told apart also by those who see no colours. */
    enum Shape {
        CIRCLE, DIAMOND, SQUARE, TRIANGLE
    }

    Series(String title, Function<String, String> settingTitle, Ink ink, Shape shape) {
        this.title = title;
        this.settingTitle = settingTitle;
        this.ink = ink;
        this.shape = shape;
    }

    String title() {
        return title;
    }

    String settingTitle(double number) {
        return settingTitle.apply(Shown.plain(number));
    }

    Ink ink() {
        return ink;
    }

    Shape shape() {
        return shape;
    }
}
