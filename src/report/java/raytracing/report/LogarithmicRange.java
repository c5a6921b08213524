package raytracing.report;

import java.util.Collections;
import java.util.List;

/** What a logarithmic axis shows: all its data, and two powers of ten at least, for only those have their numbers. */
record LogarithmicRange(double least, double most) {
    private static final double MARGIN = 1.5;
    private static final int LABELS = 2;

    /** Around positive values, at least one. */
    static LogarithmicRange around(List<Double> values) {
        LogarithmicRange close = new LogarithmicRange(Collections.min(values) / MARGIN,
            Collections.max(values) * MARGIN);
        if (close.powersOfTen() >= LABELS) {
            return close;
        }
        double below = Math.pow(10, Math.floor(Math.log10(close.least)));
        double above = Math.pow(10, Math.ceil(Math.log10(close.most)));
        return new LogarithmicRange(below / MARGIN, above * MARGIN);
    }

    /** How many lie inside. */
    int powersOfTen() {
        return (int) (Math.floor(Math.log10(most)) - Math.ceil(Math.log10(least))) + 1;
    }

    /** A value moved on by a share of the axis, or back by a negative one. */
    double moved(double value, double share) {
        return value * Math.pow(most / least, share);
    }

    double clamped(double value) {
        return Math.min(Math.max(value, least), most);
    }
}
