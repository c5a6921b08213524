package raytracing.report;

import java.util.Locale;

/**
 * One line on standard error that says what is being done; whatever is said writes over what was said before. What is
 * said too soon after that is not written: nobody could read it, and a log would be full of it.
 */
final class Progress {
    private final Line line;
    private final String begin;

    /** What is on the screen, shared by all who write there. */
    private static final class Line {
        private static final long LEAST_NANOSECONDS = 1_000_000_000L;

        private int length;
        private long written = System.nanoTime() - LEAST_NANOSECONDS;

        void writeInTime(String text) {
            if (System.nanoTime() - written >= LEAST_NANOSECONDS) {
                write(text);
                written = System.nanoTime();
            }
        }

        void write(String text) {
            System.err.print("\r" + text + " ".repeat(Math.max(0, length - text.length())));
            System.err.flush();
            length = text.length();
        }
    }

    private Progress(Line line, String begin) {
        this.line = line;
        this.begin = begin;
    }

    /** Of a scene, counted from 1. */
    static Progress of(int number, int scenes, String scene) {
        return new Progress(new Line(), "[" + number + " of " + scenes + "] " + scene + ": ");
    }

    /** Of a part of this work. */
    Progress in(String part) {
        return new Progress(line, begin + part.toLowerCase(Locale.ROOT) + ", ");
    }

    void say(String what) {
        line.writeInTime(begin + what);
    }

    /** Ends the line. */
    void end() {
        line.write(begin + "done");
        System.err.println();
    }
}
