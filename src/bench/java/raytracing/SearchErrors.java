package raytracing;

import java.io.IOException;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import raytracing.numerics.Algorithm;
import raytracing.numerics.Climb;
import raytracing.numerics.Encounter;
import raytracing.numerics.Family;
import raytracing.numerics.JointFamily;
import raytracing.numerics.OrderFamily;
import raytracing.numerics.Shape;

/** What a search finds: wrong orders, wrong joints, and the largest errors that climbs reach. Takes no times. */
final class SearchErrors {
    private static final long SEED = 1;
    private static final int ENCOUNTERS = 5_000;
    private static final int CROWDS = 500;
    private static final int CLIMBS = 2_000;
    private static final int STEPS = 1_000;
    private static final String JUDGE = "DOUBLE_DOUBLE";

    private SearchErrors() {
    }

    static String report(String command) throws IOException {
        return "`" + command + "` wrote this part. " + Machine.facts() + "\n\n"
            + "### Order\n\n" + order() + "\n### Joints\n\n" + joints() + "\n### Climbing\n\n" + climbing();
    }

    private static String order() {
        return ENCOUNTERS + " rays of each family, " + CROWDS + " in crowds, seed " + SEED
            + ". Rays that meet surfaces in another order than that of the real crossings, in %.\n"
            + "A rounded order compares the crossings that the formulas of that name return; ours is the product's.\n\n"
            + MarkdownTable.of(List.of("", "textbook, rounded", "ours, rounded", "double-double, rounded", "ours"),
                Stream.of(OrderFamily.values()).map(SearchErrors::orderRow).toList());
    }

    private static List<String> orderRow(OrderFamily family) {
        return Stream.concat(Stream.of(family.title()), Stream.<Encounter.Ranking>of(
            encounter -> encounter.roundedOrder("TEXTBOOK"), encounter -> encounter.roundedOrder("OURS"),
            encounter -> encounter.roundedOrder(JUDGE), Encounter::walkedOrder)
            .map(ranking -> wrongOrders(family, ranking))).toList();
    }

    private static String wrongOrders(OrderFamily family, Encounter.Ranking ranking) {
        int count = family == OrderFamily.CROWD ? CROWDS : ENCOUNTERS;
        return CrossingErrors.percent((double) family.faults(ranking, SEED, count).size() / count);
    }

    private static String joints() {
        return ENCOUNTERS + " rays of each family to a place where surfaces meet, seed " + SEED
            + ". Places from which any line or mirrored ray takes\na surface to be on the wrong side, in %.\n\n"
            + MarkdownTable.of(List.of("", "wrong"), Stream.of(JointFamily.values())
                .map(family -> List.of(family.title(),
                    CrossingErrors.percent(family.wrongShare(SEED, ENCOUNTERS)))).toList());
    }

    private static String climbing() {
        return "The largest error in ulps that climbs from " + CLIMBS + " ordinary rays reach, and from as many of all "
            + "families, seed " + SEED + ".\nDouble-doubles judge the steps, so they do not take part.\n\n"
            + MarkdownTable.of(List.of("", "from ordinary rays", "from all families"), Stream.of(Shape.values())
                .flatMap(shape -> shape.algorithms().stream().filter(algorithm -> !algorithm.name().equals(JUDGE))
                    .map(algorithm -> climbingRow(shape, algorithm))).toList());
    }

    private static List<String> climbingRow(Shape shape, Algorithm algorithm) {
        List<Family> families = shape.families();
        double ordinary = summit(families.get(0), algorithm, CLIMBS);
        double hard = families.stream().map(family -> summit(family, algorithm, CLIMBS / families.size()))
            .max(Comparator.naturalOrder()).orElseThrow();
        return List.of(shape.name().toLowerCase(Locale.ROOT) + ", " + algorithm.title(), ulps(ordinary), ulps(hard));
    }

    private static double summit(Family family, Algorithm algorithm, int starts) {
        return Climb.highest(family, algorithm.formula(), SEED, starts, STEPS).ulps();
    }

    private static String ulps(double ulps) {
        return Double.isInfinite(ulps) ? "a wrong decision" : CrossingErrors.ulps(ulps);
    }
}
