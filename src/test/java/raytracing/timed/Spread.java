package raytracing.timed;

import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * What is left of a few measurements of the same thing.
 *
 * @param least the smallest
 * @param median the middle one, or the upper of two
 * @param most the largest
 */
public record Spread(double least, double median, double most) {
    /** Nothing where nothing was measured. */
    public static Optional<Spread> of(List<Double> values) {
        List<Double> sorted = values.stream().sorted().toList();
        return sorted.isEmpty() ? Optional.empty() : Optional.of(
            new Spread(sorted.get(0), sorted.get(sorted.size() / 2), sorted.get(sorted.size() - 1)));
    }

    /** The median, with the range in brackets. */
    public String shown(int decimals) {
        String format = "%." + decimals + "f";
        return String.format(Locale.ROOT, format + " (" + format + " - " + format + ")", median, least, most);
    }
}
