package raytracing.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import raytracing.SceneFiles;
import raytracing.parse.RayTracerException;

/**
 * What a run is asked for.
 *
 * @param scenes the scene files
 * @param folder where the page goes
 * @param budget how much time a scene may take
 * @param command what asks for the same again
 * @param part what is written
 */
record Request(List<Path> scenes, Path folder, Budget budget, String command, Part part) {
    private static final Path FOLDER = Path.of("build", "report");
    private static final int MOST_SIZE = 2000;

    /** What is written. */
    enum Part {
        /** The page alone. */
        PAGE("gradle report"),

        /** The page, and from it what is committed in the documents. */
        PAGE_AND_DOCUMENTS("gradle reportPictures");

        private final String task;

        Part(String task) {
            this.task = task;
        }
    }

    /** Reads arguments of the form {@code name=value}: scene, out, size; {@code documents} asks for those too. */
    static Request of(List<String> arguments) throws RayTracerException, IOException {
        Part part = arguments.contains("documents") ? Part.PAGE_AND_DOCUMENTS : Part.PAGE;
        Optional<String> scene = value(arguments, "scene");
        Optional<String> out = value(arguments, "out");
        OptionalInt size = size(arguments);
        Budget budget = scene.isPresent() ? Budget.OF_ONE : Budget.OF_MANY;
        return new Request(scene.isPresent() ? List.of(Path.of(scene.get())) : SceneFiles.all().toList(),
            out.map(Path::of).orElse(FOLDER),
            size.isPresent() ? budget.withSize(size.getAsInt()) : budget,
            part.task + scene.map(file -> " -Pscene=" + shown(file)).orElse("")
                + (size.isPresent() ? " -Psize=" + size.getAsInt() : "") + out.map(o -> " -Pout=" + shown(o)).orElse(""),
            part);
    }

    private static Optional<String> value(List<String> arguments, String name) {
        return arguments.stream().filter(argument -> argument.startsWith(name + "="))
            .map(argument -> argument.substring(name.length() + 1)).findFirst();
    }

    /** Width and height of the pictures in pixels, if the arguments say so. */
    static OptionalInt size(List<String> arguments) throws RayTracerException {
        Optional<String> size = value(arguments, "size");
        return size.isPresent() ? OptionalInt.of(size(size.get())) : OptionalInt.empty();
    }

    private static int size(String text) throws RayTracerException {
        try {
            int size = Integer.parseInt(text);
            if (size >= Ssim.WINDOW && size <= MOST_SIZE) {
                return size;
            }
        } catch (NumberFormatException notWhole) {
            // said below, with the numbers out of range
        }
        throw new RayTracerException("size: must be a whole number from " + Ssim.WINDOW + " to " + MOST_SIZE
            + ", got " + text);
    }

    /** Where a page goes, the folders of its writer are nobody's business. */
    private static String shown(String file) {
        Path path = Path.of(file);
        return path.isAbsolute() ? path.getFileName().toString() : file;
    }
}
