package raytracing;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import raytracing.command.Command;
import raytracing.command.CommandLine;
import raytracing.film.Film;
import raytracing.film.ImageFile;
import raytracing.parse.RayTracerException;
import raytracing.parse.SceneParser;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.scene.Scene;
import raytracing.watch.Messages;
import raytracing.watch.Session;
import raytracing.watch.StandardOutput;

/** The program: {@code java -jar RayTracer.jar SCENE OUTPUT [WIDTH HEIGHT] [options]}. */
public final class RayTracer {
    private static final int DONE = 0;
    private static final int MACHINE_FAILED = 1;
    private static final int USER_IS_WRONG = 2;

    /** As after SIGINT, also where the window's Escape key stopped the drawing. */
    private static final int STOPPED = 130;

    private RayTracer() {
    }

    /**
     * Runs the program and ends the virtual machine: with 0 if all is done, 1 if the machine failed, 2 if the scene or
     * the command is wrong, 130 if the user stopped the drawing.
     *
     * @param arguments the command line
     */
    public static void main(String[] arguments) {
        int status = run(arguments);
        if (status == MACHINE_FAILED) {
            // If a signal is ending the program, an exit would wait for that for ever, and that waits for this thread.
            Runtime.getRuntime().halt(status);
        }
        System.exit(status);
    }

    /** Whatever happens, the user gets sentences on standard error and never a stack trace. */
    private static int run(String... arguments) {
        try {
            Command command = CommandLine.parse(arguments);
            if (command instanceof Command.Draw draw) {
                return Session.draw(draw) == Session.Outcome.FINISHED ? DONE : STOPPED;
            }
            StandardOutput.print(command instanceof Command.Help ? CommandLine.HELP : version());
            return DONE;
        } catch (RayTracerException wrong) {
            return failed(USER_IS_WRONG, wrong.messages());
        } catch (IOException failure) {
            return failed(MACHINE_FAILED, List.of(Messages.sentence(failure)));
        } catch (OutOfMemoryError tooLarge) {
            return failed(MACHINE_FAILED, List.of(Messages.shortage(tooLarge)));
        } catch (RuntimeException | Error unforeseen) {
            return failed(MACHINE_FAILED, List.of(unforeseen(unforeseen)));
        }
    }

    /** What explains a part that cannot be loaded needs no class of the program: it may be that part. */
    private static String unforeseen(Throwable thrown) {
        Throwable cause = thrown;
        while (cause.getCause() != null) {
            cause = cause.getCause();
        }
        if (String.valueOf(cause.getMessage()).contains("Too many open files")) {
            return "the system allows too few open files; after ulimit -n 64 there are enough";
        }
        if (!(thrown instanceof LinkageError)) {
            return Messages.defect(thrown);
        }
        return ModuleLayer.boot().findModule("java.desktop").isEmpty()
            ? "this Java has no java.desktop, which makes picture files; a whole Java runtime has it"
            : "a part of Java or of the program cannot be loaded (" + cause + "); if none was replaced now, install both again";
    }

    /**
     * First step: reads a scene file.
     *
     * @param file where it is
     * @return the scene it describes
     * @throws RayTracerException if it is missing or wrong; says everything that is, up to 20 lines
     * @throws IOException if it cannot be read
     */
    public static Scene parseScene(Path file) throws RayTracerException, IOException {
        return SceneParser.parseFile(file).scene();
    }

    /**
     * Second step: draws a scene.
     *
     * @param scene what to draw
     * @param settings how
     * @return the finished picture, linear light
     */
    public static Film renderScene(Scene scene, RenderSettings settings) {
        return new Renderer(scene, settings).render();
    }

    /**
     * Third step: writes a picture.
     *
     * @param film the picture
     * @param file where to, and in which format
     * @throws IOException if it cannot be written; then whatever stood there before still does
     */
    public static void saveImage(Film film, ImageFile file) throws IOException {
        file.write(film);
    }

    private static int failed(int status, List<String> messages) {
        for (String message : messages) {
            System.err.println(message);
        }
        return status;
    }

    private static String version() {
        String version = Optional.ofNullable(RayTracer.class.getPackage().getImplementationVersion()).orElse("unpacked");
        return "RayTracer " + version + System.lineSeparator();
    }
}
