package raytracing.parallel;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;

class HelperThreadsTest {
    private static final long ONE_MILLISECOND = 1_000_000;

    @Test
    void aThreadThrowsNothingBeforeItHasEnded() {
        CountDownLatch endOfTest = new CountDownLatch(1);
        IllegalStateException failure = new IllegalStateException("defect");
        HelperThreads threads = new HelperThreads();
        threads.start("slow", () -> {
            try {
                endOfTest.await();
            } catch (InterruptedException unexpected) {
                throw new AssertionError(unexpected);
            }
            throw failure;
        });
        threads.start("fast", () -> { });
        assertFalse(threads.await(ONE_MILLISECOND));
        threads.rethrow();
        endOfTest.countDown();
        assertTrue(threads.await(Long.MAX_VALUE));
        assertSame(failure, assertThrows(IllegalStateException.class, threads::rethrow));
    }
}
