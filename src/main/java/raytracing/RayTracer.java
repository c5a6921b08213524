package raytracing;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import raytracing.color.Color;
import raytracing.command.Command;
import raytracing.command.CommandLine;
import raytracing.film.Film;
import raytracing.film.ImageFile;
import raytracing.parse.RayTracerException;
import raytracing.parse.SceneParser;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.render.Rendering;
import raytracing.scene.Scene;
import raytracing.shade.AmbientLight;

/** The program: {@code java -jar RayTracer.jar SCENE OUTPUT [WIDTH HEIGHT] [options]}. */
public final class RayTracer {
    private static final int DONE = 0;
    private static final int MACHINE_FAILED = 1;
    private static final int USER_IS_WRONG = 2;

    private RayTracer() {
    }

    /**
     * Runs the program and ends the virtual machine: with 0 if all is done, 1 if the machine failed, 2 if the scene or
     * the command is wrong.
     *
     * @param arguments the command line
     */
    public static void main(String[] arguments) {
        System.exit(run(arguments));
    }

    /** Whatever happens, the user gets sentences on standard error and never a stack trace. */
    private static int run(String... arguments) {
        try {
            Command command = CommandLine.parse(arguments);
            if (command instanceof Command.Draw draw) {
                draw(draw);
            } else {
                System.out.print(command instanceof Command.Help ? CommandLine.HELP : version());
            }
            return DONE;
        } catch (RayTracerException wrong) {
            return failed(USER_IS_WRONG, wrong.messages());
        } catch (IOException failure) {
            return failed(MACHINE_FAILED, List.of(reason(failure)));
        } catch (OutOfMemoryError tooLarge) {
            return failed(MACHINE_FAILED, List.of("not enough memory for this scene and picture size; "
                + "java -Xmx4g -jar RayTracer.jar ... allows 4 GB"));
        } catch (RuntimeException | StackOverflowError defect) {
            return failed(MACHINE_FAILED, List.of("this is a defect of the program, please report it: " + defect));
        }
    }

    private static void draw(Command.Draw command) throws RayTracerException, IOException {
        long start = System.nanoTime();
        ImageFile file = new ImageFile(command.output(), command.format());
        Optional<String> obstacle = file.obstacle();
        if (obstacle.isPresent()) {
            throw new RayTracerException(command.output() + ": " + obstacle.get());
        }
        file.prepare();
        Scene scene = parseScene(command.scene());
        Renderer renderer = new Renderer(scene, command.settings());
        Rendering rendering = renderer.draw();
        saveImage(rendering.film(), file);
        long milliseconds = (System.nanoTime() - start) / 1_000_000;
        System.err.println(command.output() + ": " + rendering.film().width() + " x " + rendering.film().height()
            + " pixels in " + milliseconds + " ms" + refinement(rendering, command.settings().sampling().root()) + ambience(renderer.ambientLight()));
    }

    private static String ambience(AmbientLight light) {
        Color mean = light.mean();
        return light.isNone() ? "" : String.format(Locale.ROOT, ", in ambient light of %.3f %.3f %.3f",
            mean.red(), mean.green(), mean.blue());
    }

    private static String refinement(Rendering rendering, int root) {
        return root == 1 ? "" : String.format(Locale.ROOT, ", %.1f %% of them with %d x %d rays",
            100 * rendering.refinedShare(), root, root);
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
        return SceneParser.parseFile(file);
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

    /** A file and what is wrong with it; the library's own message of a file failure is often the bare name. */
    private static String reason(IOException failure) {
        if (failure instanceof FileSystemException file && file.getFile() != null) {
            String why = file.getReason() == null ? kind(failure) : file.getReason();
            return file.getFile() + ": " + why;
        }
        return failure.getMessage() == null ? kind(failure) : failure.getMessage();
    }

    /** {@code AccessDeniedException} becomes "access denied". */
    private static String kind(IOException failure) {
        String name = failure.getClass().getSimpleName().replace("Exception", "");
        return name.replaceAll("(?<=.)(?=[A-Z])", " ").toLowerCase(Locale.ROOT);
    }

    private static String version() {
        String version = Optional.ofNullable(RayTracer.class.getPackage().getImplementationVersion()).orElse("unpacked");
        return "RayTracer " + version + System.lineSeparator();
    }
}
