package raytracing.command;

import java.util.Optional;

/** The options of the command line. */
enum Option {
    REGION("--region", Value.REQUIRED),
    SAMPLES("--samples", Value.REQUIRED),
    SHADOWS("--shadows", Value.REQUIRED),
    SHADOW_RAYS("--shadow-rays", Value.REQUIRED),
    OPAQUE_SHADOWS("--opaque-shadows", Value.NONE),
    SEED("--seed", Value.REQUIRED),
    THREADS("--threads", Value.REQUIRED),
    PREVIEW("--preview", Value.NONE),
    KEEP_PARTIAL("--keep-partial", Value.NONE),
    STATS("--stats", Value.AFTER_EQUALS),
    QUIET("--quiet", Value.NONE),
    HELP("--help", Value.NONE),
    VERSION("--version", Value.NONE);

    private final String word;
    private final Value value;

    Option(String word, Value value) {
        this.word = word;
        this.value = value;
    }

    String word() {
        return word;
    }

    Value value() {
        return value;
    }

    /** The option of this name, if there is one. */
    static Optional<Option> named(String word) {
        for (Option option : values()) {
            if (option.word.equals(word)) {
                return Optional.of(option);
            }
        }
        return Optional.empty();
    }

    /**
     * The option that was probably meant: one that begins like this, or else the nearest by single letters put in, left out
     * or replaced (Levenshtein, Binary codes capable of correcting deletions, insertions, and reversals, 1966), if at most
     * a third of it would have to change.
     */
    static Optional<Option> nearest(String word) {
        String name = word.replaceFirst("^-+", "");
        Optional<Option> nearest = Optional.empty();
        int least = Integer.MAX_VALUE;
        for (Option option : values()) {
            String right = option.word.substring(2);
            int distance = !name.isEmpty() && right.startsWith(name) ? 0 : distance(name, right);
            if (distance < least && 3 * distance <= right.length()) {
                least = distance;
                nearest = Optional.of(option);
            }
        }
        return nearest;
    }

    /** One row of the table of distances of all beginnings after the other. */
    private static int distance(String from, String to) {
        int[] row = new int[to.length() + 1];
        for (int j = 0; j <= to.length(); j++) {
            row[j] = j;
        }
        for (int i = 1; i <= from.length(); i++) {
            int diagonal = row[0];
            row[0] = i;
            for (int j = 1; j <= to.length(); j++) {
                int replaced = diagonal + (from.charAt(i - 1) == to.charAt(j - 1) ? 0 : 1);
                diagonal = row[j];
                row[j] = Math.min(replaced, 1 + Math.min(row[j], row[j - 1]));
            }
        }
        return row[to.length()];
    }

    /** Whether and how a value follows. */
    enum Value {
        /** None. */
        NONE,

        /** As the next word or after an equals sign. */
        REQUIRED,

        /** After an equals sign, or none. */
        AFTER_EQUALS
    }
}
