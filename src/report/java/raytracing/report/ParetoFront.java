package raytracing.report;

import java.util.Comparator;
import java.util.List;
import java.util.function.Function;

/** The ways to draw that no other beats in both time and error: who takes another one gives something away. */
final class ParetoFront {
    private ParetoFront() {
    }

    /** The unbeaten of many, the fastest first. */
    static <T> List<T> of(List<T> all, Function<T, TimedError> figures) {
        return all.stream()
            .filter(one -> all.stream().noneMatch(other -> figures.apply(other).beats(figures.apply(one))))
            .sorted(Comparator.comparingDouble(one -> figures.apply(one).milliseconds()))
            .toList();
    }
}
