package raytracing.preview;

import java.awt.EventQueue;
import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import raytracing.parse.RayTracerException;
import raytracing.render.Cancellation;
import raytracing.render.DrawingListener;
import raytracing.render.Region;

/**
 * A window that shows a picture while it is drawn and until it is closed, or the pictures of a watched scene in turn. Swing's
 * thread opens and paints it; the threads that draw only note what they drew. No failure of the window harms the picture.
 */
public final class Preview {
    /** The last finished picture, the one that is drawn, and a cancelled one that is not yet garbage-collected. */
    private static final int PICTURES_OF_A_WATCHED_SCENE = 3;

    private final String output;

    /** The picture that is being drawn, or was drawn last. */
    private volatile ShownPicture picture;

    /** The last finished picture; at first one on which nothing is drawn. */
    private ShownPicture finished;

    /** Used by Swing's thread alone. */
    private Optional<PreviewWindow> window = Optional.empty();
    private boolean isClosed;

    private Preview(String output, Region region) {
        this.output = output;
        picture = new ShownPicture(region);
        finished = picture;
    }

    /**
     * Begins to open a window for a region of one picture; if there can be none, prints why on standard error.
     *
     * @param cancellation of the drawing, requested by the Escape key
     * @param encoder thread that loads Java's picture classes, if there is one; its end is awaited first, since two threads
     *        that load them in different orders may wait for each other for ever
     */
    public static Optional<Preview> open(String output, Region region, Cancellation cancellation, Optional<Thread> encoder) {
        awaitEnd(encoder);
        Optional<String> obstacle = Display.obstacle(region, 1);
        if (obstacle.isPresent()) {
            printObstacle(obstacle.get());
            return Optional.empty();
        }
        Preview preview = new Preview(output, region);
        EventQueue.invokeLater(() -> {
            try {
                preview.window = Optional.of(new PreviewWindow(output, preview.picture, PreviewWindow.Escape.STOPS, "",
                    cancellation::request, preview::noteClosed));
            } catch (RuntimeException | Error failure) {     // as in a system without fonts
                preview.noteClosed();
                printObstacle("the window could not be opened (" + failure + ")");
            }
        });
        return Optional.of(preview);
    }

    private static void printObstacle(String obstacle) {
        System.err.println("--preview: " + obstacle + "; drawing goes on without it");
    }

    /**
     * Opens a window for the pictures of a watched scene. Parameters as above, but:
     *
     * @param scene name of the scene file
     * @param closed runs in Swing's thread when the window is closed, by the Escape key too
     * @throws RayTracerException if there can be no window here
     * @throws IOException if opening the window fails
     */
    public static Preview openToWatch(String output, Region region, String scene, Runnable closed,
            Optional<Thread> encoder) throws RayTracerException, IOException {
        awaitEnd(encoder);
        Optional<String> obstacle = Display.obstacle(region, PICTURES_OF_A_WATCHED_SCENE);
        if (obstacle.isPresent()) {
            throw new RayTracerException("--watch: " + obstacle.get());
        }
        Preview preview = new Preview(output, region);
        try {
            EventQueue.invokeAndWait(() -> preview.window = Optional.of(new PreviewWindow(output, preview.picture,
                PreviewWindow.Escape.CLOSES, "drawn again whenever " + scene + " is saved", closed, closed)));
        } catch (InvocationTargetException failure) {
            throw new IOException("--watch: the window could not be opened (" + failure.getCause() + ")");
        } catch (InterruptedException request) {
            Thread.currentThread().interrupt();      // ends the wait for the first picture
        }
        return preview;
    }

    private static void awaitEnd(Optional<Thread> thread) {
        try {
            if (thread.isPresent()) {
                thread.get().join();
            }
        } catch (InterruptedException request) {
            Thread.currentThread().interrupt();      // the request to end is passed on
        }
    }

    private void noteClosed() {
        picture.release();
        synchronized (this) {
            isClosed = true;
            notifyAll();
        }
    }

    private void inWindow(Consumer<PreviewWindow> action) {
        EventQueue.invokeLater(() -> window.ifPresent(action));
    }

    /** Begins another picture, which is drawn over a copy of the last finished one. */
    public void renew() {
        ShownPicture next = finished.copy();
        picture = next;
        inWindow(open -> open.showSoon(next));
    }

    /** Receives the pixels of the picture that is being drawn. */
    public DrawingListener listener() {
        return picture;
    }

    /** From now on, the title shows how far the drawing is, in words that Swing's thread gets several times a second. */
    public void follow(Supplier<String> progress) {
        inWindow(open -> open.follow(() -> output + " - " + progress.get()));
    }

    /** Shows sentences over the picture, in place of earlier ones. */
    public void showMessages(List<String> sentences) {
        inWindow(open -> open.showMessages(sentences));
    }

    /** The picture is finished, and the title shows a summary. */
    public void end(String summary) {
        ShownPicture ended = picture;
        finished = ended;
        inWindow(open -> open.end(ended, summary));
    }

    /** There is no new picture: shows the last finished one and the reasons. */
    public void fail(List<String> sentences) {
        ShownPicture last = finished;
        inWindow(open -> {
            open.end(last, sentences.get(0));
            open.showMessages(sentences);
        });
    }

    /** Waits until the window is closed. */
    public synchronized void awaitClosed() {
        try {
            while (!isClosed) {
                wait();
            }
        } catch (InterruptedException request) {
            Thread.currentThread().interrupt();      // the request to end is passed on
        }
    }
}
