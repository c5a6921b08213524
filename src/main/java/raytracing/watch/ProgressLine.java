package raytracing.watch;

import java.io.PrintStream;
import java.util.OptionalDouble;
import raytracing.render.Drawing;

/**
 * One line on a terminal that says how far a picture is: the share that is done, the time since the start, and the time that
 * is left if the rest goes as fast. It is written over and over, and gone at the end.
 */
public final class ProgressLine {
    /** Pictures that take less have no line: it could not be read. */
    private static final long FIRST_MILLISECONDS = 400;
    private static final long NEXT_MILLISECONDS = 200;
    private static final double NANO = 1e-9;

    /** So much of a name fits into a line of 80 with the rest. */
    private static final int LONGEST_NAME = 40;

    private final PrintStream stream;
    private final String name;
    private final Drawing drawing;
    private final long start;
    private final Pace pace = new Pace(System.nanoTime());
    private int lengthShown;
    private boolean ended;

    private ProgressLine(PrintStream stream, String name, Drawing drawing, long start) {
        this.stream = stream;
        this.name = name.length() > LONGEST_NAME ? name.substring(name.length() - LONGEST_NAME) : name;
        this.drawing = drawing;
        this.start = start;
    }

    /**
     * Whether there is somebody to read it.
     *
     * @return true if standard error is a terminal
     */
    public static boolean isWanted() {
        return Terminal.isThere();
    }

    /**
     * Begins to write it on standard error, beside whatever is done until it ends.
     *
     * @param name of the picture
     * @param drawing of it, about to begin
     * @param start of the program, as {@link System#nanoTime} had it
     * @return the line
     */
    public static ProgressLine begin(String name, Drawing drawing, long start) {
        ProgressLine line = new ProgressLine(System.err, name, drawing, start);
        Thread thread = new Thread("progress") {
            @Override
            public void run() {
                line.writeUntilEnded();
            }
        };
        thread.setDaemon(true);
        thread.start();
        return line;
    }

    private synchronized void writeUntilEnded() {
        try {
            wait(FIRST_MILLISECONDS);
            while (!ended) {
                write(text(drawing.share(), System.nanoTime()));
                wait(NEXT_MILLISECONDS);
            }
        } catch (InterruptedException request) {
            Thread.currentThread().interrupt();      // nobody does; then there is no line
        }
    }

    private void write(String text) {
        stream.print('\r' + text + " ".repeat(Math.max(0, lengthShown - text.length())));
        stream.flush();
        lengthShown = text.length();
    }

    private String text(double share, long now) {
        pace.advance(share, now);
        OptionalDouble left = pace.secondsLeft();
        return name + "  " + pace.percent() + " %  " + Clock.text((now - start) * NANO) + " elapsed"
            + (left.isEmpty() ? "" : "  " + Clock.text(left.getAsDouble()) + " left");
    }

    /** Takes the line away; what is written then begins where it was. */
    public synchronized void end() {
        if (!ended && lengthShown > 0) {
            stream.print('\r' + " ".repeat(lengthShown) + '\r');
            stream.flush();
        }
        ended = true;
        notifyAll();
    }
}
