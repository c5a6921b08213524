package raytracing.render;

/**
 * The wish that a picture be drawn no further. Any thread may have it, at any time, once; whoever draws answers when it
 * draws no more.
 */
public final class Cancellation {
    private volatile boolean requested;
    private boolean answered;

    /** Asks whoever draws to stop. They do after the pixel at hand, and nobody waits long for a slow one. */
    public void request() {
        requested = true;
    }

    /**
     * Whether somebody asked.
     *
     * @return true from then on
     */
    public boolean isRequested() {
        return requested;
    }

    /** Nothing is drawn any more; what remains to be done is worth waiting for. */
    synchronized void answer() {
        answered = true;
        notifyAll();
    }

    /**
     * Waits until nothing is drawn any more.
     *
     * @param milliseconds for how long at most, at least 1
     * @return false if something still is
     * @throws InterruptedException if the wait is interrupted
     */
    public synchronized boolean awaitAnswer(long milliseconds) throws InterruptedException {
        long deadline = System.nanoTime() + 1_000_000 * milliseconds;
        for (long left = milliseconds; !answered && left > 0; left = (deadline - System.nanoTime()) / 1_000_000) {
            wait(left);
        }
        return answered;
    }

    /** What becomes of the tiles that are finished then. */
    public enum Leftovers {
        /** Nothing: there is no picture. */
        DISCARD,

        /** They are the picture, if there is one; the rest is gaps. */
        KEEP
    }
}
