package raytracing.parallel;

import java.util.concurrent.atomic.AtomicInteger;

/**
 * Runs two tasks at the same time while a thread is left for one of them, otherwise one after the other; and reports how much
 * is done. Thread-safe: tasks may fork again.
 */
public final class ForkJoin {
    private final AtomicInteger idleThreads;
    private final Preparation preparation;

    /** With so many threads at most, the calling one included; at least 1. The preparation gets the reports. */
    public ForkJoin(int threads, Preparation preparation) {
        idleThreads = new AtomicInteger(threads - 1);
        this.preparation = preparation;
    }

    /** The calling thread alone; the reports go nowhere. */
    public static ForkJoin sequential() {
        return new ForkJoin(1, new Preparation());
    }

    /** Runs two tasks that share nothing that they change; returns when both have ended. */
    public void runBoth(Runnable first, Runnable second) {
        if (idleThreads.getAndDecrement() <= 0) {
            idleThreads.getAndIncrement();
            first.run();
            second.run();
            return;
        }
        HelperThreads helper = new HelperThreads();
        helper.start("fork", second);
        try {
            first.run();
        } finally {
            helper.await(Long.MAX_VALUE);
            idleThreads.getAndIncrement();
        }
        helper.rethrow();
    }

    /** Reports how much there is to do, in bodies or cells. */
    public void expect(long count) {
        preparation.expect(count);
    }

    /** Reports how much was done since the last call; to be called now and then, from any thread. */
    public void advance(long count) {
        preparation.advance(count);
    }
}
