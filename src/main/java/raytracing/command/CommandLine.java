package raytracing.command;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import raytracing.compiled.ShadowMode;
import raytracing.film.Film;
import raytracing.film.ImageFormat;
import raytracing.parse.RayTracerException;
import raytracing.render.PixelSampling;
import raytracing.render.RenderSettings;
import raytracing.shade.ShadowMethod;

/**
 * Reads the words of a command line: SCENE OUTPUT [WIDTH HEIGHT], and options that may stand anywhere before a
 * {@code --}. A value follows its option as the next word or after an equals sign; of an option given twice, the last
 * counts.
 */
public final class CommandLine {
    /** What {@code --help} prints. */
    public static final String HELP = """
        usage: java -jar RayTracer.jar SCENE OUTPUT [WIDTH HEIGHT] [options]

        Draws the scene file SCENE into the picture file OUTPUT, 500 x 500 pixels unless
        WIDTH and HEIGHT say otherwise. The ending of OUTPUT chooses the format:
        png, jpg, bmp or gif.

        options (they may stand anywhere; "--threads 4" and "--threads=4" are the same)
          --threads N        use N threads instead of one for each processor
          --seed N           use other random numbers; default 1
          --shadows exact    soft shadows without noise; default "sampled"
          --shadow-rays N    N x N shadow rays, whatever the scene says
          --samples N        smooth edges: N x N rays in pixels on an edge; default 1
          --opaque-shadows   transparent surfaces cast full shadows instead of letting
                             light through
          --help             print this text
          --version          print the version
          --                 take all further words as file names and sizes

        examples
          java -jar RayTracer.jar scenes/boxes.txt boxes.png
          java -jar RayTracer.jar scenes/boxes.txt wide.jpg 1920 1080 --threads 2

        exit status: 0 done, 1 the machine failed (file, memory), 2 the scene or the
        command is wrong, 130 interrupted
        """;

    private static final String USAGE = "expected SCENE OUTPUT [WIDTH HEIGHT] [options], see --help";
    private static final int MOST_THREADS = 1024;
    private static final int MOST_SAMPLES = 32;

    /** As in a scene file. */
    private static final int LARGEST_SHADOW_RAY_ROOT = 1024;

    private final List<String> operands = new ArrayList<>();
    private RenderSettings settings = RenderSettings.DEFAULT;
    private OptionalInt shadowRayRoot = OptionalInt.empty();
    private boolean exactShadows;
    private boolean help;
    private boolean version;

    private CommandLine() {
    }

    /**
     * Reads a command line.
     *
     * @param words as the program received them
     * @return what they ask for
     * @throws RayTracerException if they are wrong; the first thing that is
     */
    public static Command parse(String... words) throws RayTracerException {
        CommandLine line = new CommandLine();
        line.read(List.of(words));
        if (line.help) {
            return new Command.Help();
        }
        return line.version ? new Command.Version() : line.draw();
    }

    private void read(List<String> words) throws RayTracerException {
        for (int i = 0; i < words.size(); i++) {
            String word = words.get(i);
            if (word.equals("--")) {
                operands.addAll(words.subList(i + 1, words.size()));
                return;
            }
            if (!isOption(word)) {
                operands.add(word);
                continue;
            }
            int equals = word.indexOf('=');
            String name = equals < 0 ? word : word.substring(0, equals);
            if (!takesValue(name)) {
                if (equals >= 0) {
                    throw new RayTracerException(name + ": takes no value, got " + word.substring(equals + 1));
                }
                setFlag(name);
            } else if (equals >= 0) {
                setValue(name, word.substring(equals + 1));
            } else if (++i < words.size()) {
                setValue(name, words.get(i));
            } else {
                throw new RayTracerException(name + ": needs a value, see --help");
            }
        }
    }

    /** A dash begins an option; alone or before a digit it is a bad file name or size, and is reported as that. */
    private static boolean isOption(String word) {
        return word.length() > 1 && word.charAt(0) == '-' && !Character.isDigit(word.charAt(1));
    }

