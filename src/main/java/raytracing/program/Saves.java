package raytracing.program;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardWatchEventKinds;
import java.nio.file.WatchEvent;
import java.nio.file.WatchKey;
import java.nio.file.WatchService;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import raytracing.film.Links;
import raytracing.render.Cancellation;

/**
 * The saves of a scene file, after each of which a picture is to be drawn, until the window is closed. The thread that draws
 * waits for them; another notes them, which cancels the drawing.
 *
 * <p>Some editors write into the file, others write another file and rename it. So the file's folder is watched, and if the
 * file is a link, also the folders of what it leads to.
 */
final class Saves {
    /** The file must not have changed for so long, since an editor may still be writing it. */
    private static final long STILL_MILLISECONDS = 50;

    /** How often the file itself is checked: network folders do not report changes by other machines, some systems late. */
    private static final long CHECK_MILLISECONDS = 500;

    private static final long MILLION = 1_000_000;

    private final Path file;
    private final WatchService folders;
    private boolean isSaved = true;
    private boolean isOver;
    private Stamp stamp;
    private Cancellation drawing = new Cancellation();

    /** The state of a file, so far as it is known without reading it. The identity is another one if an editor replaced it. */
    private record Stamp(long size, FileTime lastChange, String identity) {
        /** Of the file that a name leads to, through links. */
        private static Stamp of(Path file) {
            try {
                BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
                return new Stamp(attributes.size(), attributes.lastModifiedTime(), String.valueOf(attributes.fileKey()));
            } catch (IOException missing) {
                return new Stamp(-1, FileTime.fromMillis(0), "none");
            }
        }
    }

    /**
     * Of a file that need not exist, and is not drawn yet, which counts as a save.
     *
     * @throws IOException if the system allows no more watching
     */
    Saves(Path file) throws IOException {
        this.file = file;
        folders = file.getFileSystem().newWatchService();
        stamp = Stamp.of(file);
    }

    /** Begins to note the saves, in a thread of its own until the program ends. */
    void begin() {
        Thread thread = new Thread(this::watch, "file watch");
        thread.setDaemon(true);
        thread.start();
    }

    private void watch() {
        try {
            for (;;) {
                List<Path> names = Links.from(file.toAbsolutePath());
                watchFolders(names);
                if (isReported(names)) {
                    note();
                }
                checkFile();
            }
        } catch (InterruptedException request) {
            Thread.currentThread().interrupt();      // ends the watching
        }
    }

    /** Is repeated, since folders may be removed and come back, and links may lead elsewhere. */
    private void watchFolders(List<Path> names) {
        for (Path name : names) {
            try {
                name.resolveSibling("").register(folders, StandardWatchEventKinds.ENTRY_CREATE,
                    StandardWatchEventKinds.ENTRY_MODIFY, StandardWatchEventKinds.ENTRY_DELETE);
            } catch (IOException missing) {
                // the file itself is checked from time to time
            }
        }
    }

    /** Waits a short time for reports of the folders; true if one may be about one of the names. */
    private boolean isReported(List<Path> names) throws InterruptedException {
        boolean isReported = false;
        WatchKey key = folders.poll(CHECK_MILLISECONDS, TimeUnit.MILLISECONDS);
        if (key != null) {
            for (WatchEvent<?> event : key.pollEvents()) {
                isReported |= !(event.context() instanceof Path changed)
                    || names.stream().anyMatch(name -> name.endsWith(changed));
            }
            key.reset();
        }
        return isReported;
    }

    /** The file was or may be saved: what is being drawn is out of date. */
    private synchronized void note() {
        isSaved = true;
        drawing.request();
        notifyAll();
    }

    /** Notes a save if the file has another stamp than at the last check. */
    synchronized void checkFile() {
        Stamp before = stamp;
        stamp = Stamp.of(file);
        if (!stamp.equals(before)) {
            note();
        }
    }

    /** No picture is to be drawn any more. */
    synchronized void end() {
        isOver = true;
        drawing.request();
        notifyAll();
    }

    /**
     * Waits until the file was saved since the last call and is not being written.
     *
     * @return for the picture that is to be drawn now, requested at the next save; empty at the end
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
            checkFile();
            now = System.nanoTime();
        }
        drawing = new Cancellation();
        return isOver ? Optional.empty() : Optional.of(drawing);
    }
}
