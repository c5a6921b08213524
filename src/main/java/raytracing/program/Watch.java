package raytracing.program;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import raytracing.parse.RayTracerException;
import raytracing.preview.Preview;
import raytracing.render.Cancellation;

/**
 * A scene that is drawn again whenever its file is saved, into a window and the picture's file, until the window is closed.
 * The pictures are drawn one after the other; a save and the end of the window cancel the one that is being drawn.
 */
public final class Watch {
    private final Command.Draw command;
    private final Saves saves;
    private final Preview preview;
    private Cancellation cancellation = new Cancellation();

    private Watch(Command.Draw command, Saves saves, Preview preview) {
        this.command = command;
        this.saves = saves;
        this.preview = preview;
    }

    /**
     * Opens the window and begins to watch the scene file.
     *
     * @throws RayTracerException if no window can be opened, or the output cannot become a picture file
     * @throws IOException if the system does not let the window be opened or the file be watched
     */
    public static Watch open(Command.Draw command) throws RayTracerException, IOException {
        Reporter first = new Reporter(command);
        Optional<Thread> encoder = first.prepareOutput();
        first.end();
        Saves saves = new Saves(command.scene());
        Preview preview = Preview.openToWatch(command.output().toString(), command.settings().region(),
            command.scene().toString(), saves::end, encoder);
        saves.begin();
        return new Watch(command, saves, preview);
    }

    /** Waits until a picture is to be drawn, at first at once; empty when the window is closed. */
    public Optional<Reporter> awaitSave() {
        try {
            Optional<Cancellation> next = saves.await();
            cancellation = next.orElse(cancellation);
            return next.map(request -> new Reporter(command, request, Optional.of(preview), Optional.of(saves)));
        } catch (InterruptedException request) {
            Thread.currentThread().interrupt();      // the request to end is passed on
            return Optional.empty();
        }
    }

    /** Prints and shows why there is no picture, unless the scene was saved again meanwhile. */
    public void fail(Throwable failure) {
        saves.checkFile();                           // half of a file is read if it is being written
        if (!cancellation.isRequested()) {
            List<String> sentences = Failures.messages(failure);
            sentences.forEach(System.err::println);
            preview.fail(sentences);
        }
    }
}