    private static boolean takesValue(String name) throws RayTracerException {
        return switch (name) {
            case "--threads", "--seed", "--shadows", "--shadow-rays", "--samples" -> true;
            case "--opaque-shadows", "--help", "--version" -> false;
            default -> throw new RayTracerException(name + ": unknown option, expected --threads, --seed, --shadows, "
                + "--shadow-rays, --samples, --opaque-shadows, --help or --version");
        };
    }

    private void setFlag(String name) {
        switch (name) {
            case "--opaque-shadows" -> settings = settings.withShadowMode(ShadowMode.ALL_SURFACES_STOP_LIGHT);
            case "--help" -> help = true;
            default -> version = true;
        }
    }

    private void setValue(String name, String value) throws RayTracerException {
        switch (name) {
            case "--threads" ->
                settings = settings.withWorkers(wholeNumber(name, value, MOST_THREADS), settings.tileSize());
            case "--shadows" -> exactShadows = isExact(value);
            case "--shadow-rays" ->
                shadowRayRoot = OptionalInt.of(wholeNumber(name, value, LARGEST_SHADOW_RAY_ROOT));
            case "--samples" -> settings = settings.withSampling(
                new PixelSampling(wholeNumber(name, value, MOST_SAMPLES), PixelSampling.Where.EDGES));
            default -> settings = settings.withSeed(seed(value));
        }
    }

    private static boolean isExact(String method) throws RayTracerException {
        return switch (method) {
            case "exact" -> true;
            case "sampled" -> false;
            default -> throw new RayTracerException("--shadows: must be sampled or exact, got " + method);
        };
    }

    private ShadowMethod shadowMethod() throws RayTracerException {
        if (!exactShadows) {
            return new ShadowMethod.Sampled(shadowRayRoot);
        }
        if (shadowRayRoot.isPresent()) {
            throw new RayTracerException("--shadow-rays: exact shadows need none, so it cannot stand beside "
                + "--shadows exact");
        }
        return new ShadowMethod.Exact();
    }

    private static long seed(String value) throws RayTracerException {
        try {
            return Long.parseLong(value);
        } catch (NumberFormatException notWhole) {
            throw new RayTracerException("--seed: must be a whole number of at most 18 digits, got " + value);
        }
    }

    private static int wholeNumber(String name, String value, int largest) throws RayTracerException {
        try {
            int number = Integer.parseInt(value);
            if (number >= 1 && number <= largest) {
                return number;
            }
        } catch (NumberFormatException notWhole) {
            // said below, with the numbers out of range
        }
        throw new RayTracerException(name + ": must be a whole number from 1 to " + largest + ", got " + value);
    }

    private Command draw() throws RayTracerException {
        if (operands.size() != 2 && operands.size() != 4) {
            throw new RayTracerException(count(operands.size()) + ": " + USAGE);
        }
        String output = operands.get(1);
        Optional<ImageFormat> format = ImageFormat.ofEnding(output);
        if (format.isEmpty()) {
            throw new RayTracerException(output
                + ": unknown picture format, expected a name ending in .png, .jpg, .bmp or .gif");
        }
        if (operands.size() == 4) {
            settings = sized(format.get());
        }
        return new Command.Draw(path(operands.get(0)), path(output), format.get(),
            settings.withShadowMethod(shadowMethod()));
    }

    private static String count(int operands) {
        return switch (operands) {
            case 0 -> "no scene and no output";
            case 1 -> "no output";
            case 3 -> "a width without a height";
            default -> operands + " names and sizes";
        };
    }

    private RenderSettings sized(ImageFormat format) throws RayTracerException {
        int width = wholeNumber("width", operands.get(2), format.longestSide());
        int height = wholeNumber("height", operands.get(3), format.longestSide());
        if ((long) width * height > Film.MOST_PIXELS) {
            throw new RayTracerException("size: must be at most " + Film.MOST_PIXELS + " pixels, got "
                + width + " x " + height);
        }
        return settings.withSize(width, height);
    }

    private static Path path(String name) throws RayTracerException {
        try {
            return Path.of(name);
        } catch (InvalidPathException invalid) {
            throw new RayTracerException(name + ": no valid file name");
        }
    }
}
