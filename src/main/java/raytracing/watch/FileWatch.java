package raytracing.watch;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardWatchEventKinds;
import java.nio.file.WatchEvent;
import java.nio.file.WatchKey;
import java.nio.file.WatchService;
import java.util.List;
import java.util.concurrent.TimeUnit;
import raytracing.film.Links;

/**
 * Notices when a file is saved. Editors do that in many ways: they write into it, or they write another file and give it this
 * one's name. So its folder is watched, and if the file is a link, also the folder of what it leads to.
 */
final class FileWatch {
    /**
     * Network folders tell of no changes that other machines make, and some systems tell late: so often the file itself is
     * looked at.
     */
    private static final long LOOK_MILLISECONDS = 500;

    private final Path file;
    private final Runnable saved;
    private final WatchService folders;
    private FileStamp stamp;

    private FileWatch(Path file, Runnable saved, WatchService folders) {
        this.file = file;
        this.saved = saved;
        this.folders = folders;
        stamp = FileStamp.of(file);
    }

    /**
     * Begins to watch a file, in a thread of its own, until the program ends.
     *
     * @param file that need not be there
     * @param saved is run in that thread whenever the file may have changed, also when it is gone
     * @throws IOException if the system allows no more watching
     */
    static void begin(Path file, Runnable saved) throws IOException {
        FileWatch watch = new FileWatch(file, saved, file.getFileSystem().newWatchService());
        Thread thread = new Thread(watch::watch, "file watch");
        thread.setDaemon(true);
        thread.start();
    }

    private void watch() {
        try {
            for (;;) {
                List<Path> names = Links.from(file.toAbsolutePath());
                watchFolders(names);
                if (isTold(names) | isChanged()) {
                    saved.run();
                }
            }
        } catch (InterruptedException request) {
            Thread.currentThread().interrupt();      // then nothing is watched any more
        }
    }

    /** Again and again: folders may be removed and come back, and links may lead elsewhere. */
    private void watchFolders(List<Path> names) {
        for (Path name : names) {
            try {
                name.resolveSibling("").register(folders, StandardWatchEventKinds.ENTRY_CREATE,
                    StandardWatchEventKinds.ENTRY_MODIFY, StandardWatchEventKinds.ENTRY_DELETE);
            } catch (IOException missing) {
                // the file is looked at now and then
            }
        }
    }

    /** Waits for news of the folders, but not long; whether it may be about one of the names. */
    private boolean isTold(List<Path> names) throws InterruptedException {
        boolean isTold = false;
        WatchKey key = folders.poll(LOOK_MILLISECONDS, TimeUnit.MILLISECONDS);
        if (key != null) {
            for (WatchEvent<?> event : key.pollEvents()) {
                for (Path name : names) {
                    isTold |= !(event.context() instanceof Path changed) || name.endsWith(changed);
                }
            }
            key.reset();
        }
        return isTold;
    }

    private boolean isChanged() {
        FileStamp before = stamp;
        stamp = FileStamp.of(file);
        return !stamp.equals(before);
    }
}
