package raytracing;

import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.TimeUnit;

/** Waits until a condition is true, however slow or busy the machine is. */
public final class Patience {
    /** Longer than anything takes that does not hang. */
    public static final Duration LIMIT = Duration.ofMinutes(10);

    private static final long POLL_MILLISECONDS = 30;

    private Patience() {
    }

    /** Something that may become true. */
    public interface Condition {
        /** Whether it is true now. */
        boolean holds() throws IOException, InterruptedException;
    }

    /** Returns when a condition holds. */
    public static void await(String what, Condition condition) throws IOException, InterruptedException {
        long deadline = System.nanoTime() + LIMIT.toNanos();
        while (!condition.holds()) {
            if (System.nanoTime() > deadline) {
                throw new AssertionError("no " + what + " within " + LIMIT.toMinutes() + " minutes");
            }
            Thread.sleep(POLL_MILLISECONDS);
        }
    }

    /** Waits for the end of a process, which is killed with all that it started if it hangs; its exit status. */
    static int awaitEnd(Process process) throws InterruptedException {
        if (!process.waitFor(LIMIT.toMinutes(), TimeUnit.MINUTES)) {
            process.descendants().forEach(ProcessHandle::destroyForcibly);
            process.destroyForcibly();
            throw new AssertionError("still running after " + LIMIT.toMinutes() + " minutes");
        }
        return process.exitValue();
    }
}
