package raytracing;

import java.io.IOException;

/** Waits for what another process does, for a time that is only reached if it does not. */
final class Patience {
    private static final long POLL_MILLISECONDS = 30;

    private Patience() {
    }

    /** Something that may become true. */
    interface Condition {
        boolean holds() throws IOException, InterruptedException;
    }

    static void await(String what, long seconds, Condition condition) throws IOException, InterruptedException {
        long deadline = System.nanoTime() + 1_000_000_000 * seconds;
        while (!condition.holds()) {
            if (System.nanoTime() > deadline) {
                throw new AssertionError("no " + what + " within " + seconds + " seconds");
            }
            Thread.sleep(POLL_MILLISECONDS);
        }
    }
}
