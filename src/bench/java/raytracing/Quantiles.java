package raytracing;

import java.util.List;

/**
 * What is left of many measurements: unlike a mean, it does not mind the one that was disturbed.
 *
 * @param count how many there were
 * @param lower quartile
 * @param median the middle one
 * @param upper quartile
 */
public record Quantiles(int count, double lower, double median, double upper) {
    /** Of at least one. */
    public static Quantiles of(List<Double> values) {
        List<Double> sorted = values.stream().sorted().toList();
        return new Quantiles(sorted.size(), at(sorted, 0.25), at(sorted, 0.5), at(sorted, 0.75));
    }

    private static double at(List<Double> sorted, double share) {
        return sorted.get((int) (share * (sorted.size() - 1) + 0.5));
    }

    /** Half the way between the quartiles. */
    double spread() {
        return (upper - lower) / 2;
    }
}
