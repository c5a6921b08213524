package raytracing.watch;

import java.util.OptionalDouble;

/** How fast a drawing goes, for people: the share of it that is done, and the time that is left if the rest goes as fast. */
final class Pace {
    /** A share below this says nothing about the rest. */
    private static final double LEAST_SHARE = 0.01;
    private static final double NANO = 1e-9;

    private final long start;
    private double share;
    private long now;

    /** Of a drawing that began at a time, as {@link System#nanoTime} had it. */
    Pace(long start) {
        this.start = start;
    }

    /** How far it is at a later time; the share never falls, though smooth edges make it an estimate. */
    void advance(double newShare, long newNow) {
        share = Math.max(share, newShare);
        now = newNow;
    }

    /** How much is done: whole percents, rounded down. */
    int percent() {
        return (int) (100 * share);
    }

    /** How much time is left, if that can be said. */
    OptionalDouble secondsLeft() {
        return share < LEAST_SHARE ? OptionalDouble.empty() : OptionalDouble.of(NANO * (now - start) * (1 - share) / share);
    }
}
