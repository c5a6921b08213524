package raytracing.program;

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
import raytracing.film.ImageFile;
import raytracing.film.ImageFormat;
import raytracing.parse.RayTracerException;
import raytracing.render.ErrorLimit;
import raytracing.render.PixelGrid;
import raytracing.render.Region;
import raytracing.render.RenderSettings;
import raytracing.scene.Settings;
import raytracing.shadow.ShadowMethod;
import raytracing.trace.ShadowMode;

/**
 * Parses a command line: SCENE OUTPUT [WIDTH HEIGHT], and options anywhere before a {@code --}. A value follows its option as
 * the next word or after an equals sign. If an option is given twice, the last one counts.
 */
public final class CommandLine {
    /** What {@code --help} prints. */
    public static final String HELP = """
        usage: java -jar RayTracer.jar SCENE OUTPUT [WIDTH HEIGHT] [options]
        Draws a scene file as a picture (.png .jpg .bmp .gif), 500 x 500 by default.
        The picture
          --samples N        smooth edges: N x N rays in pixels at edges; default 1
          --error E          rays until pixels are right to E steps of 1/255, 0.25 to 64
          --shadows exact    no noise, usually faster than 5 x 5 rays; default sampled
          --shadow-rays N    N x N shadow rays to each light; default: as the scene says
          --opaque-shadows   glass casts full shadows; by default it dims the light
          --seed N           other random numbers, to tell noise from detail; default 1
          --region X,Y,W,H   draw only this part: left, top, width, height; default all
        While it is drawn, and after
          --preview          show the picture while rendering; off by default
          --watch            draw again in a window whenever the scene is saved
          --keep-partial     when stopped, save what is finished; default: keep old file
          --compare FILE     print how far it is from the picture FILE: RMS, PSNR, ...
          --compare-map MAP  draw where they differ: black nowhere, white most
          --threads N        how many threads draw; default: one for each processor
          --stats[=json]     print at the end counts of rays, times, memory; default off
          --quiet            print only errors; default: progress and a summary
          --help  --version  print this text, or the version, and draw nothing
          --                 all words after it are names and sizes, even -scene.txt
        Examples: java -jar RayTracer.jar scenes/boxes.txt boxes.png
                  java -jar RayTracer.jar scenes/boxes.txt big.png 1920 1080 --error 1
        Exit status: 0 done, 1 the machine failed, 2 scene or command wrong, 130 stopped
        """;

    private static final String USAGE = "expected SCENE OUTPUT [WIDTH HEIGHT] [options], see --help";
    private static final String UNKNOWN_FORMAT = ": unknown picture format";
    private static final String KNOWN_FORMATS = ", expected a name ending in .png, .jpg, .bmp or .gif";
    private static final int MOST_THREADS = 1024;
    private static final int MOST_SAMPLES = 32;
    private static final int MOST_DIGITS = 10;
    private static final String EXACT = "exact";
    private static final String SAMPLED = "sampled";

    /** Stands for a character of the command line or of a folder's name that Java cannot decode in the locale. */
    private static final char UNDECODED = '\ufffd';

    private final List<String> operands = new ArrayList<>();
    private final Set<Option> extras = EnumSet.noneOf(Option.class);
    private RenderSettings settings = RenderSettings.DEFAULT;
    private OptionalInt shadowRayRoot = OptionalInt.empty();
    private Optional<String> region = Optional.empty();
    private Optional<String> compared = Optional.empty();
    private Optional<String> comparisonMap = Optional.empty();
    private Optional<PixelGrid> samples = Optional.empty();
    private Optional<ErrorLimit> error = Optional.empty();
    private Optional<String> shadows = Optional.empty();

    private CommandLine() {
    }

