package raytracing.program;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import raytracing.parse.RayTracerException;
import raytracing.parse.Spelling;

/** The options of the command line; {@link CommandLine#HELP} says what they do. */
public enum Option {
    REGION("--region", Value.REQUIRED),
    SAMPLES("--samples", Value.REQUIRED),
    ERROR("--error", Value.REQUIRED),
    SHADOWS("--shadows", Value.REQUIRED),
    SHADOW_RAYS("--shadow-rays", Value.REQUIRED),
    OPAQUE_SHADOWS("--opaque-shadows", Value.NONE),
    SEED("--seed", Value.REQUIRED),
    THREADS("--threads", Value.REQUIRED),
    PREVIEW("--preview", Value.NONE),
    WATCH("--watch", Value.NONE),
    KEEP_PARTIAL("--keep-partial", Value.NONE),
    STATS("--stats", Value.OPTIONAL),

    /** What {@link #STATS} with its value becomes. */
    STATS_AS_JSON("--stats=json", Value.NONE),
    COMPARE("--compare", Value.REQUIRED),
    COMPARE_MAP("--compare-map", Value.REQUIRED),
    QUIET("--quiet", Value.NONE),
    HELP("--help", Value.NONE),
    VERSION("--version", Value.NONE);

    final String word;
    final Value value;

    Option(String word, Value value) {
        this.word = word;
        this.value = value;
    }

    /** The option with this word; the error names the one that was probably meant. */
    static Option named(String word) throws RayTracerException {
        for (Option option : values()) {
            if (option.word.equals(word)) {
                return option;
            }
        }
        throw new RayTracerException(word + ": unknown option"
            + nearest(word).map(meant -> ", did you mean " + meant.word + "? See --help").orElse(", see --help"));
    }

    /** The option that was probably meant: one that begins with these letters, or else the nearest by its spelling. */
    static Optional<Option> nearest(String word) {
        String name = word.replaceFirst("^-+", "");
        List<String> names = new ArrayList<>();
        for (Option option : values()) {
            names.add(option.word.substring(2));
            if (!name.isEmpty() && option.word.startsWith(name, 2)) {
                return Optional.of(option);
            }
        }
        return Spelling.nearest(name, names).map(right -> values()[names.indexOf(right)]);
    }

    /** Whether a value follows: as the next word or after an equals sign; if optional, only after an equals sign. */
    enum Value { NONE, REQUIRED, OPTIONAL }
}
