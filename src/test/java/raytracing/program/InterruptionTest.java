package raytracing.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import raytracing.Patience;
import raytracing.render.Cancellation;

class InterruptionTest {
    /** What a thread comes to that has nothing more to do: its end, or a wait without one. */
    private static Thread.State afterTheEnd(Interruption interruption) throws Exception {
        Thread thread = new Thread(interruption::end);
        thread.setDaemon(true);
        thread.start();
        Patience.await("end of the thread, or wait", () -> thread.getState() == Thread.State.TERMINATED
            || thread.getState() == Thread.State.WAITING);
        return thread.getState();
    }

    @Test
    void aSignalCancelsTheDrawing() {
        Cancellation cancellation = new Cancellation();
        new Interruption(cancellation).run();
        assertTrue(cancellation.isRequested());
    }

    /** Else its own exit status could take the place of the signal's. */
    @Test
    void whoDrewStaysWhileASignalEndsTheProgram() throws Exception {
        Interruption interruption = new Interruption(new Cancellation());
        interruption.run();
        assertEquals(Thread.State.WAITING, afterTheEnd(interruption));
    }

    @Test
    void whoDrewGoesOnWithoutASignal() throws Exception {
        assertEquals(Thread.State.TERMINATED, afterTheEnd(new Interruption(new Cancellation())));
    }
}
