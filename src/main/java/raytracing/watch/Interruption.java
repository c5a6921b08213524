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
    private boolean isOver;

    private Interruption(Cancellation cancellation) {
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
        Runtime.getRuntime().addShutdownHook(new Thread("interruption") {
            @Override
            public void run() {
                interruption.cancel();
            }
        });
        return interruption;
    }

    /** At the end of the program this runs too, when all is over. */
    private void cancel() {
        cancellation.request();
        try {
            if (!isOver() && cancellation.awaitAnswer(PATIENCE_MILLISECONDS)) {
                awaitEnd();
            }
        } catch (InterruptedException impatience) {
            Thread.currentThread().interrupt();
        }
    }

    private synchronized boolean isOver() {
        return isOver;
    }

    private synchronized void awaitEnd() throws InterruptedException {
        while (!isOver) {
            wait();
        }
    }

    /** Nothing remains to be done. */
    public synchronized void end() {
        isOver = true;
        notifyAll();
    }
}
