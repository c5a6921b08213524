package raytracing.parallel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.Patience;
import raytracing.parallel.Preparation.State;
import raytracing.parallel.Preparation.Step;

class ForkJoinTest {
    private final List<Thread> threads = new CopyOnWriteArrayList<>();

    private Runnable noting() {
        return () -> threads.add(Thread.currentThread());
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException unexpected) {
            throw new AssertionError(unexpected);
        }
    }

    private static void await(String what, Patience.Condition condition) {
        try {
            Patience.await(what, condition);
        } catch (IOException | InterruptedException unexpected) {
            throw new AssertionError(unexpected);
        }
    }

    @Test
    void oneThreadRunsBothTasksInOrder() {
        StringBuilder order = new StringBuilder();
        ForkJoin.sequential().runBoth(() -> order.append("first "), () -> order.append("second"));
        assertEquals("first second", order.toString());
    }

    @Test
    void twoThreadsRunThemAtTheSameTime() {
        CountDownLatch firstRuns = new CountDownLatch(1);
        CountDownLatch secondRuns = new CountDownLatch(1);
        new ForkJoin(2, new Preparation()).runBoth(() -> {
            firstRuns.countDown();
            await(secondRuns);
        }, () -> {
            secondRuns.countDown();
            await(firstRuns);
        });
    }

    /** 2^6 tasks. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 5})
    void noMoreThreadsWorkAtOnceThanThereAre(int most) {
        ForkJoin forkJoin = new ForkJoin(most, new Preparation());
        AtomicInteger running = new AtomicInteger();
        AtomicInteger mostRunning = new AtomicInteger();
        AtomicInteger tasks = new AtomicInteger();
        split(forkJoin, 6, () -> {
            mostRunning.accumulateAndGet(running.incrementAndGet(), Math::max);
            Thread.yield();
            tasks.incrementAndGet();
            running.decrementAndGet();
        });
        assertEquals(64, tasks.get());
        assertTrue(mostRunning.get() <= most, () -> mostRunning + " at once");
    }

    private static void split(ForkJoin forkJoin, int depth, Runnable task) {
        if (depth == 0) {
            task.run();
        } else {
            forkJoin.runBoth(() -> split(forkJoin, depth - 1, task), () -> split(forkJoin, depth - 1, task));
        }
    }

    @Test
    void whatTheHelperThrowsIsThrown() {
        for (Throwable thrown : List.of(new IllegalStateException("defect"), new OutOfMemoryError("memory"))) {
            ForkJoin forkJoin = new ForkJoin(2, new Preparation());
            assertSame(thrown, assertThrows(thrown.getClass(), () -> forkJoin.runBoth(noting(), () -> fail(thrown))));
            assertEquals(1, threads.size(), "the first task is done");
            threads.clear();
        }
    }

    private static void fail(Throwable thrown) {
        if (thrown instanceof Error error) {
            throw error;
        }
        throw (RuntimeException) thrown;
    }

    /** And the helper's thread is free again. */
    @Test
    void ofAFirstTaskThatFailsTheSecondIsWaitedFor() {
        ForkJoin forkJoin = new ForkJoin(2, new Preparation());
        assertThrows(IllegalStateException.class,
            () -> forkJoin.runBoth(() -> fail(new IllegalStateException("defect")), noting()));
        assertEquals(1, threads.size());
        forkJoin.runBoth(noting(), noting());
        assertEquals(3, threads.size());
        assertTrue(threads.get(1) != threads.get(2), "two threads");
    }

    /** Until the helper has ended, it may use what it shares with the caller. */
    @Test
    void anInterruptIsPassedOnAfterTheWait() {
        Thread caller = Thread.currentThread();
        new ForkJoin(2, new Preparation()).runBoth(noting(), () -> {
            await("wait of the caller", () -> caller.getState() == Thread.State.TIMED_WAITING);
            caller.interrupt();
            await("wait after the interrupt",
                () -> !caller.isInterrupted() && caller.getState() == Thread.State.TIMED_WAITING);
            threads.add(Thread.currentThread());
        });
        assertEquals(2, threads.size());
        assertTrue(Thread.interrupted());
    }

    @Test
    void reportsGoToThePreparation() {
        Preparation preparation = new Preparation();
        preparation.begin(Step.ARRANGING);
        ForkJoin forkJoin = new ForkJoin(1, preparation);
        forkJoin.expect(8);
        forkJoin.advance(2);
        assertEquals(new State(Step.ARRANGING, 0.25), preparation.state());
    }

    @Test
    void rangesHoldEveryNumberOnce() {
        AtomicInteger[] counts = new AtomicInteger[1000];
        Arrays.setAll(counts, i -> new AtomicInteger());
        new ForkJoin(3, new Preparation()).runRanges(10, 1000, 7, (from, to) -> {
            assertTrue(to - from <= 7);
            for (int i = from; i < to; i++) {
                counts[i].incrementAndGet();
            }
        });
        for (int i = 0; i < counts.length; i++) {
            assertEquals(i < 10 ? 0 : 1, counts[i].get());
        }
    }
}
