package raytracing.program;

import raytracing.render.Cancellation;

/**
 * Lets a signal that ends the program (SIGINT, SIGTERM, SIGHUP) cancel the drawing first. If the drawing answers in time, the
 * virtual machine waits for what remains to be done, such as writing the finished part; then it exits with 128 and the number
 * of the signal. Without this, it would stop at once.
 */
final class Interruption implements Runnable {
    private static final long PATIENCE_MILLISECONDS = 150;

    private final Cancellation cancellation;
    private final Thread hook = new Thread(this, "interruption");
    private boolean isOver;
    private boolean isExiting;

    Interruption(Cancellation cancellation) {
        this.cancellation = cancellation;
    }

    /** From now on until {@link #end}, signals cancel the drawing. */
    void begin() {
        try {
            Runtime.getRuntime().addShutdownHook(hook);
        } catch (IllegalStateException alreadyExiting) {
            run();                               // a signal came before
        }
    }

    /** Cancels the drawing when the virtual machine exits, which it also does at the end of the program. */
    @Override
    public void run() {
        cancellation.request();
        try {
            if (!isOverAtExit() && cancellation.awaitEnd(PATIENCE_MILLISECONDS)) {
                synchronized (this) {
                    while (!isOver) {
                        wait();
                    }
                }
            }
        } catch (InterruptedException request) {
            Thread.currentThread().interrupt();
        }
    }

    private synchronized boolean isOverAtExit() {
        isExiting = true;
        return isOver;
    }

    /**
     * Nothing remains to be done, and from now on signals do what they do without this. While a signal ends the program, this
     * does not return: the exit status of a virtual machine that has run its hooks would be that of the last call of exit().
     */
    synchronized void end() {
        isOver = true;
        notifyAll();
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException alreadyExiting) {
            isExiting = true;
        }
        try {
            while (isExiting) {
                wait();
            }
        } catch (InterruptedException request) {
            Thread.currentThread().interrupt();
        }
    }
}
