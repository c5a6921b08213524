package raytracing.watch;

import java.nio.file.Path;
import java.util.Optional;
import raytracing.render.Cancellation;

/**
 * The saves of a scene file, each of which is a picture to be drawn, and the end of them. Several threads tell of them; the
 * one that draws waits for them.
 */
final class Saves {
    /** For so long a file must not have changed: an editor may still be writing it. */
    static final long STILL_MILLISECONDS = 50;

    private static final long MILLION = 1_000_000;

    private final Path file;
    private boolean isSaved = true;
    private boolean isOver;
    private FileStamp stamp;
    private Cancellation drawing = new Cancellation();

    /** Of a file that was not drawn yet. */
    Saves(Path file) {
        this.file = file;
        stamp = FileStamp.of(file);
    }

    /** The file was saved: what is being drawn is of no use any more. */
    synchronized void note() {
        isSaved = true;
        drawing.request();
        notifyAll();
    }

    /** Nothing is to be drawn any more. */
    synchronized void end() {
        isOver = true;
        drawing.request();
        notifyAll();
    }

    /**
     * Waits until the file was saved since this was asked last, and is not being written.
     *
     * @return for the picture that is to be drawn now: requested as soon as the file is saved again; none at the end
     * @throws InterruptedException if the wait is interrupted
     */
    synchronized Optional<Cancellation> await() throws InterruptedException {
        while (!isSaved && !isOver) {
            wait();
        }
        long now = System.nanoTime();
        long since = now;
        while (!isOver && (isSaved || now - since < MILLION * STILL_MILLISECONDS)) {
            if (isSaved) {
                isSaved = false;
                since = now;
            }
            wait(Math.max(1, STILL_MILLISECONDS - (now - since) / MILLION));
            look();
            now = System.nanoTime();
        }
        drawing = new Cancellation();
        return isOver ? Optional.empty() : Optional.of(drawing);
    }

    /** Notes a save that shows in the file, though nothing told of it yet: as when it was read while it was written. */
    synchronized void look() {
        FileStamp before = stamp;
        stamp = FileStamp.of(file);
        if (!stamp.equals(before)) {
            note();
        }
    }
}
