package raytracing.program;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import raytracing.film.Comparison;
import raytracing.film.ImageFile;
import raytracing.parallel.Preparation;
import raytracing.parse.ParsedScene;
import raytracing.parse.Printable;
import raytracing.parse.RayTracerException;
import raytracing.preview.Preview;
import raytracing.render.Cancellation;
import raytracing.render.CancelledException;
import raytracing.render.Drawing;
import raytracing.render.DrawingListener;
import raytracing.render.Renderer;
import raytracing.scene.Scene;

/**
 * Reports to the user about one picture while it is made: messages, progress line, window and statistics. Signals and the
 * window cancel the drawing through it.
 */
public final class Reporter implements Thread.UncaughtExceptionHandler {
    private final Command.Draw command;
    private final Cancellation cancellation;
    private final Interruption interruption;
    private final Optional<Saves> saves;
    private final Messages messages;
    private final ImageFile file;
    private final long start = System.nanoTime();
    private final Preparation preparation = new Preparation();
    private final ProgressLine line;
    private final List<String> warnings = new ArrayList<>();
    private Optional<Preview> preview;
    private Optional<Thread> encoder = Optional.empty();
    private Optional<Prepared> prepared = Optional.empty();
    private Optional<ComparedPicture> compared = Optional.empty();

    /** Of {@code --stats=json}, printed when the comparison is in it. */
    private Optional<Statistics> statistics = Optional.empty();
    private long parsedAt;
    private boolean isLineShown;
    private boolean isWhole;
    private boolean isLostThreadReported;

    /** What is drawn, and since when. */
    private record Prepared(Scene scene, Renderer renderer, Drawing drawing, long time) {
    }

    /** For a picture that is drawn once. */
    public Reporter(Command.Draw command) {
        this(command, new Cancellation(), Optional.empty(), Optional.empty());
    }

    /** For a picture of a watched scene if there are saves: then the window is open, and the next save cancels the drawing. */
    Reporter(Command.Draw command, Cancellation cancellation, Optional<Preview> preview, Optional<Saves> saves) {
        this.command = command;
        this.cancellation = cancellation;
        interruption = new Interruption(cancellation);
        this.preview = preview;
        this.saves = saves;
        messages = new Messages(command.output().toString(), command.format(), command.settings());
        file = new ImageFile(command.output(), command.format());
        line = new ProgressLine(System.err, Printable.of(command.output().toString()), preparation, start);
        Thread.setDefaultUncaughtExceptionHandler(this);
    }

    /** Where the picture is written. */
    public ImageFile file() {
        return file;
    }

    /** Takes what the preparation of the drawing reports. */
    public Preparation preparation() {
        return preparation;
    }

    /**
     * Before the scene is read: prepares the output and begins the progress line.
     *
     * @throws RayTracerException if the output cannot become a picture file
     * @throws IOException if the machine fails, for instance with a full disk
     */
    public void begin() throws RayTracerException, IOException {
        if (saves.isPresent()) {
            interruption.begin();
        }
        if (!command.wants(Option.QUIET) && ProgressLine.isOnTerminal()) {
            isLineShown = true;
            line.begin();
        }
        encoder = prepareOutput();
    }

    /**
     * Refuses an output that cannot become a picture file, and what cannot be compared with it; else begins to load what
     * writes the file, in the thread returned, if that takes a while. The picture to compare with is read before, as it
     * needs some of the same classes of Java.
     */
    Optional<Thread> prepareOutput() throws RayTracerException, IOException {
        Optional<String> obstacle;
        try {
            obstacle = file.obstacle(command.scene());
        } catch (IOException failure) {
            throw notSaved(failure);
        }
        if (obstacle.isPresent()) {
            throw new RayTracerException(command.output() + ": " + obstacle.get());
        }
        if (command.compare().isPresent()) {
            compared = Optional.of(ComparedPicture.open(command, command.compare().get()));
        }
        Optional<Thread> loader = file.prepare();
        return loader.isEmpty() && compared.isPresent() ? compared.get().prepareMap() : loader;
    }

    /**
     * The scene is read: prints its warnings, opens the window of {@code --preview}, and lets signals cancel the drawing.
     *
     * @throws CancelledException if a watched scene was saved again meanwhile
     */
    public void parsed(ParsedScene parsed) {
        parsedAt = System.nanoTime();
        warnings.addAll(parsed.warnings());
        for (String warning : warnings) {
            print(warning);
        }
        if (saves.isPresent()) {
            saves.get().checkFile();             // what was read of a file that changed meanwhile may be half of it
            if (cancellation.isRequested()) {
                throw new CancelledException();
            }
            preview.get().renew();
        } else {
            if (command.wants(Option.PREVIEW)) {
                preview = Preview.open(command.output().toString(), command.settings().region(), cancellation, encoder);
            }
            interruption.begin();
        }
    }

    /** The scene is ready: the drawing of it, which is about to begin. Progress line and window follow it. */
    public Drawing drawing(Scene scene, Renderer renderer) {
        Drawing drawing = new Drawing(renderer, cancellation,
            command.wants(Option.KEEP_PARTIAL) ? Cancellation.Leftovers.KEEP : Cancellation.Leftovers.DISCARD,
            preview.isPresent() ? preview.get().listener() : DrawingListener.NONE);
        if (preview.isPresent()) {
            Pace pace = new Pace(System.nanoTime());
            preview.get().showMessages(warnings);
            preview.get().follow(() -> {
                pace.advance(drawing.progress().share(), System.nanoTime());
                return pace.percent() + " %" + pace.left(", ");
            });
        }
        prepared = Optional.of(new Prepared(scene, renderer, drawing, System.nanoTime()));
        if (isLineShown) {
            line.follow(drawing);
        } else {
            print(messages.begun(command.scene().toString()));
        }
        return drawing;
    }

