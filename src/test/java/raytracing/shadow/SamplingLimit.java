package raytracing.shadow;

/**
 * What the exercise's method comes to with many shadow rays, and how far it may still be off: the mean of several runs
 * with different random numbers, and the standard error that their spread shows.
 *
 * @param mean of all runs
 * @param standardError of the mean
 */
public record SamplingLimit(double mean, double standardError) {
    /** Of so many runs with root x root rays each. */
    public static SamplingLimit of(ShadowQueries.Query query, int root, int runs) {
        ShaftQuery shaft = query.shaft(ShaftQuery.Use.LINES);
        double cells = (double) root * root;
        double sum = 0;
        double squares = 0;
        for (int run = 0; run < runs; run++) {
            double share = shaft.sumOverCells(root, run) / cells;
            sum += share;
            squares += share * share;
        }
        double mean = sum / runs;
        double variance = Math.max(squares / runs - mean * mean, 0) / (runs - 1);
        return new SamplingLimit(mean, Math.sqrt(variance));
    }

    /**
     * How many standard errors another answer is away. What is hidden from single cells may be missed by all runs, so
     * an error is never taken as smaller than that of one ray in all of them.
     */
    public double distance(double other, int root, int runs) {
        return Math.abs(other - mean) / Math.max(standardError, 1 / ((double) root * root * runs));
    }
}
