package raytracing.watch;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import raytracing.render.Cancellation;

class InterruptionTest {
    private static final long MILLISECONDS = 300;

    private static Thread ending(Interruption interruption) throws InterruptedException {
        Thread thread = new Thread(interruption::end);
        thread.setDaemon(true);
        thread.start();
        thread.join(MILLISECONDS);
        return thread;
    }

    @Test
    void aSignalCancelsTheDrawing() {
        Cancellation cancellation = new Cancellation();
        new Interruption(cancellation).cancel();
        assertTrue(cancellation.isRequested());
    }

    /** Else its own exit status could take the place of the signal's. */
    @Test
    void whoDrewStaysWhileASignalEndsTheProgram() throws InterruptedException {
        Interruption interruption = new Interruption(new Cancellation());
        interruption.cancel();
        assertTrue(ending(interruption).isAlive());
    }

    @Test
    void whoDrewGoesOnWithoutASignal() throws InterruptedException {
        assertFalse(ending(new Interruption(new Cancellation())).isAlive());
    }
}
