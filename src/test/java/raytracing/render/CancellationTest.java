package raytracing.render;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.FutureTask;
import org.junit.jupiter.api.Test;
import raytracing.Patience;

class CancellationTest {
    private static final long NO_TIME = 1;

    /** On a busy machine, what is kept of a picture must not depend on how soon its threads have their turn. */
    @Test
    void anAnswerIsAwaitedForAnyTimeWhileSomethingIsDrawn() throws Exception {
        Cancellation cancellation = new Cancellation();
        cancellation.beginDrawing();
        FutureTask<Boolean> wait = new FutureTask<>(() -> cancellation.awaitEnd(NO_TIME));
        Thread thread = new Thread(wait);
        thread.setDaemon(true);
        thread.start();
        Patience.await("wait without a limit", () -> wait.isDone() || thread.getState() == Thread.State.WAITING);
        assertFalse(wait.isDone());
        cancellation.confirmEnd();
        assertTrue(wait.get());
    }

    @Test
    void nothingIsAwaitedForLongWhereNothingIsDrawn() throws Exception {
        Cancellation cancellation = new Cancellation();
        cancellation.beginDrawing();
        cancellation.endDrawing();
        assertFalse(cancellation.awaitEnd(NO_TIME));
    }
}
