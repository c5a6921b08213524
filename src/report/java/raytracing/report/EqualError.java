package raytracing.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** When a series of ever finer settings comes down to a given error. */
final class EqualError {
    /** A line through two points has nothing to be fitted to. */
    private static final int LEAST_FITTED = 3;

    private final List<TimedError> series;

    /** How an answer was found. */
    enum Origin {
        /** Its coarsest setting has less error already; the answer is that setting's time. */
        COARSEST,

        /** Between two settings, along the straight line on logarithmic axes. */
        INTERPOLATED,

        /** Beyond the finest setting, along the power law that its finer half follows. */
        EXTRAPOLATED
    }

    /** An answer. */
    record Time(double milliseconds, Origin origin) {
        /** Marked where it may be less and where it is not between measured ones. */
        String shown() {
            return switch (origin) {
                case COARSEST -> "≤ " + Shown.duration(milliseconds);
                case INTERPOLATED -> Shown.duration(milliseconds);
                case EXTRAPOLATED -> Shown.duration(milliseconds) + " *";
            };
        }
    }

    /** A series in any order. Points without error are left out: no line on logarithmic axes leads to them. */
    EqualError(List<TimedError> series) {
        this.series = series.stream().filter(point -> point.error() > 0)
            .sorted(Comparator.comparingDouble(TimedError::milliseconds)).toList();
    }

    /** When it comes down to an error above 0; nothing where the series gives no answer. */
    Optional<Time> at(double error) {
        if (series.isEmpty()) {
            return Optional.empty();
        }
        if (series.get(0).error() <= error) {
            return Optional.of(new Time(series.get(0).milliseconds(), Origin.COARSEST));
        }
        for (int i = 1; i < series.size(); i++) {
            if (series.get(i).error() <= error) {
                return Optional.of(new Time(between(series.get(i - 1), series.get(i), error), Origin.INTERPOLATED));
            }
        }
        return beyond(error);
    }

    private static double between(TimedError worse, TimedError better, double error) {
        double share = Math.log(worse.error() / error) / Math.log(worse.error() / better.error());
        return worse.milliseconds() * Math.pow(better.milliseconds() / worse.milliseconds(), share);
    }

    private Optional<Time> beyond(double error) {
        List<TimedError> finer = finerHalf();
        if (finer.size() < LEAST_FITTED) {
            return Optional.empty();
        }
        PowerLaw law = PowerLaw.fitted(finer);
        return law.exponent() < 0
            ? Optional.of(new Time(law.milliseconds(error), Origin.EXTRAPOLATED)) : Optional.empty();
    }

    /** The coarser half pays mostly for what every picture needs, and follows no power law. */
    private List<TimedError> finerHalf() {
        return new ArrayList<>(series.subList(series.size() / 2, series.size()));
    }
}
