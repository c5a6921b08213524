package raytracing.report;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Locale;
import raytracing.Quantiles;

/** Figures as people read them. */
final class Shown {
    private static final int DIGITS = 3;
    private static final double STEPS = 255;
    private static final double LEAST_STEPS = 0.001;
    private static final int ROUGH_DIGITS = 2;
    private static final double MILLISECONDS_IN_SECOND = 1000;
    private static final double SECONDS_IN_MINUTE = 60;
    private static final double MINUTES_IN_HOUR = 60;

    private Shown() {
    }

    /** Three digits that count, never with a power of ten. */
    static String number(double value) {
        BigDecimal rounded = new BigDecimal(value).round(new MathContext(DIGITS));
        int digitsBeforePoint = rounded.precision() - rounded.scale();
        return value == 0 ? "0"
            : rounded.setScale(Math.max(0, DIGITS - digitsBeforePoint), RoundingMode.HALF_UP).toPlainString();
    }

    /** A number of a setting, without a point where it is whole. */
    static String plain(double number) {
        return number == Math.rint(number) ? String.valueOf((long) number) : String.valueOf(number);
    }

    /** An error in linear light, in steps of 1/255. */
    static String steps(double error) {
        double steps = error * STEPS;
        return steps == 0 ? "0" : steps < LEAST_STEPS ? "< " + LEAST_STEPS
            : rough(steps);
    }

    /** Two digits that count, or all before the point: for sentences. */
    static String rough(double value) {
        double rounded = new BigDecimal(value).round(new MathContext(ROUGH_DIGITS)).doubleValue();
        return rounded >= 10 ? String.valueOf((long) rounded) : plain(rounded);
    }

    /** Two digits that count, with a power of ten; 0 for none at all. */
    static String error(double error) {
        return error == 0 ? "0" : String.format(Locale.ROOT, "%.1e", error).replace("e-0", "e-").replace("e+00", "e0")
            .replace("e+0", "e");
    }

    /** The median, with the quartiles in brackets. */
    static String quartiles(Quantiles times) {
        return number(times.median()) + " (" + number(times.lower()) + " - " + number(times.upper()) + ")";
    }

    static String percent(double share) {
        return share == 0 ? "0" : share < 0.001 ? "< 0.1" : String.format(Locale.ROOT, "%.1f", 100 * share);
    }

    /** Where it is hardly less than 1, it must not look like 1. */
    static String similarity(double similarity) {
        return similarity == 1 ? "1" : String.format(Locale.ROOT, "%.5f", Math.min(similarity, 0.99999));
    }

    static String decibels(double decibels) {
        return Double.isInfinite(decibels) ? "equal" : String.format(Locale.ROOT, "%.1f", decibels);
    }

    /** In the unit in which it is a handy number. */
    static String duration(double milliseconds) {
        double seconds = milliseconds / MILLISECONDS_IN_SECOND;
        double minutes = seconds / SECONDS_IN_MINUTE;
        if (seconds < 1) {
            return number(milliseconds) + " ms";
        }
        if (minutes < 2) {
            return number(seconds) + " s";
        }
        return minutes < 2 * MINUTES_IN_HOUR ? number(minutes) + " min" : number(minutes / MINUTES_IN_HOUR) + " h";
    }

    /** How many times as long one takes as another. */
    static String factor(double factor) {
        return number(factor) + " times";
    }
}
