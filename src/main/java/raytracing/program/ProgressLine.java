package raytracing.program;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import raytracing.parallel.Preparation;
import raytracing.render.Drawing;

/**
 * One line on a terminal that shows how far a picture is: first the step of its preparation, then the share that is drawn and
 * the time that is left; and always the time since the program began. A thread rewrites it until it is taken away at the end.
 * Sentences are printed through it, whether it is shown or not.
 */
final class ProgressLine implements Runnable {
    /** Nothing is shown for pictures that take less: it could not be read. */
    private static final long FIRST_MILLISECONDS = 400;
    private static final long NEXT_MILLISECONDS = 200;
    private static final double NANO = 1e-9;

    /** The last characters of a name that fit into a line of 80 with the rest. */
    private static final int LONGEST_NAME = 38;
    private static final Path STANDARD_ERROR = Path.of("/proc/self/fd/2");

    private final PrintStream stream;
    private final String name;
    private final Preparation preparation;
    private final long start;
    private Optional<Drawing> drawing = Optional.empty();
    private Optional<Pace> pace = Optional.empty();
    private int lengthShown;
    private boolean ended;

    /** A line that is not shown, of a program that began at a time of {@link System#nanoTime}. */
    ProgressLine(PrintStream stream, String name, Preparation preparation, long start) {
        this.stream = stream;
        this.name = name.length() > LONGEST_NAME ? name.substring(name.length() - LONGEST_NAME) : name;
        this.preparation = preparation;
        this.start = start;
    }

    /**
     * Whether standard error is a terminal. On all systems but Linux, which do not say so, true if the program's other two
     * streams are one.
     */
    static boolean isOnTerminal() {
        try {
            String device = Files.readSymbolicLink(STANDARD_ERROR).toString();
            return device.startsWith("/dev/pts/") || device.startsWith("/dev/tty") || device.equals("/dev/console");
        } catch (IOException | UnsupportedOperationException notLinux) {
            return System.console() != null;
        }
    }

    /** Begins to show the line, in a thread of its own. */
    void begin() {
        Thread thread = new Thread(this, "progress");
        thread.setDaemon(true);
        thread.start();
    }

    /** From now on, shows how far a drawing is, which is about to begin. */
    synchronized void follow(Drawing next) {
        drawing = Optional.of(next);
        pace = Optional.of(new Pace(System.nanoTime()));
    }

    /** Writes the line again and again until it is ended. */
    @Override
    public synchronized void run() {
        try {
            wait(FIRST_MILLISECONDS);
            while (!ended) {
                String text = text(System.nanoTime());
                stream.print('\r' + text + " ".repeat(Math.max(0, lengthShown - text.length())));
                stream.flush();
                lengthShown = text.length();
                wait(NEXT_MILLISECONDS);
            }
        } catch (InterruptedException request) {
            Thread.currentThread().interrupt();      // no thread of the program interrupts this one
        }
    }

    /** The line's text at a time. */
    String text(long now) {
        String elapsed = "  " + Pace.clock((now - start) * NANO) + " elapsed";
        if (drawing.isEmpty() || pace.isEmpty()) {
            Preparation.State state = preparation.state();
            String step = state.step().name().toLowerCase(Locale.ROOT).replace('_', ' ');
            return name + "  " + step + (state.share() > 0 ? "  " + (int) (100 * state.share()) + " %" : "") + elapsed;
        }
        pace.get().advance(drawing.get().progress().share(), now);
        return name + "  " + pace.get().percent() + " %" + elapsed + pace.get().left("  ");
    }

    /** Prints a sentence of one line; if this line is shown, in its place, and it goes on below. */
    synchronized void print(String sentence) {
        takeAway();
        stream.println(sentence);
    }

    /** Takes the line away for good; what is printed next begins in its place. */
    synchronized void end() {
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
