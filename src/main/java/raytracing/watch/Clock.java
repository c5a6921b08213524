package raytracing.watch;

/** Times as people read them. */
final class Clock {
    private static final long MINUTE = 60;
    private static final long HOUR = 3600;

    private Clock() {
    }

    /** Hours, minutes and seconds, of which hours may be missing: 0:07, 12:34, 1:02:03. */
    static String text(double seconds) {
        long whole = Math.round(seconds);
        String minutes = whole < HOUR ? String.valueOf(whole / MINUTE)
            : whole / HOUR + ":" + twoDigits(whole % HOUR / MINUTE);
        return minutes + ":" + twoDigits(whole % MINUTE);
    }

    private static String twoDigits(long number) {
        return (number < 10 ? "0" : "") + number;
    }
}
