package raytracing.watch;

import java.awt.EventQueue;
import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import raytracing.parse.RayTracerException;
import raytracing.render.Cancellation;
import raytracing.render.Drawing;
import raytracing.render.DrawingListener;
import raytracing.render.Region;

/**
 * A window that shows a picture while it is drawn, and until it is closed; or, one after the other, the pictures of a scene that
 * is watched. Its own thread opens and paints it; those that draw only note what they drew. Nothing that happens to the window
 * harms the picture.
 */
final class Preview {
    /** Larger pictures are not shown: this many take 256 MB. */
    static final long MOST_PIXELS = 1 << 26;

    private static final int BYTES_IN_A_PIXEL = 4;

    /** A window takes no more of the memory than one part in so many: the drawing must not lack it. */
    private static final int SHARE_OF_MEMORY = 4;

    /** The last good picture, the one that is drawn, and the one that was stopped and is not yet thrown away. */
    private static final int PICTURES_OF_A_WATCHED_SCENE = 3;

    private final String output;

    /** The last one that is finished; before that, one on which nothing is drawn. */
    private ShownPicture finished;

    /** The one that is being drawn, or was. */
    private volatile ShownPicture picture;

    /** Only Swing's thread opens and asks for it. */
    private Optional<PreviewWindow> window = Optional.empty();
    private boolean isClosed;

    private Preview(String output, Region region) {
        this.output = output;
        picture = new ShownPicture(region);
        finished = picture;
    }

    /**
     * Begins to open a window for one picture. Where there can be none, standard error gets a sentence instead.
     *
     * @param output name of the picture
     * @param region what is shown of it
     * @param cancellation of its drawing, if the user asks for that in the window
     * @param encoder a thread that meets Java's picture classes; two that first meet them in different orders may wait for
     *        each other for ever, so its end is awaited
     * @return the window, which is there soon; none if it cannot be
     */
    static Optional<Preview> open(String output, Region region, Cancellation cancellation, Thread encoder) {
        awaitEnd(encoder);
        Optional<String> obstacle = obstacle(region, 1);
        if (obstacle.isPresent()) {
            complain(obstacle.get());
            return Optional.empty();
        }
        Preview preview = new Preview(output, region);
        EventQueue.invokeLater(() -> {
            try {
                preview.openWindow(PreviewWindow.Escape.STOPS, "", cancellation::request, preview::noteClosed);
            } catch (RuntimeException | Error failure) {     // as in a system without fonts
                preview.noteClosed();
                complain("the window could not be opened (" + failure + ")");
            }
        });
        return Optional.of(preview);
    }

    private static void complain(String obstacle) {
        System.err.println("--preview: " + obstacle + "; drawing goes on without it");
    }

    /**
     * Opens a window for one picture after the other.
     *
     * @param output name of the pictures
     * @param region what is shown of them
     * @param scene name of the scene file
     * @param closed is run in another thread when the window is closed, which Esc does too
     * @param encoder as above
     * @return the window
     * @throws RayTracerException if there is no place for a window
     * @throws IOException if it cannot be opened
     */
    static Preview openToWatch(String output, Region region, String scene, Runnable closed, Thread encoder)
            throws RayTracerException, IOException {
        awaitEnd(encoder);
        Optional<String> obstacle = obstacle(region, PICTURES_OF_A_WATCHED_SCENE);
        if (obstacle.isPresent()) {
            throw new RayTracerException("--watch: " + obstacle.get());
        }
        Preview preview = new Preview(output, region);
        try {
            EventQueue.invokeAndWait(() -> preview.openWindow(PreviewWindow.Escape.CLOSES,
                "drawn again whenever " + scene + " is saved", closed, closed));
        } catch (InvocationTargetException failure) {
            throw new IOException("--watch: the window could not be opened (" + failure.getCause() + ")");
        } catch (InterruptedException request) {
            Thread.currentThread().interrupt();      // the wait for the first picture ends then
        }
        return preview;
    }

    private static void awaitEnd(Thread thread) {
        try {
            thread.join();
        } catch (InterruptedException request) {
            Thread.currentThread().interrupt();      // the request to end is passed on
        }
    }

    private static Optional<String> obstacle(Region region, int pictures) {
        if (region.pixelCount() > MOST_PIXELS) {
            return Optional.of("pictures of more than " + MOST_PIXELS + " pixels are not shown");
        }
        if (pictures * BYTES_IN_A_PIXEL * region.pixelCount() > Runtime.getRuntime().maxMemory() / SHARE_OF_MEMORY) {
            return Optional.of("not enough memory to show so many pixels");
        }
        return Display.obstacle();
    }

    private void openWindow(PreviewWindow.Escape escape, String idle, Runnable stop, Runnable close) {
        window = Optional.of(new PreviewWindow(output, picture, escape, idle, stop, close));
    }

    private void noteClosed() {
        picture.release();
        synchronized (this) {
            isClosed = true;
            notifyAll();
        }
    }

    private void inWindow(Consumer<PreviewWindow> deed) {
        EventQueue.invokeLater(() -> window.ifPresent(deed));
    }

    /** Begins another picture, over the last one that was finished. */
    void renew() {
        ShownPicture next = finished.copy();
        picture = next;
        inWindow(open -> open.showSoon(next));
    }

    /** To be told what the picture looks like. */
    DrawingListener listener() {
        return picture;
    }

    /** From now on, the title says how far a drawing is. */
    void follow(Drawing drawing) {
        Pace pace = new Pace(System.nanoTime());
        inWindow(open -> open.follow(() -> {
            pace.advance(drawing.share(), System.nanoTime());
            return title(pace);
        }));
    }

    private String title(Pace pace) {
        OptionalDouble left = pace.secondsLeft();
        return output + " - " + pace.percent() + " %"
            + (left.isEmpty() ? "" : ", " + Clock.text(left.getAsDouble()) + " left");
    }

    /** What is to be known about the scene, over the picture; it takes the place of what was said before. */
    void say(List<String> sentences) {
        inWindow(open -> open.say(sentences));
    }

    /** The picture is what it will be, which the title says. */
    void end(String summary) {
        ShownPicture ended = picture;
        finished = ended;
        inWindow(open -> open.end(ended, summary));
    }

    /** There is no new picture: the last one that was finished is shown again, and why. */
    void fail(List<String> sentences) {
        ShownPicture last = finished;
        inWindow(open -> {
            open.end(last, sentences.get(0));
            open.say(sentences);
        });
    }

    /** Waits until the window is closed, if it is not. */
    synchronized void awaitClosed() {
        try {
            while (!isClosed) {
                wait();
            }
        } catch (InterruptedException request) {
            Thread.currentThread().interrupt();      // the request to end is passed on
        }
    }
}
