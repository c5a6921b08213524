package raytracing.render;

/**
 * The wish that a picture be drawn no further. Any thread may have it, at any time, once; whoever draws answers when it
 * draws no more.
 */
public final class Cancellation {
    private volatile boolean requested;
    private boolean isDrawn;
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

    /** A part of the picture is drawn from now on: soon after a request, {@link #answer} or {@link #drawn} is called. */
    synchronized void drawing() {
        isDrawn = true;
    }

    /** That part is drawn no more, cancelled or not. */
    synchronized void drawn() {
        isDrawn = false;
        notifyAll();
    }

    /** Nothing is drawn any more; what remains to be done is worth waiting for. */
    synchronized void answer() {
        answered = true;
        notifyAll();
    }

    /**
     * Waits until nothing is drawn any more. What is drawn answers soon, however long that is on a busy machine; what is done
     * before and between may take seconds.
     *
     * @param milliseconds for how long at most to wait for that, at least 1
     * @return false if there was no answer
     * @throws InterruptedException if the wait is interrupted
     */
    public synchronized boolean awaitAnswer(long milliseconds) throws InterruptedException {
        long deadline = System.nanoTime() + 1_000_000 * milliseconds;
        for (long left = milliseconds; !answered && (isDrawn || left > 0);
                left = (deadline - System.nanoTime()) / 1_000_000) {
            wait(isDrawn ? 0 : left);
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
