package raytracing.estimate;

import raytracing.parallel.ForkJoin;

/**
 * A part of some work on numbered things that several threads may do: every n-th thing from {@code first} up to but without
 * {@code end}, for neighbours take about as long. Parts are halved until they have at most {@code least} things.
 */
record SharedWork(ForkJoin workers, Work work, int first, int stride, int end, int least) implements Runnable {
    /** May be done by several threads at once, for different things. */
    interface Work {
        /** Works on every n-th thing. */
        void work(int first, int stride, int end);
    }

    @Override
    public void run() {
        if (end - first <= stride * least) {
            work.work(first, stride, end);
        } else {
            workers.runBoth(new SharedWork(workers, work, first, 2 * stride, end, least),
                new SharedWork(workers, work, first + stride, 2 * stride, end, least));
        }
    }
}
