package raytracing.render;

/** Ends a drawing early. Thread-safe: any thread may request it; the thread that draws confirms that it has stopped. */
public final class Cancellation {
    private volatile boolean requested;
    private boolean isDrawing;
    private boolean hasEnded;

    /** Stops the drawing after the pixels that are being drawn; slow ones are not waited for long. */
    public void request() {
        requested = true;
    }

    /** Whether the drawing is to stop or has stopped. */
    public boolean isRequested() {
        return requested;
    }

    /** Marks the start of a part of the drawing, which ends soon after a request. */
    synchronized void beginDrawing() {
        isDrawing = true;
    }

    /** Marks the end of that part, cancelled or not. */
    synchronized void endDrawing() {
        isDrawing = false;
        notifyAll();
    }

    /** Ends the wait of {@link #awaitEnd}: all drawing has ended, and what is still to be done is worth waiting for. */
    synchronized void confirmEnd() {
        hasEnded = true;
        notifyAll();
    }

    /**
     * Waits until all drawing has ended. While a part is drawn there is no limit, because it ends soon, in processor time;
     * but what is done before and between the parts may take seconds.
     *
     * @param milliseconds for how long at most to wait while nothing is drawn, at least 1
     * @return false if the end was not confirmed
     */
    public synchronized boolean awaitEnd(long milliseconds) throws InterruptedException {
        long deadline = System.nanoTime() + 1_000_000 * milliseconds;
        for (long left = milliseconds; !hasEnded && (isDrawing || left > 0);
                left = (deadline - System.nanoTime()) / 1_000_000) {
            wait(isDrawing ? 0 : left);
        }
        return hasEnded;
    }

    /** What happens to the tiles that are finished when a drawing is cancelled. */
    public enum Leftovers {
        /** They are lost: there is no picture. */
        DISCARD,

        /** They are the picture, if there are any; the rest is gaps. */
        KEEP
    }
}
