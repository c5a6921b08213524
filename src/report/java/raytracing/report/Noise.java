package raytracing.report;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import raytracing.Quantiles;

/** Which times are likely to say more about what else the machine did than about the setting. */
final class Noise {
    /** Quartiles farther apart than this share of the median are wide. */
    private static final double WIDE = 0.2;

    /** Times so near each other are equal: a setting may cost next to nothing more than a coarser one. */
    private static final double EQUAL = 0.03;

    private Noise() {
    }

    /** Whether half of the frames do not agree on the time. */
    static boolean isWide(Quantiles times) {
        return times.upper() - times.lower() > WIDE * times.median();
    }

    /** The places of those with wide quartiles. */
    static Set<Integer> wide(List<Quantiles> times) {
        return IntStream.range(0, times.size()).filter(i -> isWide(times.get(i))).boxed().collect(Collectors.toSet());
    }

    /** The places of those, and of those in an impossible order: more work of the same kind that took less time. */
    static Set<Integer> among(List<Setting> settings, List<Quantiles> times) {
        Set<Integer> noisy = new HashSet<>(wide(times));
        for (int i = 0; i < settings.size(); i++) {
            for (int j = 0; j < settings.size(); j++) {
                if (settings.get(i).series() == settings.get(j).series()
                        && settings.get(i).work() < settings.get(j).work()
                        && times.get(i).median() > (1 + EQUAL) * times.get(j).median()) {
                    noisy.add(i);
                    noisy.add(j);
                }
            }
        }
        return noisy;
    }
}
