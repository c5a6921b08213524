package raytracing.command;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import raytracing.compiled.ShadowMode;
import raytracing.film.ImageFormat;
import raytracing.parse.RayTracerException;
import raytracing.render.PixelSampling;
import raytracing.render.Region;
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
        Draws a scene file as a picture (.png .jpg .bmp .gif), 500 x 500 by default.
        The picture
          --samples N        smooth edges: N x N rays in pixels at edges; default 1
          --shadows exact    noise-free: what N x N sampling converges to, and usually
                             faster than 5 x 5; default sampled, as in the exercise
          --shadow-rays N    N x N shadow rays to each light; default: as the scene says
          --opaque-shadows   glass casts full shadows; by default it dims the light
          --seed N           other random numbers, to tell noise from detail; default 1
          --region X,Y,W,H   draw only this part: left, top, width, height; default all
        While it is drawn
          --preview          show the picture while rendering; off by default
          --watch            draw again in a window whenever the scene is saved
          --keep-partial     when stopped, save the finished part (default: keep the old
                             file); gaps are transparent in a png of up to 2048 x 2048
          --threads N        how many threads draw; default: one for each processor
          --stats[=json]     print at the end counts of rays, times, memory; default off
          --quiet            print only errors; default: progress and a summary
          --help  --version  print this text, or the version, and draw nothing
          --                 all words after it are names and sizes, even -scene.txt
        Examples: a first look, then the final picture
          java -jar RayTracer.jar scenes/boxes.txt boxes.png
          java -jar RayTracer.jar scenes/boxes.txt big.png 1920 1080 --samples 3
        Exit status: 0 done, 1 the machine failed, 2 scene or command wrong, 130 stopped
        """;

    private static final String USAGE = "expected SCENE OUTPUT [WIDTH HEIGHT] [options], see --help";
    private static final String FOUR_NUMBERS = "(\\d{1,10}),(\\d{1,10}),(\\d{1,10}),(\\d{1,10})";
    private static final int MOST_THREADS = 1024;
    private static final int MOST_SAMPLES = 32;

    /** What Java makes of letters of the command line or of a folder's name that the locale does not have. */
    private static final char LOST_LETTER = '\ufffd';

    /** As in a scene file. */
    private static final int LARGEST_SHADOW_RAY_ROOT = 1024;

    private final List<String> operands = new ArrayList<>();
    private final Set<Extra> extras = EnumSet.noneOf(Extra.class);
    private RenderSettings settings = RenderSettings.DEFAULT;
    private OptionalInt shadowRayRoot = OptionalInt.empty();
    private Optional<String> region = Optional.empty();
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
            Option option = option(equals < 0 ? word : word.substring(0, equals));
            if (equals >= 0) {
                if (option.value() == Option.Value.NONE) {
                    throw new RayTracerException(option.word() + ": takes no value, got " + word.substring(equals + 1));
                }
                setValue(option, word.substring(equals + 1));
            } else if (option.value() != Option.Value.REQUIRED) {
                setFlag(option);
            } else if (++i < words.size()) {
                setValue(option, words.get(i));
            } else {
                throw new RayTracerException(option.word() + ": needs a value, see --help");
            }
        }
    }

    /** A dash begins an option; alone or before a digit it is a bad file name or size, and is reported as that. */
    private static boolean isOption(String word) {
        return word.length() > 1 && word.charAt(0) == '-' && !Character.isDigit(word.charAt(1));
    }

    private static Option option(String word) throws RayTracerException {
        Optional<Option> option = Option.named(word);
        if (option.isPresent()) {
            return option.get();
        }
        Optional<Option> nearest = Option.nearest(word);
        throw new RayTracerException(word + ": unknown option"
            + (nearest.isPresent() ? ", did you mean " + nearest.get().word() + "? See --help" : ", see --help"));
    }

    private void setFlag(Option option) {
        switch (option) {
            case OPAQUE_SHADOWS -> settings = settings.withShadowMode(ShadowMode.ALL_SURFACES_STOP_LIGHT);
            case PREVIEW -> extras.add(Extra.PREVIEW);
            case WATCH -> extras.add(Extra.WATCH);
            case KEEP_PARTIAL -> extras.add(Extra.KEEP_PARTIAL);
            case STATS -> extras.add(Extra.STATISTICS);
            case QUIET -> extras.add(Extra.QUIET);
            case HELP -> help = true;
            default -> version = true;
        }
    }

    private void setValue(Option option, String value) throws RayTracerException {
        String name = option.word();
        switch (option) {
            case THREADS -> settings = settings.withWorkers(wholeNumber(name, value, MOST_THREADS), settings.tileSize());
            case REGION -> region = Optional.of(value);
            case SHADOWS -> exactShadows = isExact(value);
            case SHADOW_RAYS -> shadowRayRoot = OptionalInt.of(wholeNumber(name, value, LARGEST_SHADOW_RAY_ROOT));
            case SAMPLES -> settings = settings.withSampling(
                new PixelSampling(wholeNumber(name, value, MOST_SAMPLES), PixelSampling.Where.EDGES));
            case STATS -> setStatistics(value);
            default -> settings = settings.withSeed(seed(value));
        }
    }

    private void setStatistics(String form) throws RayTracerException {
        if (!form.equals("json")) {
            throw new RayTracerException("--stats: must be json or nothing, got " + form);
        }
        extras.add(Extra.STATISTICS_AS_JSON);
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
        throw new RayTracerException(name + ": must be a whole number from 1 to " + largest + ", got " + value
            + root(value));
    }

    /** N by N rays are asked for by N. */
    private static String root(String value) {
        Matcher square = Pattern.compile("([1-9]\\d*)[xX*\u00d7]\\1").matcher(value);
        return square.matches() ? ", did you mean " + square.group(1) + "?" : "";
    }

    private Command draw() throws RayTracerException {
        if (operands.size() != 2 && operands.size() != 4) {
            throw wrongOperands(count(), ": " + USAGE);
        }
        String output = operands.get(1);
        Optional<ImageFormat> format = ImageFormat.ofEnding(output);
        if (format.isEmpty()) {
            throw wrongOperands(output + ": unknown picture format", ", expected a name ending in .png, .jpg, .bmp or .gif");
        }
        settings = sized(format.get());
        if (extras.contains(Extra.WATCH) && extras.contains(Extra.KEEP_PARTIAL)) {
            throw new RayTracerException("--keep-partial: cannot stand beside --watch, where the picture file is always the last "
                + "finished picture");
        }
        return new Command.Draw(path(operands.get(0)), path(output), format.get(),
            settings.withShadowMethod(shadowMethod()), extras);
    }

    /** What is wrong with the number of names and sizes. */
    private String count() {
        return switch (operands.size()) {
            case 0 -> "no scene and no output";
            case 1 -> ImageFormat.ofEnding(operands.get(0)).isPresent() ? "no scene" : "no output";
            case 3 -> "a width without a height";
            default -> operands.size() + " names and sizes";
        };
    }

    /** Says what the names and sizes were probably meant to be, or what is expected if that cannot be told. */
    private RayTracerException wrongOperands(String problem, String expected) {
        boolean isHelp = operands.size() == 1 && isHelpElsewhere(operands.get(0));
        Optional<String> meant = isHelp ? Optional.of("--help") : Rearranged.of(operands);
        return new RayTracerException(meant.isPresent()
            ? problem + ", did you mean " + meant.get() + "? See --help" : problem + expected);
    }

    private static boolean isHelpElsewhere(String word) {
        return switch (word) {
            case "/?", "/h", "/help", "?", "help" -> true;
            default -> false;
        };
    }

    /** The size of the picture, of which a file may hold a part. */
    private RenderSettings sized(ImageFormat format) throws RayTracerException {
        RenderSettings sized = settings;
        if (operands.size() == 4) {
            int longest = region.isPresent() ? Integer.MAX_VALUE : format.longestSide();
            sized = settings.withSize(side("width", operands.get(2), longest), side("height", operands.get(3), longest));
        }
        if (region.isPresent()) {
            sized = sized.withRegion(region(region.get(), sized, format));
        }
        if (sized.region().pixelCount() > format.mostPixels()) {
            throw new RayTracerException("size: must be at most " + format.mostPixels() + " pixels, got "
                + sized.region().width() + " x " + sized.region().height());
        }
        return sized;
    }

    private int side(String name, String value, int longest) throws RayTracerException {
        try {
            return wholeNumber(name, value, longest);
        } catch (RayTracerException wrong) {
            Optional<String> meant = Rearranged.of(operands);
            throw meant.isEmpty() ? wrong
                : new RayTracerException(wrong.getMessage() + ", did you mean " + meant.get() + "?");
        }
    }

    private static Region region(String value, RenderSettings picture, ImageFormat format) throws RayTracerException {
        Matcher matcher = Pattern.compile(FOUR_NUMBERS).matcher(value);
        if (!matcher.matches()) {
            throw new RayTracerException("--region: must be X,Y,W,H: left column, top row, width and height, "
                + "whole numbers with commas, got " + value);
        }
        long x = Long.parseLong(matcher.group(1));
        long y = Long.parseLong(matcher.group(2));
        long width = Long.parseLong(matcher.group(3));
        long height = Long.parseLong(matcher.group(4));
        if (width < 1 || height < 1 || x + width > picture.width() || y + height > picture.height()) {
            throw new RayTracerException("--region: must be a part of the picture of " + picture.width() + " x "
                + picture.height() + " pixels, got " + value);
        }
        if (Math.max(width, height) > format.longestSide()) {
            throw new RayTracerException("--region: width and height must be at most " + format.longestSide()
                + " in a file of this format, got " + value);
        }
        return new Region((int) x, (int) y, (int) (x + width), (int) (y + height));
    }

    /** A file that is found is the one that is meant, even if its name holds what else stands for a lost letter. */
    private static Path path(String name) throws RayTracerException {
        boolean isRead = name.indexOf(LOST_LETTER) < 0;
        try {
            Path path = Path.of(name);
            boolean isFolderRead = path.isAbsolute() || System.getProperty("user.dir").indexOf(LOST_LETTER) < 0;
            if (isRead && isFolderRead || Files.exists(path)) {
                return path;
            }
        } catch (InvalidPathException invalid) {
            if (isRead) {
                throw new RayTracerException(name + ": no valid file name");
            }
        }
        String what = name + ": Java cannot read all letters of " + (isRead ? "the folder that it runs in" : "this name");
        throw new RayTracerException(what + ("UTF-8".equals(System.getProperty("native.encoding"))
            ? ", which is not in UTF-8 as this locale is; rename it"
            : " in this locale; begin the command with LC_ALL=C.UTF-8"));
    }
}
