package raytracing.numerics;

/**
 * What a formula should have found.
 *
 * @param wanted the first crossing, rounded to the nearest double, or {@link Formula#MISS}
 * @param other the line's other crossing, wherever it is; not a number if there is none
 */
record ExactAnswer(double wanted, double other) {
    static final ExactAnswer NO_CROSSING = new ExactAnswer(Formula.MISS, Double.NaN);

    /** The error of a formula that decided wrongly: no ulps can tell how wrong. */
    static final double WRONG_DECISION = Double.POSITIVE_INFINITY;

    /** Through a corner the two crossings may be this many ulps apart; then nobody can tell which one was meant. */
    private static final double SHORTEST_CHORD = 2;

    /** How far a formula's crossing is off, in units in the last place of the wanted one. */
    double errorInUlps(double found) {
        if (found == wanted) {
            return 0;
        }
        boolean bothHit = found > 0 && found < Formula.MISS && wanted < Formula.MISS;
        double ulps = Math.abs(found - wanted) / Math.ulp(wanted);
        if (!bothHit || isCloserToTheOther(found) && ulps > SHORTEST_CHORD) {
            return WRONG_DECISION;
        }
        return ulps;
    }

    private boolean isCloserToTheOther(double found) {
        return Math.abs(found - other) < Math.abs(found - wanted);
    }
}
