package raytracing.watch;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import raytracing.command.Command;
import raytracing.command.Extra;
import raytracing.film.ImageFile;
import raytracing.parse.ParsedScene;
import raytracing.parse.Printable;
import raytracing.parse.RayTracerException;
import raytracing.parse.SceneParser;
import raytracing.progress.Preparation;
import raytracing.render.Cancellation;
import raytracing.render.CancelledException;
import raytracing.render.Drawing;
import raytracing.render.DrawingListener;
import raytracing.render.Renderer;
import raytracing.scene.Scene;

/** One picture, from the scene's file to its own, with all that is said and shown on the way. */
public final class Session {
    private final Command.Draw command;
    private final Messages messages;
    private final ImageFile file;
    private final Cancellation cancellation;
    private final long start = System.nanoTime();
    private final Preparation preparation = new Preparation();
    private Optional<ProgressLine> line = Optional.empty();
    private long parsingNanoseconds;

    /** One that begins now, and ends when that is asked for. */
    Session(Command.Draw command, Cancellation cancellation) {
        this.command = command;
        this.cancellation = cancellation;
        messages = new Messages(command.output().toString(), command.format(), command.settings());
        file = new ImageFile(command.output(), command.format());
        Thread.setDefaultUncaughtExceptionHandler(messages);
    }

    /**
     * Draws what the user asked for.
     *
     * @param command what that is
     * @return whether there is a whole picture; if not, it was cancelled
     * @throws RayTracerException if the scene or the file's name is wrong
     * @throws IOException if a file cannot be read or written; then whatever stood there before still does
     */
    public static Outcome draw(Command.Draw command) throws RayTracerException, IOException {
        if (command.wants(Extra.WATCH)) {
            return Watch.run(command);
        }
        Session session = new Session(command, new Cancellation());
        try {
            return session.draw();
        } finally {
            session.endLine();
        }
    }

    /** How it ended. */
    public enum Outcome {
        /** With a whole picture. */
        FINISHED,

        /** By the user's wish. */
        STOPPED
    }

    private Outcome draw() throws RayTracerException, IOException {
        Thread encoder = begin();
        ParsedScene parsed = read();
        Optional<Preview> preview = command.wants(Extra.PREVIEW) ? Preview.open(command.output().toString(),
            command.settings().region(), cancellation, encoder) : Optional.empty();
        Interruption interruption = Interruption.install(cancellation);
        Outcome outcome = draw(parsed, preview);
        interruption.end();                      // not after a failure, which has a status of its own
        if (outcome == Outcome.FINISHED && preview.isPresent()) {
            preview.get().awaitClosed();
        }
        return outcome;
    }

    /** Refuses what cannot become a picture file, and begins to load what writes it. */
    Thread begin() throws RayTracerException, IOException {
        refuseOutputThatCannotBe();
        return file.prepare();
    }

    /** Refuses what cannot become a picture file. */
    void refuseOutputThatCannotBe() throws RayTracerException, IOException {
        Optional<String> obstacle;
        try {
            obstacle = file.obstacle(command.scene());
        } catch (IOException failure) {
            throw new IOException(messages.failed(failure));
        }
        if (obstacle.isPresent()) {
            throw new RayTracerException(command.output() + ": " + obstacle.get());
        }
    }

    /** Reads the scene, under a line of progress on a terminal, and says what is unlikely to be meant in it. */
    ParsedScene read() throws RayTracerException, IOException {
        if (!command.wants(Extra.QUIET) && ProgressLine.isWanted()) {
            line = Optional.of(ProgressLine.begin(Printable.of(command.output().toString()), preparation, start));
        }
        ParsedScene parsed = SceneParser.parseFile(command.scene(), preparation);
        parsingNanoseconds = System.nanoTime() - start;
        for (String warning : parsed.warnings()) {
            say(warning);
        }
        return parsed;
    }

    /** Draws and writes the picture, and says so. */
    Outcome draw(ParsedScene parsed, Optional<Preview> preview) throws IOException {
        Scene scene = parsed.scene();
        Renderer renderer = new Renderer(scene, command.settings(), preparation);
        Drawing drawing = renderer.drawing(cancellation, command.wants(Extra.KEEP_PARTIAL)
            ? Cancellation.Leftovers.KEEP : Cancellation.Leftovers.DISCARD,
            preview.isPresent() ? preview.get().listener() : DrawingListener.NONE);
        if (preview.isPresent()) {
            preview.get().say(parsed.warnings());
            preview.get().follow(drawing);
        }
        long writing = System.nanoTime();
        boolean isWritten = write(drawing);
        long end = System.nanoTime();
        Outcome outcome = isWritten && !drawing.isPartial() ? Outcome.FINISHED : Outcome.STOPPED;
        String summary = outcome == Outcome.FINISHED
            ? messages.finished(drawing, renderer.ambientLight(), end - start) : messages.stopped(drawing);
        say(summary);
        if (outcome == Outcome.FINISHED) {
            List<String> warnings = warnings(parsed, drawing);
            if (preview.isPresent()) {
                preview.get().say(warnings);
                preview.get().end(summary);
            }
        }
        if (isWritten && (command.wants(Extra.STATISTICS) || command.wants(Extra.STATISTICS_AS_JSON))) {
            report(Statistics.of(command.scene().toString(), scene, command.settings(), renderer, drawing,
                new Statistics.Times(parsingNanoseconds, end - writing, end - start)));
        }
        return outcome;
    }

    /** All that is unlikely to be meant. What only a finished picture tells is said here. */
    private List<String> warnings(ParsedScene parsed, Drawing drawing) {
        List<String> warnings = new ArrayList<>(parsed.warnings());
        if (messages.isOfNothing(drawing) && !parsed.scene().surfaces().isEmpty()) {
            String nothing = Messages.nothingMet(command.scene().toString());
            say(nothing);
            warnings.add(nothing);
        }
        return warnings;
    }

    /**
     * Draws and writes, under a line of progress where somebody reads it.
     *
     * @return false if there is no picture because nobody wants it
     */
    private boolean write(Drawing drawing) throws IOException {
        if (line.isPresent()) {
            line.get().follow(drawing);
        } else {
            say(messages.begun(command.scene().toString()));
        }
        try {
            file.write(drawing);
            return true;
        } catch (CancelledException asWished) {
            return false;
        } catch (IOException failure) {
            throw new IOException(messages.failed(failure));
        } finally {
            endLine();
        }
    }

    /** Takes the line of progress away, if there is one. */
    void endLine() {
        if (line.isPresent()) {
            line.get().end();
        }
    }

    private void say(String sentence) {
        if (line.isPresent()) {
            line.get().say(Printable.of(sentence));
        } else if (!command.wants(Extra.QUIET)) {
            System.err.println(Printable.of(sentence));
        }
    }

    private void report(Statistics statistics) throws IOException {
        if (command.wants(Extra.STATISTICS)) {
            System.err.print(statistics.text());
        }
        if (command.wants(Extra.STATISTICS_AS_JSON)) {
            StandardOutput.print(statistics.json());
        }
    }
}
