package raytracing.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import raytracing.parse.Spelling;

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
    WATCH("--watch", Value.NONE),
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

    /** The option that was probably meant: one that begins like this, or else the nearest by its spelling. */
    static Optional<Option> nearest(String word) {
        String name = word.replaceFirst("^-+", "");
        List<String> names = new ArrayList<>();
        for (Option option : values()) {
            names.add(option.word.substring(2));
            if (!name.isEmpty() && option.word.startsWith(name, 2)) {
                return Optional.of(option);
            }
        }
        return Spelling.nearest(name, names).flatMap(right -> named("--" + right));
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
