package raytracing.parallel;

import java.util.concurrent.atomic.AtomicInteger;

/**
 * Runs two tasks at the same time while a thread is left for one of them, otherwise one after the other; and reports how much
 * is done. Thread-safe: tasks may fork again.
 */
public final class ForkJoin {
    /** Simple work on so many numbers takes longer than handing half of it to another thread. */
    public static final int LARGE_RANGE = 1 << 16;

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

    /** Runs a task over the numbers from 0 to before a size, in ranges of {@link #LARGE_RANGE} numbers at most. */
    public void runRanges(int size, Range task) {
        runRanges(0, size, LARGE_RANGE, task);
    }

    /** Runs a task over the numbers from {@code from} to before {@code to}, in ranges: halves of halves and so on. */
    public void runRanges(int from, int to, int largest, Range task) {
        if (to - from <= largest) {
            task.run(from, to);
        } else {
            int middle = (from + to) >>> 1;
            runBoth(() -> runRanges(from, middle, largest, task), () -> runRanges(middle, to, largest, task));
        }
    }

    /** Work on the numbers of a range. */
    public interface Range {
        /** Works on those from {@code from} to before {@code to}; changes nothing that belongs to others. */
        void run(int from, int to);
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
