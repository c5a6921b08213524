package raytracing.render;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import raytracing.compiled.Workers;
import raytracing.progress.Preparation;

/** Does two pieces of work at the same time while a thread is left to do it, and one after the other otherwise. */
final class ThreadWorkers implements Workers {
    /** What makes a picture ready is never cancelled: the program ends without it. */
    private static final Cancellation NEVER = new Cancellation();

    private final AtomicInteger idle;
    private final Preparation preparation;

    /** With so many threads at most, the calling one included; how far they are, they tell the preparation. */
    ThreadWorkers(int threads, Preparation preparation) {
        idle = new AtomicInteger(threads - 1);
        this.preparation = preparation;
    }

    @Override
    public void expect(long count) {
        preparation.expect(count);
    }

    @Override
    public void advance(long count) {
        preparation.advance(count);
    }

    @Override
    public void doBoth(Runnable first, Runnable second) {
        if (idle.getAndDecrement() <= 0) {
            idle.getAndIncrement();
            first.run();
            second.run();
            return;
        }
        Helper helper = new Helper(second);
        Thread thread = new Thread(helper, "workers");
        thread.setDaemon(true);
        thread.start();
        try {
            first.run();
        } finally {
            Crew.waitForAll(List.of(thread), NEVER);
            idle.getAndIncrement();
        }
        helper.failure.rethrow();
    }

    private static final class Helper implements Runnable {
        private final Runnable work;
        private final Failure failure = new Failure();

        Helper(Runnable work) {
            this.work = work;
        }

        @Override
        public void run() {
            try {
                work.run();
            } catch (RuntimeException | Error thrown) {
                failure.keep(thrown);
            }
        }
    }
}
