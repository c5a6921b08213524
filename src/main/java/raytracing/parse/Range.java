package raytracing.parse;

/**
 * The numbers that are allowed for a value, both ends included.
 *
 * @param description completes "must be ..."
 * @param isWhole whether only whole numbers are allowed
 */
record Range(String description, double smallest, double largest, boolean isWhole) {
    static final Range ANY = new Range("a number", Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    static final Range ABOVE_0 = new Range("above 0", Double.MIN_VALUE, Double.POSITIVE_INFINITY);
    static final Range AT_LEAST_0 = new Range("at least 0", 0, Double.POSITIVE_INFINITY);
    static final Range FROM_0_TO_1 = new Range("from 0 to 1", 0, 1);
    static final Range FROM_MINUS_1_TO_1 = new Range("from -1 to 1", -1, 1);
    static final Range WHOLE_FROM_1 = new Range("a whole number from 1 on", 1, Integer.MAX_VALUE, true);

    private Range(String description, double smallest, double largest) {
        this(description, smallest, largest, false);
    }

    static Range whole(int smallest, int largest) {
        return new Range("a whole number from " + smallest + " to " + largest, smallest, largest, true);
    }

    boolean contains(double value) {
        return value >= smallest && value <= largest && (!isWhole || value == Math.rint(value));
    }
}
