package raytracing.render;

import java.util.ArrayList;
import java.util.List;

/** Threads that work on tiles while another one waits for them. */
final class Crew {
    /** How often whoever waits asks whether the work was cancelled, which ends the wait when the workers do not. */
    private static final long POLL_MILLISECONDS = 20;

    /** For how long a pixel at hand is awaited after that. */
    private static final long PATIENCE_NANOSECONDS = 50_000_000;

    private Crew() {
    }

    /**
     * Lets workers work, each on a thread of its own; returns when all are done, or soon after the work was cancelled: what
     * a slow worker still does then is lost.
     */
    static void run(List<? extends TileWorker> workers, Cancellation cancellation) {
        List<Thread> threads = new ArrayList<>();
        for (TileWorker worker : workers) {
            Thread thread = new Thread(worker, "tiles");
            thread.setDaemon(true);
            thread.start();
            threads.add(thread);
        }
        waitForAll(threads, cancellation);
        for (int i = 0; i < threads.size(); i++) {
            if (!threads.get(i).isAlive()) {
                workers.get(i).failure.rethrow();
            }
        }
    }

    /**
     * Waits until all threads have ended, or soon after the work was cancelled. What they work on is nobody's before that, so
     * an interruption is passed on after it.
     */
    static void waitForAll(List<Thread> threads, Cancellation cancellation) {
        boolean interrupted = false;
        long deadline = Long.MAX_VALUE;
        for (Thread thread : threads) {
            while (thread.isAlive() && System.nanoTime() < deadline) {
                try {
                    thread.join(POLL_MILLISECONDS);
                } catch (InterruptedException request) {
                    interrupted = true;
                }
                if (deadline == Long.MAX_VALUE && cancellation.isRequested()) {
                    deadline = System.nanoTime() + PATIENCE_NANOSECONDS;
                }
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
