package raytracing.parallel;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Daemon threads that work for the thread that started them, which waits for them. Not thread-safe. */
public final class HelperThreads {
    private static final long NANOSECONDS_IN_MILLISECOND = 1_000_000;

    private final List<Helper> helpers = new ArrayList<>();

    /** Starts a thread that does a piece of work. */
    public void start(String name, Runnable work) {
        Helper helper = new Helper(name, work);
        helper.start();
        helpers.add(helper);
    }

    /**
     * Waits until all threads have ended. An interrupt does not end the wait, for the threads still use what they share with
     * the caller; it is passed on after the wait. Returns false if some thread has not ended in so many nanoseconds.
     */
    public boolean await(long nanoseconds) {
        long start = System.nanoTime();
        boolean wasInterrupted = false;
        boolean haveEnded = true;
        for (Helper helper : helpers) {
            long left = nanoseconds - (System.nanoTime() - start);
            while (helper.isAlive() && left > 0) {
                try {
                    helper.join((left - 1) / NANOSECONDS_IN_MILLISECOND + 1);    // at least 1, as 0 means without limit
                } catch (InterruptedException interrupt) {
                    wasInterrupted = true;
                }
                left = nanoseconds - (System.nanoTime() - start);
            }
            haveEnded &= !helper.isAlive();
        }
        if (wasInterrupted) {
            Thread.currentThread().interrupt();
        }
        return haveEnded;
    }

    /** Throws what the first of the failed threads has thrown; threads that have not ended are left alone. */
    public void rethrow() {
        for (Helper helper : helpers) {
            if (!helper.isAlive() && helper.thrown.isPresent()) {
                if (helper.thrown.get() instanceof Error error) {
                    throw error;
                }
                throw (RuntimeException) helper.thrown.get();
            }
        }
    }

    private static final class Helper extends Thread {
        private final Runnable work;
        private Optional<Throwable> thrown = Optional.empty();

        Helper(String name, Runnable work) {
            super(name);
            this.work = work;
            setDaemon(true);
        }

        @Override
        public void run() {
            try {
                work.run();
            } catch (RuntimeException | Error failure) {
                thrown = Optional.of(failure);
            }
        }
    }
}
