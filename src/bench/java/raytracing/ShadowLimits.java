package raytracing;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import raytracing.shadow.SamplingLimit;
import raytracing.shadow.ShadowQueries;

/** Exact shares of lights beside what the exercise's method comes to with very many shadow rays. */
final class ShadowLimits {
    private static final int SEED = 1;
    private static final int ROOT = 200;
    private static final double[] OPAQUE = {0};
    private static final double[] MIXED = {0, 0.7, 0.3, 0.9};

    private ShadowLimits() {
    }

    /** Of all questions of one sequence. */
    private record Distances(int count, double largest, double rootMeanSquare, double largestDifference,
                             double meanError) {
    }

    static String section(Effort effort) {
        int questions = effort == Effort.FULL ? 1000 : 100;
        int runs = effort == Effort.FULL ? 64 : 8;
        List<List<String>> rows = new ArrayList<>();
        rows.add(cells("opaque surfaces", distances(new ShadowQueries(SEED, OPAQUE), questions, runs)));
        rows.add(cells("some transparent", distances(new ShadowQueries(SEED, MIXED), questions, runs)));
        return String.format(Locale.ROOT,
            "%d random questions a row (seed %d), none of them plainly lit or dark; each beside %d "
            + "runs with %d x %d shadow rays. Distances\nare in standard errors of the mean of these runs, which follow Student's "
            + "t with %d degrees of freedom if there is no bias.\n\n", questions, SEED, runs, ROOT, ROOT, runs - 1)
            + MarkdownTable.of(List.of("", "largest distance", "root of mean square", "largest difference of shares",
                "mean standard error"), rows);
    }

    private static Distances distances(ShadowQueries queries, int questions, int runs) {
        double largest = 0;
        double squares = 0;
        double largestDifference = 0;
        double errors = 0;
        for (int i = 0; i < questions; i++) {
            ShadowQueries.Query query = queries.next();
            SamplingLimit limit = SamplingLimit.of(query, ROOT, runs);
            double exact = query.exact();
            double distance = limit.distance(exact, ROOT, runs);
            largest = Math.max(largest, distance);
            squares += distance * distance;
            largestDifference = Math.max(largestDifference, Math.abs(exact - limit.mean()));
            errors += limit.standardError();
            if (i % 100 == 0) {
                System.out.println("Question " + i + ": " + exact + " beside " + limit);
            }
        }
        return new Distances(questions, largest, Math.sqrt(squares / questions), largestDifference, errors / questions);
    }

    private static List<String> cells(String name, Distances distances) {
        return List.of(name, String.format(Locale.ROOT, "%.2f", distances.largest),
            String.format(Locale.ROOT, "%.3f", distances.rootMeanSquare),
            String.format(Locale.ROOT, "%.1e", distances.largestDifference),
            String.format(Locale.ROOT, "%.1e", distances.meanError));
    }
}
