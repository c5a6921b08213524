package raytracing.watch;

import java.io.PrintStream;
import java.util.Optional;
import java.util.OptionalDouble;
import raytracing.progress.Preparation;
import raytracing.render.Drawing;

/**
 * One line on a terminal that says how far a picture is: what is done before the drawing; then the share that is drawn, and
 * the time that is left if the rest goes as fast; and always the time since the start. It is written over and over, and gone
 * at the end.
 */
public final class ProgressLine {
    /** Pictures that take less have no line: it could not be read. */
    private static final long FIRST_MILLISECONDS = 400;
    private static final long NEXT_MILLISECONDS = 200;
    private static final double NANO = 1e-9;

    /** So much of a name fits into a line of 80 with the rest. */
    private static final int LONGEST_NAME = 38;

    private final PrintStream stream;
    private final String name;
    private final Preparation preparation;
    private final long start;
    private Optional<Drawing> drawing = Optional.empty();
    private Pace pace;
    private int lengthShown;
    private boolean ended;

    /** A line that is not written yet; the start of the program is as {@link System#nanoTime} had it. */
    ProgressLine(PrintStream stream, String name, Preparation preparation, long start) {
        this.stream = stream;
        this.name = name.length() > LONGEST_NAME ? name.substring(name.length() - LONGEST_NAME) : name;
        this.preparation = preparation;
        this.start = start;
        pace = new Pace(start);
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
     * @param preparation of it, about to begin
     * @param start of the program, as {@link System#nanoTime} had it
     * @return the line
     */
    public static ProgressLine begin(String name, Preparation preparation, long start) {
        ProgressLine line = new ProgressLine(System.err, name, preparation, start);
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

    /**
     * Says how far the drawing is, from now on.
     *
     * @param next the drawing, about to begin
     */
    public synchronized void follow(Drawing next) {
        drawing = Optional.of(next);
        pace = new Pace(System.nanoTime());
    }

    private synchronized void writeUntilEnded() {
        try {
            wait(FIRST_MILLISECONDS);
            while (!ended) {
                write(text(System.nanoTime()));
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

    /** What the line says at a time. */
    String text(long now) {
        String elapsed = "  " + Clock.text((now - start) * NANO) + " elapsed";
        if (drawing.isEmpty()) {
            Preparation.State state = preparation.state();
            return name + "  " + words(state.step()) + (state.share() > 0 ? "  " + (int) (100 * state.share()) + " %" : "") + elapsed;
        }
        pace.advance(drawing.get().share(), now);
        OptionalDouble left = pace.secondsLeft();
        return name + "  " + pace.percent() + " %" + elapsed
            + (left.isEmpty() ? "" : "  " + Clock.text(left.getAsDouble()) + " left");
    }

    private static String words(Preparation.Step step) {
        return switch (step) {
            case READING -> "reading";
            case ARRANGING -> "arranging";
            case AMBIENT_LIGHT -> "ambient light";
        };
    }

    /**
     * Writes a sentence where the line is, which goes on below it.
     *
     * @param sentence of one line
     */
    public synchronized void say(String sentence) {
        takeAway();
        stream.println(sentence);
    }

    /** Takes the line away; what is written then begins where it was. */
    public synchronized void end() {
        takeAway();
        ended = true;
        notifyAll();
    }

    private void takeAway() {
        if (lengthShown > 0) {
            stream.print('\r' + " ".repeat(lengthShown) + '\r');
            stream.flush();
            lengthShown = 0;
        }
    }
}