    /**
     * Parses the words of a command line.
     *
     * @throws RayTracerException about the first mistake in them
     */
    public static Command parse(String... words) throws RayTracerException {
        CommandLine line = new CommandLine();
        line.read(List.of(words));
        if (line.extras.contains(Option.HELP)) {
            return new Command.Help();
        }
        return line.extras.contains(Option.VERSION) ? new Command.Version() : line.draw();
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
            Option option = Option.named(equals < 0 ? word : word.substring(0, equals));
            Optional<String> value = equals < 0 ? Optional.empty() : Optional.of(word.substring(equals + 1));
            if (value.isPresent() && option.value == Option.Value.NONE) {
                throw new RayTracerException(option.word + ": takes no value, got " + value.get());
            }
            if (value.isEmpty() && option.value == Option.Value.REQUIRED) {
                if (++i == words.size()) {
                    throw new RayTracerException(option.word + ": needs a value, see --help");
                }
                value = Optional.of(words.get(i));
            }
            set(option, value);
        }
    }

    /** A dash begins an option, unless it is alone or before a digit: then it is reported as a bad file name or size. */
    private static boolean isOption(String word) {
        return word.length() > 1 && word.charAt(0) == '-' && !Character.isDigit(word.charAt(1));
    }

    private void set(Option option, Optional<String> value) throws RayTracerException {
        String text = value.orElse("");
        switch (option) {
            case REGION -> region = value;
            case COMPARE -> compared = value;
            case COMPARE_MAP -> comparisonMap = value;
            case SAMPLES -> samples =
                Optional.of(new PixelGrid(wholeNumber(option.word, text, MOST_SAMPLES), PixelGrid.Where.EDGES));
            case ERROR -> error = Optional.of(errorLimit(text));
            case SHADOWS -> shadows = Optional.of(shadows(text));
            case SHADOW_RAYS -> shadowRayRoot =
                OptionalInt.of(wholeNumber(option.word, text, Settings.LARGEST_SHADOW_RAY_ROOT));
            case OPAQUE_SHADOWS -> settings = settings.withShadowMode(ShadowMode.ALL_SURFACES_STOP_LIGHT);
            case SEED -> settings = settings.withSeed(seed(text));
            case THREADS -> settings =
                settings.withWorkers(wholeNumber(option.word, text, MOST_THREADS), settings.tileSize());
            case STATS -> extras.add(statistics(value));
            case PREVIEW, WATCH, KEEP_PARTIAL, STATS_AS_JSON, QUIET, HELP, VERSION -> extras.add(option);
        }
    }

    private static RayTracerException wrong(String name, String expected, String value) {
        return new RayTracerException(name + ": must be " + expected + ", got " + value);
    }

    private static Option statistics(Optional<String> form) throws RayTracerException {
        if (form.isEmpty()) {
            return Option.STATS;
        }
        if (!form.get().equals("json")) {
            throw wrong("--stats", "json or nothing", form.get());
        }
        return Option.STATS_AS_JSON;
    }

    private static ErrorLimit errorLimit(String value) throws RayTracerException {
        double steps = isDecimal(value) ? Double.parseDouble(value) : 0;
        if (!(steps >= ErrorLimit.LEAST && steps <= ErrorLimit.MOST)) {
            throw wrong("--error", "a number of steps of 1/255 from 0.25 to 64, such as 1 or 0.5", value);
        }
        return new ErrorLimit(steps);
    }

    /** Whether a word is of the form 12, 1.5 or .5; a regular expression for it would load 80 classes. */
    private static boolean isDecimal(String word) {
        int point = word.indexOf('.');
        boolean isWhole = point == 0 || isDigits(word.substring(0, point < 0 ? word.length() : point));
        return isWhole && (point < 0 || isDigits(word.substring(point + 1)));
    }

    /** Whether a word is one to ten digits. */
    private static boolean isDigits(String word) {
        for (int i = 0; i < word.length(); i++) {
            if (word.charAt(i) < '0' || word.charAt(i) > '9') {
                return false;
            }
        }
        return !word.isEmpty() && word.length() <= MOST_DIGITS;
    }

    private static String shadows(String method) throws RayTracerException {
        if (!method.equals(EXACT) && !method.equals(SAMPLED)) {
            throw wrong("--shadows", "sampled or exact", method);
        }
        return method;
    }

    /** How many rays a pixel gets, and how soft shadows are found: unless given, without noise if the error is limited. */
    private RenderSettings withMethods() throws RayTracerException {
        if (error.isPresent() && samples.isPresent()) {
            throw new RayTracerException("--error: finds out how many rays each pixel needs, so it cannot be combined "
                + "with --samples");
        }
        RenderSettings sampled = error.isPresent() ? settings.withSampling(error.get())
            : settings.withSampling(samples.orElse(PixelGrid.ONE_RAY));
        if (shadows.orElse(error.isPresent() ? EXACT : SAMPLED).equals(SAMPLED)) {
            return sampled.withShadowMethod(new ShadowMethod.Sampled(shadowRayRoot));
        }
        if (shadowRayRoot.isPresent()) {
            throw new RayTracerException("--shadow-rays: exact shadows need none, so it cannot be combined with "
                + (shadows.isPresent() ? "--shadows exact" : "--error, unless with --shadows sampled"));
        }
        return sampled.withShadowMethod(new ShadowMethod.Exact());
    }

    private static long seed(String value) throws RayTracerException {
        try {
            return Long.parseLong(value);
        } catch (NumberFormatException notWhole) {
            throw wrong("--seed", "a whole number of at most 18 digits", value);
        }
    }

    private static int wholeNumber(String name, String value, int largest) throws RayTracerException {
        try {
            int number = Integer.parseInt(value);
            if (number >= 1 && number <= largest) {
                return number;
            }
        } catch (NumberFormatException notWhole) {
            // reported below, like a number out of range
        }
        Matcher square = Pattern.compile("([1-9]\\d*)[xX*\u00d7]\\1").matcher(value);    // N x N where N is expected
        throw wrong(name, "a whole number from 1 to " + largest,
            square.matches() ? value + ", did you mean " + square.group(1) + "?" : value);
    }

    private Command draw() throws RayTracerException {
        if (operands.size() != 2 && operands.size() != 4) {
            throw wrongOperands(wrongCount(), ": " + USAGE);
        }
        String output = operands.get(1);
        Optional<ImageFormat> format = ImageFormat.ofEnding(output);
        if (format.isEmpty()) {
            throw wrongOperands(output + UNKNOWN_FORMAT, KNOWN_FORMATS);
        }
        settings = sized(format.get());
        if (extras.contains(Option.WATCH) && extras.contains(Option.KEEP_PARTIAL)) {
            throw new RayTracerException("--keep-partial: cannot be combined with --watch, where the picture file is "
                + "always the last finished picture");
        }
        settings = withMethods();
        return new Command.Draw(path(operands.get(0)), path(output), format.get(), settings, extras, compare());
    }

    private Optional<Command.Compare> compare() throws RayTracerException {
        if (compared.isEmpty() && comparisonMap.isPresent()) {
            throw new RayTracerException("--compare-map: needs --compare FILE, which says what to compare the picture with");
        }
        if (compared.isEmpty()) {
            return Optional.empty();
        }
        if (compared.get().isEmpty()) {
            throw new RayTracerException("--compare: needs the name of a picture");
        }
        return Optional.of(new Command.Compare(path(compared.get()),
            comparisonMap.isPresent() ? Optional.of(comparisonMap(comparisonMap.get())) : Optional.empty()));
    }

    /** The file of a map, which is as large as the picture. */
    private ImageFile comparisonMap(String name) throws RayTracerException {
        Optional<ImageFormat> format = ImageFormat.ofEnding(name);
        if (format.isEmpty()) {
            throw new RayTracerException("--compare-map: " + name + UNKNOWN_FORMAT + KNOWN_FORMATS);
        }
        Region picture = settings.region();
        if (Math.max(picture.width(), picture.height()) > format.get().longestSide()
                || picture.pixelCount() > format.get().mostPixels()) {
            throw new RayTracerException("--compare-map: " + picture.width() + " x " + picture.height()
                + " pixels are too many for a file of this format; give the map a name ending in .png");
        }
        return new ImageFile(path(name), format.get());
    }

    private String wrongCount() {
        return switch (operands.size()) {
            case 0 -> "no scene and no output";
            case 1 -> ImageFormat.ofEnding(operands.get(0)).isPresent() ? "no scene" : "no output";
            case 3 -> "a width without a height";
            default -> operands.size() + " names and sizes";
        };
    }

    /** The message names the command that was probably meant, or else what is expected. */
    private RayTracerException wrongOperands(String problem, String expected) {
        boolean isHelpElsewhere = operands.size() == 1 && List.of("/?", "/h", "/help", "?", "help").contains(operands.get(0));
        Optional<String> meant = isHelpElsewhere ? Optional.of("--help") : Rearranged.of(operands);
        return new RayTracerException(problem
            + (meant.isPresent() ? ", did you mean " + meant.get() + "? See --help" : expected));
    }

    /** The settings with the size of the picture and its region; only the region must fit the format. */
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
            throw wrong("size", "at most " + format.mostPixels() + " pixels",
                sized.region().width() + " x " + sized.region().height());
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
        String[] numbers = value.split(",", -1);
        boolean areFour = numbers.length == 4;
        for (String number : numbers) {
            areFour &= isDigits(number);
        }
        if (!areFour) {
            throw wrong("--region", "X,Y,W,H: left column, top row, width and height, whole numbers with commas", value);
        }
        long x = Long.parseLong(numbers[0]);
        long y = Long.parseLong(numbers[1]);
        long width = Long.parseLong(numbers[2]);
        long height = Long.parseLong(numbers[3]);
        if (width < 1 || height < 1 || x + width > picture.width() || y + height > picture.height()) {
            throw wrong("--region",
                "a part of the picture of " + picture.width() + " x " + picture.height() + " pixels", value);
        }
        if (Math.max(width, height) > format.longestSide()) {
            throw new RayTracerException("--region: width and height must be at most " + format.longestSide()
                + " in a file of this format, got " + value);
        }
        return new Region((int) x, (int) y, (int) (x + width), (int) (y + height));
    }

    /** The path of a name whose characters were all decoded, or which exists in spite of an undecoded one. */
    private static Path path(String name) throws RayTracerException {
        boolean isDecoded = name.indexOf(UNDECODED) < 0;
        try {
            Path path = Path.of(name);
            boolean isFolderDecoded = path.isAbsolute() || System.getProperty("user.dir").indexOf(UNDECODED) < 0;
            if (isDecoded && isFolderDecoded || Files.exists(path)) {
                return path;
            }
        } catch (InvalidPathException invalid) {
            if (isDecoded) {
                throw new RayTracerException(name + ": no valid file name");
            }
        }
        String what = name + ": Java cannot read all letters of " + (isDecoded ? "the folder that it runs in" : "this name");
        throw new RayTracerException(what + ("UTF-8".equals(System.getProperty("native.encoding"))
            ? ", which is not in UTF-8 as this locale is; rename it"
            : " in this locale; begin the command with LC_ALL=C.UTF-8"));
    }
}
