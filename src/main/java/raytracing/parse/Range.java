package raytracing.parse;

/**
 * Which numbers a value may be, and how that is said.
 *
 * @param description completes "must be ..."
 * @param smallest the least number allowed
 * @param largest the greatest number allowed
 */
record Range(String description, double smallest, double largest) {
    static final Range ANY = new Range("a number", Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    static final Range ABOVE_0 = new Range("above 0", Double.MIN_VALUE, Double.POSITIVE_INFINITY);
    static final Range AT_LEAST_0 = new Range("at least 0", 0, Double.POSITIVE_INFINITY);
    static final Range FROM_0_TO_1 = new Range("from 0 to 1", 0, 1);
    static final Range FROM_MINUS_1_TO_1 = new Range("from -1 to 1", -1, 1);
    static final Range WHOLE_FROM_1 = new Range("a whole number from 1 on", 1, Integer.MAX_VALUE);

    static Range whole(int smallest, int largest) {
        return new Range("a whole number from " + smallest + " to " + largest, smallest, largest);
    }

    boolean contains(double value) {
        return value >= smallest && value <= largest;
    }

    boolean containsWhole(double value) {
        return contains(value) && value == Math.rint(value);
    }
}
