package raytracing.parse;

import java.util.function.DoublePredicate;

/**
 * Which numbers a value may be, and how that is said.
 *
 * @param description completes "must be ..."
 * @param contains true for the numbers allowed
 */
record Range(String description, DoublePredicate contains) {
    static final Range ANY = new Range("a number", value -> true);
    static final Range ABOVE_0 = new Range("above 0", value -> value > 0);
    static final Range AT_LEAST_0 = new Range("at least 0", value -> value >= 0);
    static final Range FROM_0_TO_1 = new Range("from 0 to 1", value -> value >= 0 && value <= 1);
    static final Range FROM_MINUS_1_TO_1 = new Range("from -1 to 1", value -> value >= -1 && value <= 1);
    static final Range WHOLE_FROM_1 = new Range("a whole number from 1 on",
        value -> value >= 1 && value <= Integer.MAX_VALUE && value == Math.rint(value));

    static Range whole(int smallest, int largest) {
        return new Range("a whole number from " + smallest + " to " + largest,
            value -> value >= smallest && value <= largest && value == Math.rint(value));
    }
}
