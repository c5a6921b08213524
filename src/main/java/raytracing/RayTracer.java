package raytracing;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import raytracing.film.Bands;
import raytracing.film.ImageFile;
import raytracing.parallel.ForkJoin;
import raytracing.parse.ParsedScene;
import raytracing.parse.RayTracerException;
import raytracing.parse.SceneParser;
import raytracing.program.Command;
import raytracing.program.CommandLine;
import raytracing.program.ComparedPicture;
import raytracing.program.Failures;
import raytracing.program.Option;
import raytracing.program.Reporter;
import raytracing.program.Watch;
import raytracing.render.CancelledException;
import raytracing.render.Drawing;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.scene.Scene;

/**
 * The program: {@code java -jar RayTracer.jar SCENE OUTPUT [WIDTH HEIGHT] [options]}. Every picture takes three steps:
 * {@link #parseScene}, {@link #renderScene} and {@link #saveImage}; with {@code --compare} there is a fourth one,
 * {@link #comparePicture}.
 */
public final class RayTracer {
    private static final int DONE = 0;
    private static final int MACHINE_FAILED = 1;
    private static final int USER_IS_WRONG = 2;

    /** As after SIGINT, also if the Escape key in the window stopped the drawing. */
    private static final int STOPPED = 130;

    private RayTracer() {
    }

    /** Runs the program and ends the virtual machine with the exit status that {@code --help} lists. */
    public static void main(String[] arguments) {
        int status = run(arguments);
        if (status == MACHINE_FAILED) {
            // While a signal ends the program, exit() would wait for the shutdown hooks, and those wait for this thread.
            Runtime.getRuntime().halt(status);
        }
        System.exit(status);
    }

    /** Whatever happens, the user gets sentences on standard error and never a stack trace. */
    private static int run(String[] arguments) {
        try {
            Command command = CommandLine.parse(arguments);
            if (command instanceof Command.Draw draw) {
                return draw.wants(Option.WATCH) ? drawAtEverySave(draw) : drawOnce(draw);
            }
            Reporter.printOutput(command instanceof Command.Help ? CommandLine.HELP : version());
            return DONE;
        } catch (RayTracerException wrong) {
            return failed(USER_IS_WRONG, wrong.messages());
        } catch (IOException failure) {
            return failed(MACHINE_FAILED, Failures.messages(failure));
        } catch (RuntimeException | Error failure) {
            Optional<String> broken = brokenInstallation(failure);
            return failed(MACHINE_FAILED, broken.isPresent() ? List.of(broken.get()) : Failures.messages(failure));
        }
    }

    static int drawOnce(Command.Draw command) throws RayTracerException, IOException {
        Reporter reporter = new Reporter(command);
        draw(command, reporter);
        return reporter.finish() ? DONE : STOPPED;
    }

    /** {@code --watch}: the same three steps whenever the scene file is saved, until the window is closed. */
    private static int drawAtEverySave(Command.Draw command) throws RayTracerException, IOException {
        Watch watch = Watch.open(command);
        for (Optional<Reporter> next = watch.awaitSave(); next.isPresent(); next = watch.awaitSave()) {
            try {
                draw(command, next.get());
            } catch (RayTracerException | IOException | RuntimeException | OutOfMemoryError | StackOverflowError failure) {
                watch.fail(failure);
            }
        }
        return DONE;
    }

    private static void draw(Command.Draw command, Reporter reporter) throws RayTracerException, IOException {
        try {
            reporter.begin();
            Scene scene = parseScene(command.scene(), command.settings().threads(), reporter);
            Drawing picture = renderScene(scene, command.settings(), reporter);
            saveImage(picture, reporter.file(), reporter);
            Optional<ComparedPicture> other = reporter.beginComparison();
            if (other.isPresent()) {
                comparePicture(other.get(), reporter);
            }
        } catch (CancelledException stopped) {
            reporter.stopped();
        } finally {
            reporter.end();
        }
    }

    /**
     * The first step: reads a scene file, on so many threads if it is long, and reports its warnings.
     *
     * @throws RayTracerException if the file is missing or wrong; has a message for each mistake, up to 20
     * @throws IOException if the file cannot be read
     */
    public static Scene parseScene(Path file, int threads, Reporter reporter) throws RayTracerException, IOException {
        ParsedScene parsed = SceneParser.parseFile(file, new ForkJoin(threads, reporter.preparation()));
        reporter.parsed(parsed);
        return parsed.scene();
    }

    /**
     * The second step: makes the scene ready and estimates its ambient light. The pixels are drawn lazily, band by band, while
     * {@link #saveImage} writes the picture; so a picture may be larger than memory.
     */
    public static Drawing renderScene(Scene scene, RenderSettings settings, Reporter reporter) {
        return reporter.drawing(scene, Renderer.of(scene, settings, reporter.preparation()));
    }

    /**
     * The third step: draws the bands of a picture, writes them into its file and reports that.
     *
     * @throws CancelledException if the drawing is cancelled; the older file stays
     * @throws IOException if the file cannot be written; the older file stays
     */
    public static void saveImage(Bands picture, ImageFile file, Reporter reporter) throws IOException {
        try {
            file.write(picture);
        } catch (IOException failure) {
            throw reporter.notSaved(failure);
        }
        reporter.saved();
    }

    /**
     * The fourth step, of {@code --compare} alone: reads the picture back from its file, prints how far it is from another
     * one, and writes the map of {@code --compare-map}.
     *
     * @throws IOException if one of the two cannot be read, or the map not be written; the picture stays in its file
     */
    private static void comparePicture(ComparedPicture other, Reporter reporter) throws IOException {
        reporter.compared(other.compare());
        Optional<String> map = other.writeMap();
        if (map.isPresent()) {
            reporter.mapped(map.get());
        }
    }

    private static int failed(int status, List<String> messages) {
        for (String message : messages) {
            System.err.println(message);
        }
        return status;
    }

    /**
     * Explains why a class could not be loaded; empty after other failures. Uses no class of the program, since that may be
     * the one that cannot be loaded.
     */
    private static Optional<String> brokenInstallation(Throwable thrown) {
        Throwable cause = thrown;
        while (cause.getCause() != null) {
            cause = cause.getCause();
        }
        if (String.valueOf(cause.getMessage()).contains("Too many open files")) {
            return Optional.of("the system allows too few open files; after ulimit -n 64 there are enough");
        }
        if (!(thrown instanceof LinkageError)) {
            return Optional.empty();
        }
        return Optional.of(ModuleLayer.boot().findModule("java.desktop").isEmpty()
            ? "this Java has no java.desktop, which jpg, gif, windows and --compare need; a whole Java runtime has it"
            : "a part of Java or of the program cannot be loaded (" + cause
                + "); if none was replaced now, install both again");
    }

    private static String version() {
        String version = Optional.ofNullable(RayTracer.class.getPackage().getImplementationVersion()).orElse("unpacked");
        return "RayTracer " + version + System.lineSeparator();
    }
}
