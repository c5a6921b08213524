package raytracing;

import java.util.List;

/**
 * What is left of many measurements: unlike a mean, it does not mind the one that was disturbed. A quantile that falls between
 * two measurements is between them in proportion.
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
        double place = share * (sorted.size() - 1);
        double below = sorted.get((int) Math.floor(place));
        return below + (place - Math.floor(place)) * (sorted.get((int) Math.ceil(place)) - below);
    }

    /** Half the way between the quartiles. */
    double spread() {
        return (upper - lower) / 2;
    }
}
