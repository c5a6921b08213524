package raytracing.watch;

import raytracing.render.Cancellation;

/**
 * What happens when a signal ends the program (SIGINT, SIGTERM, SIGHUP): the drawing is cancelled, and the virtual machine
 * waits for what remains to be done, if the drawing answers in time; it exits with 128 and the number of the signal. Without
 * this, it would stop at once.
 */
public final class Interruption {
    private static final long PATIENCE_MILLISECONDS = 150;

    private final Cancellation cancellation;
    private final Thread hook = new Thread("interruption") {
        @Override
        public void run() {
            cancel();
        }
    };
    private boolean isOver;
    private boolean isEnding;

    /** Without a signal yet. */
    Interruption(Cancellation cancellation) {
        this.cancellation = cancellation;
    }

    /**
     * From now on, signals cancel a drawing.
     *
     * @param cancellation of the drawing
     * @return to be told when all is done
     */
    public static Interruption install(Cancellation cancellation) {
        Interruption interruption = new Interruption(cancellation);
        try {
            Runtime.getRuntime().addShutdownHook(interruption.hook);
        } catch (IllegalStateException endingAlready) {
            interruption.cancel();           // a signal came before; what is left to do is to stay
        }
        return interruption;
    }

    /** At the end of the program this runs too, when all is over. */
    void cancel() {
        cancellation.request();
        try {
            if (!isOverAtTheEnd() && cancellation.awaitAnswer(PATIENCE_MILLISECONDS)) {
                awaitEnd();
            }
        } catch (InterruptedException impatience) {
            Thread.currentThread().interrupt();
        }
    }

    private synchronized boolean isOverAtTheEnd() {
        isEnding = true;
        return isOver;
    }

    private synchronized void awaitEnd() throws InterruptedException {
        while (!isOver) {
            wait();
        }
    }

    /**
     * Nothing remains to be done, and nothing went wrong: a failure has a sentence and a status of its own, which are more than
     * the signal's. From now on, signals do what they do without this. While one ends the program, this does not return: a
     * virtual machine that has run its hooks would take the status of whatever asked for an exit last.
     */
    public synchronized void end() {
        isOver = true;
        notifyAll();
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException endingAlready) {
            isEnding = true;
        }
        try {
            while (isEnding) {
                wait();
            }
        } catch (InterruptedException impatience) {
            Thread.currentThread().interrupt();
        }
    }
}
