package raytracing.report;

/**
 * What a way to draw costs and what it gets wrong: a point of the plot.
 *
 * @param milliseconds of a frame, above 0
 * @param error at least 0
 */
record TimedError(double milliseconds, double error) {
    /** Whether this is no worse in either and better in one. */
    boolean beats(TimedError other) {
        return milliseconds <= other.milliseconds && error <= other.error
            && (milliseconds < other.milliseconds || error < other.error);
    }
}
