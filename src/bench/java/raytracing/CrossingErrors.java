package raytracing;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import raytracing.numerics.Algorithm;
import raytracing.numerics.Family;
import raytracing.numerics.Sample;
import raytracing.numerics.Shape;

/** How wrong the contenders for a shape are, against exact arithmetic. */
final class CrossingErrors {
    static final String CAPTION = "Wrong decisions in %, worst error in ulps (median error):";
    private static final long SEED = 1;
    private static final int SIZE = 2_000;
    static final String HOW = "Errors: " + SIZE + " pairs of ray and surface of each family, seed " + SEED
        + ", against exact arithmetic. A decision is which root counts,\nor none.";

    private final Map<Family, Sample> samples = new HashMap<>();

    CrossingErrors(Shape shape) {
        shape.families().forEach(family -> samples.put(family, family.sample(SEED, SIZE)));
    }

    String cell(Algorithm algorithm, Family family) {
        Sample.Errors errors = samples.get(family).errorsOf(algorithm.formula());
        return percent(errors.wrongShare()) + ", " + ulps(errors.worst()) + " (" + ulps(errors.median()) + ")";
    }

    static String percent(double share) {
        return share == 0 ? "0" : String.format(Locale.ROOT, share < 0.1 ? "%.2g" : "%.0f", 100 * share);
    }

    /** A family may leave nothing to count: every crossing was missed. */
    static String ulps(double ulps) {
        if (Double.isNaN(ulps)) {
            return "-";
        }
        return ulps < 1000 ? String.format(Locale.ROOT, "%.0f", ulps)
            : String.format(Locale.ROOT, "%.0e", ulps).replaceFirst("e\\+0?", "e");
    }
}
