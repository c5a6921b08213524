package raytracing.numerics;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import raytracing.surface.Surface;

/**
 * What exact arithmetic says about the product's answers to rays that may meet a triangle.
 *
 * @param rays number of rays
 * @param hits how many meet their triangle
 * @param undecided how many doubles alone left open
 * @param worst largest error of a crossing that is a normal double, as a multiple of u = 2^-53 of the crossing
 * @param faults wrong answers, with their rays
 */
record TriangleVerdict(int rays, int hits, int undecided, double worst, List<String> faults) {
    /** What is claimed of such an error: at most 4 units in the last place, and a quarter of what a surface may have. */
    static final double MOST_ERROR = 4;
    private static final double U = 0x1p-53;

    /** What is said about one ray. */
    private record One(boolean isHit, boolean isUndecided, double error, Optional<String> fault) {
    }

    static TriangleVerdict of(TriangleFamily family, long seed, int count) {
        List<TriangleQuery> queries = family.queries(seed, count);
        List<One> all = IntStream.range(0, count).parallel()
            .mapToObj(i -> judged(queries.get(i), new SplittableRandom(seed + i))).toList();
        return new TriangleVerdict(count, (int) all.stream().filter(One::isHit).count(),
            (int) all.stream().filter(One::isUndecided).count(), all.stream().mapToDouble(One::error).max().orElseThrow(),
            all.stream().flatMap(one -> one.fault.stream()).toList());
    }

    private static One judged(TriangleQuery query, SplittableRandom random) {
        Optional<ExactCrossing> exact = query.exact();
        double found = query.found();
        double quick = query.quickCrossing(Surface.MISS);
        double error = exact.filter(TriangleVerdict::isNormal).map(crossing -> error(found, crossing)).orElse(0.0);
        boolean isRight = isRight(found, exact) && isRightBefore(query, latest(found, random), quick, exact);
        return new One(exact.isPresent(), Double.isNaN(quick), found < Surface.MISS ? error : 0,
            isRight ? Optional.empty() : Optional.of("wanted " + exact.map(ExactCrossing::value) + ", found " + found
                + ", by doubles " + quick + ": " + query));
    }

    static boolean isRight(double found, Optional<ExactCrossing> exact) {
        if (exact.isEmpty() || !(found < Surface.MISS)) {
            return exact.isEmpty() && found == Surface.MISS;
        }
        if (isNormal(exact.get())) {
            return error(found, exact.get()) <= MOST_ERROR;
        }
        boolean isSmall = exact.get().compareTo(ExactCrossing.of(1)) < 0;
        return isSmall ? found > 0 && found <= Double.MIN_NORMAL : found >= Double.MAX_VALUE / 2;
    }

    /** Beyond the normal doubles a crossing cannot keep its digits: there it must be above 0, and no miss. */
    private static boolean isNormal(ExactCrossing exact) {
        return exact.compareTo(ExactCrossing.of(Double.MIN_NORMAL)) >= 0
            && exact.compareTo(ExactCrossing.of(Double.MAX_VALUE)) <= 0;
    }

    private static double error(double found, ExactCrossing exact) {
        return exact.q().times(ExactNumber.of(found)).minus(exact.p()).absolute().over(exact.p()) / U;
    }

    /** Close to the crossing for most of the rays. */
    private static double latest(double found, SplittableRandom random) {
        double crossing = found < Surface.MISS ? found : 1;
        return switch (random.nextInt(4)) {
            case 0 -> crossing;
            case 1 -> Math.nextDown(crossing);
            case 2 -> crossing * random.nextDouble(0, 2);
            default -> crossing * (1 + Math.scalb(random.nextDouble(-1, 1), -random.nextInt(53)));
        };
    }

    /** Asked for crossings up to a distance, doubles give the same answer, or miss what is beyond it. */
    private static boolean isRightBefore(TriangleQuery query, double latest, double quick, Optional<ExactCrossing> exact) {
        double before = query.quickCrossing(latest);
        boolean isBeyond = exact.isEmpty() || exact.get().compareTo(ExactCrossing.of(latest)) > 0;
        return Double.compare(before, quick) == 0 || before == Surface.MISS && isBeyond;
    }

    /** As a row of a table. */
    String row(String title) {
        return String.format(Locale.ROOT, "| %s | %d | %.0f | %.1f | %.2f | %d |", title, rays, 100.0 * hits / rays,
            100.0 * undecided / rays, worst, faults.size());
    }
}
