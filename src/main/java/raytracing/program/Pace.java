package raytracing.program;

import java.util.OptionalDouble;

/** How much of a drawing is done, and how much time is left if the rest takes as long per share. Not thread-safe. */
final class Pace {
    /** Below this share, the time that is left cannot be estimated. */
    private static final double LEAST_SHARE = 0.01;
    private static final double NANO = 1e-9;
    private static final long MINUTE = 60;
    private static final long HOUR = 3600;

    private final long start;
    private double share;
    private long now;

    /** Of a drawing that begins at a time of {@link System#nanoTime}. */
    Pace(long start) {
        this.start = start;
    }

    /** Sets what is done at a later time. The share never falls, though the estimate for smooth edges may. */
    void advance(double newShare, long newNow) {
        share = Math.max(share, newShare);
        now = newNow;
    }

    /** Whole percents, rounded down. */
    int percent() {
        return (int) (100 * share);
    }

    /** Empty if too little is done for an estimate. */
    OptionalDouble secondsLeft() {
        return share < LEAST_SHARE ? OptionalDouble.empty() : OptionalDouble.of(NANO * (now - start) * (1 - share) / share);
    }

    /** A separator and the time that is left, such as "0:07 left"; an empty text without an estimate. */
    String left(String separator) {
        OptionalDouble left = secondsLeft();
        return left.isEmpty() ? "" : separator + clock(left.getAsDouble()) + " left";
    }

    /** A time as hours, minutes and seconds, the hours only if there are some: 0:07, 12:34, 1:02:03. */
    static String clock(double seconds) {
        long whole = Math.round(seconds);
        String minutes = whole < HOUR ? String.valueOf(whole / MINUTE)
            : whole / HOUR + ":" + twoDigits(whole % HOUR / MINUTE);
        return minutes + ":" + twoDigits(whole % MINUTE);
    }

    private static String twoDigits(long number) {
        return (number < 10 ? "0" : "") + number;
    }
}