    /** The error to throw if the picture file cannot be written; its message says what the file contains now. */
    public IOException notSaved(IOException failure) {
        return Failures.notWritten(command.output(), failure);
    }

    /**
     * The picture file is written: prints the summary, and the statistics of {@code --stats}; those for programs only if no
     * comparison belongs to them.
     *
     * @throws IOException if standard output takes no statistics
     */
    public void saved() throws IOException {
        long end = System.nanoTime();
        line.end();
        Prepared done = prepared.get();
        isWhole = !done.drawing.isPartial();
        if (isWhole) {
            finishWhole(messages.finished(done.drawing, done.renderer.ambientLight(), end - start), done);
        } else {
            print(messages.stopped(done.drawing));
            if (compared.isPresent()) {
                print(messages.notCompared(compared.get().name()));
            }
        }
        if (command.wants(Option.STATS) || command.wants(Option.STATS_AS_JSON)) {
            printStatistics(new Statistics(command.scene().toString(), done.scene, command.settings(), done.renderer,
                done.drawing, new Statistics.Times(parsedAt - start, end - done.time, end - start)));
        }
    }

    private void printStatistics(Statistics whole) throws IOException {
        if (command.wants(Option.STATS)) {
            System.err.print(whole.text());
        }
        if (command.wants(Option.STATS_AS_JSON) && isToBeCompared()) {
            statistics = Optional.of(whole);
        } else if (command.wants(Option.STATS_AS_JSON)) {
            printOutput(whole.json());
        }
    }

    /**
     * What the picture is to be compared with; empty if nothing is, or if the picture is not whole in its file. As nothing can
     * be lost any more, signals end the program at once from now on.
     */
    public Optional<ComparedPicture> beginComparison() {
        if (!isToBeCompared()) {
            return Optional.empty();
        }
        interruption.end();
        try {
            if (encoder.isPresent()) {
                encoder.get().join();            // two threads that load Java's picture classes may wait for each other
            }
        } catch (InterruptedException request) {
            Thread.currentThread().interrupt();
        }
        return compared;
    }

    private boolean isToBeCompared() {
        return isWhole && compared.isPresent();
    }

    /**
     * The picture is compared: prints how far it is from the other one. With {@code --stats=json}, that is a part of the
     * statistics, so that standard output has nothing but JSON.
     *
     * @throws IOException if standard output does not take it
     */
    public void compared(Comparison comparison) throws IOException {
        String other = compared.get().name();
        String sentence = messages.compared(other, comparison);
        if (statistics.isPresent()) {
            print(sentence);
            statistics.get().addComparison(other, comparison);
            printOutput(statistics.get().json());
        } else {
            printOutput(Printable.of(sentence) + System.lineSeparator());
        }
        if (preview.isPresent()) {
            preview.get().end(sentence);
        }
    }

    /** The map of the differences is written: prints what its colours mean. */
    public void mapped(String map) {
        print(Messages.mapped(map));
    }

    private void finishWhole(String summary, Prepared done) {
        print(summary);
        if (messages.isOfNothing(done.drawing) && !done.scene.surfaces().isEmpty()) {
            String nothing = Messages.nothingMet(command.scene().toString());
            print(nothing);
            warnings.add(nothing);
        }
        if (preview.isPresent()) {
            preview.get().showMessages(warnings);
            preview.get().end(summary);
        }
    }

    /** The drawing was cancelled and no file is written. */
    public void stopped() {
        line.end();
        if (prepared.isPresent()) {
            print(messages.stopped(prepared.get().drawing));
        }
    }

    /** After success and failure: takes the progress line away. A watched scene's next picture gets signals of its own. */
    public void end() {
        line.end();
        if (compared.isPresent()) {
            compared.get().close();
        }
        if (saves.isPresent()) {
            interruption.end();                  // also after a failure: no signal may wait for this drawing any more
        }
    }

    /**
     * After a picture that is drawn once: signals act as usual again, and the window of a whole picture stays open until the
     * user closes it. Not called after a failure, whose own exit status counts more than the signal's.
     *
     * @return whether the whole picture is in its file
     */
    public boolean finish() {
        interruption.end();
        if (isWhole && preview.isPresent()) {
            preview.get().awaitClosed();
        }
        return isWhole;
    }

    /**
     * Prints on standard output.
     *
     * @throws IOException if that fails; Java itself does not report a closed pipe
     */
    public static void printOutput(String lines) throws IOException {
        System.out.print(lines);
        if (System.out.checkError()) {
            throw new IOException("standard output: could not be written");
        }
    }

    private void print(String sentence) {
        if (!command.wants(Option.QUIET)) {
            line.print(Printable.of(sentence));
        }
    }

    /**
     * Reports, once, that a thread failed whose end no other thread awaits. Such threads only show how far the picture is,
     * which is drawn all the same; the window's thread goes on after a failure and may fail each time it paints.
     */
    @Override
    public synchronized void uncaughtException(Thread thread, Throwable thrown) {
        if (!isLostThreadReported) {
            isLostThreadReported = true;
            System.err.println(command.output() + ": drawing goes on without its thread " + thread.getName()
                + " (" + thrown + ")");
        }
    }
}
