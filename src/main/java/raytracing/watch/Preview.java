package raytracing.watch;

import java.awt.EventQueue;
import java.util.Optional;
import java.util.OptionalDouble;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.render.Cancellation;
import raytracing.render.Drawing;
import raytracing.render.DrawingListener;
import raytracing.render.Region;

/**
 * A window that shows a picture while it is drawn, and until it is closed. Its own thread opens and paints it; those that
 * draw only note what they drew. Nothing that happens to the window harms the picture.
 */
final class Preview implements DrawingListener {
    /** Larger pictures are not shown: this many take 256 MB. */
    static final long MOST_PIXELS = 1 << 26;

    private static final int BYTES_IN_A_PIXEL = 4;

    /** A window takes no more of the memory than one part in so many: the drawing must not lack it. */
    private static final int SHARE_OF_MEMORY = 4;

    /** The coarsest look is there at once, the next one shows what it is going to be. */
    private static final int[] LOOKS = {16, 4};
    private static final int[] NO_LOOKS = {};

    private final String output;
    private final ShownPicture picture;
    private final Cancellation cancellation;

    /** Only Swing's thread opens and asks for it. */
    private Optional<PreviewWindow> window = Optional.empty();
    private boolean isClosed;

    private Preview(String output, ShownPicture picture, Cancellation cancellation) {
        this.output = output;
        this.picture = picture;
        this.cancellation = cancellation;
    }

    /**
     * Begins to open a window. Where there can be none, standard error gets a sentence instead.
     *
     * @param output name of the picture
     * @param region what is shown of it
     * @param cancellation of its drawing, if the user wishes that in the window
     * @param encoder a thread that meets Java's picture classes; two that first meet them in different orders may wait for
     *        each other for ever, so its end is awaited
     * @return the window, which is there soon; none if it cannot be
     */
    static Optional<Preview> open(String output, Region region, Cancellation cancellation, Thread encoder) {
        awaitEnd(encoder);
        Optional<String> obstacle = obstacle(region);
        if (obstacle.isPresent()) {
            complain(obstacle.get());
            return Optional.empty();
        }
        Preview preview = new Preview(output, new ShownPicture(region), cancellation);
        EventQueue.invokeLater(preview::openWindow);
        return Optional.of(preview);
    }

    private static void awaitEnd(Thread thread) {
        try {
            thread.join();
        } catch (InterruptedException request) {
            Thread.currentThread().interrupt();      // whoever asks for the end gets it
        }
    }

    private static Optional<String> obstacle(Region region) {
        if (region.pixelCount() > MOST_PIXELS) {
            return Optional.of("pictures of more than " + MOST_PIXELS + " pixels are not shown");
        }
        if (BYTES_IN_A_PIXEL * region.pixelCount() > Runtime.getRuntime().maxMemory() / SHARE_OF_MEMORY) {
            return Optional.of("not enough memory to show so many pixels");
        }
        return Display.obstacle();
    }

    private static void complain(String obstacle) {
        System.err.println("--preview: " + obstacle + "; drawing goes on without it");
    }

    /** What can still go wrong, as a system without fonts, must not be seen as a stack trace. */
    private void openWindow() {
        try {
            window = Optional.of(new PreviewWindow(output, picture, new PreviewWindow.Wishes() {
                @Override
                public void stop() {
                    cancellation.request();
                }

                @Override
                public void close() {
                    noteClosed();
                }
            }));
        } catch (RuntimeException | Error failure) {
            noteClosed();
            complain("the window could not be opened (" + failure + ")");
        }
    }

    private void noteClosed() {
        picture.release();
        synchronized (this) {
            isClosed = true;
            notifyAll();
        }
    }

    /** From now on, the title says how far a drawing is. */
    void follow(Drawing drawing) {
        Pace pace = new Pace(System.nanoTime());
        EventQueue.invokeLater(() -> window.ifPresent(open -> open.follow(() -> {
            pace.advance(drawing.share(), System.nanoTime());
            return title(pace);
        })));
    }

    private String title(Pace pace) {
        OptionalDouble left = pace.secondsLeft();
        return output + " - " + pace.percent() + " %"
            + (left.isEmpty() ? "" : ", " + Clock.text(left.getAsDouble()) + " left");
    }

    /** The picture is what it will be, which the title says. */
    void end(String summary) {
        EventQueue.invokeLater(() -> window.ifPresent(open -> open.end(summary)));
    }

    /** Waits until the window is closed, if it is not. */
    synchronized void awaitClosed() {
        try {
            while (!isClosed) {
                wait();
            }
        } catch (InterruptedException request) {
            Thread.currentThread().interrupt();      // whoever asks for the end gets it
        }
    }

    @Override
    public int[] coarseLooks() {
        return picture.isReleased() ? NO_LOOKS : LOOKS;
    }

    @Override
    public void showSquare(Region square, Color light) {
        picture.show(square, light);
    }

    @Override
    public void showTile(Region tile, Film film, Region filmed) {
        picture.show(tile, film, filmed);
    }
}
