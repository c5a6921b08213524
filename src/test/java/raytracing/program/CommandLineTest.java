package raytracing.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.film.ImageFormat;
import raytracing.parse.RayTracerException;
import raytracing.render.ErrorLimit;
import raytracing.render.PixelGrid;
import raytracing.render.Region;
import raytracing.render.RenderSettings;
import raytracing.shadow.ShadowMethod;
import raytracing.trace.ShadowMode;

class CommandLineTest {
    private static Command.Draw draw(String line) throws RayTracerException {
        return (Command.Draw) CommandLine.parse(words(line));
    }

    private static String[] words(String line) {
        return line.isEmpty() ? new String[0] : line.split(" ");
    }

    /** In the help, in the message about an unknown ending, and in README. */
    @ParameterizedTest
    @EnumSource
    void everyPictureFormatIsNamed(ImageFormat format) throws IOException {
        RayTracerException wrong = assertThrows(RayTracerException.class, () -> draw("scene.txt out.tga"));
        for (String text : List.of(CommandLine.HELP, String.join(" ", wrong.messages()), Files.readString(Path.of("README.md")))) {
            assertTrue(Pattern.compile("\\w+").matcher(text).results()
                .anyMatch(word -> ImageFormat.ofEnding("picture." + word.group()).equals(Optional.of(format))), text);
        }
    }

    @Test
    void twoNamesDrawASceneInTheDefaultSize() throws RayTracerException {
        Command.Draw draw = draw("scene.txt out.png");
        assertEquals(Path.of("scene.txt"), draw.scene());
        assertEquals(Path.of("out.png"), draw.output());
        assertEquals(ImageFormat.PNG, draw.format());
        assertEquals(RenderSettings.DEFAULT, draw.settings());
        assertEquals(500, draw.settings().width());
        assertEquals(500, draw.settings().height());
        assertEquals(1, draw.settings().seed());
        assertEquals(Runtime.getRuntime().availableProcessors(), draw.settings().threads());
    }

    @ParameterizedTest
    @ValueSource(strings = {
        "s.txt o.png 30 20 --threads 3 --seed 5 --samples 4 --opaque-shadows",
        "--opaque-shadows --samples=4 --seed=5 s.txt --threads=3 o.png 30 20",
        "--threads 3 --seed 5 --samples 4 --opaque-shadows -- s.txt o.png 30 20",
        "--threads 9 --threads 3 s.txt --seed 4 o.png --samples 2 --seed 5 30 --opaque-shadows --opaque-shadows 20 "
            + "--samples 4",
    })
    void optionsMayStandAnywhereAndTheLastCounts(String line) throws RayTracerException {
        RenderSettings settings = draw(line).settings();
        assertEquals(RenderSettings.DEFAULT.withSize(30, 20).withSeed(5)
            .withShadowMode(ShadowMode.ALL_SURFACES_STOP_LIGHT)
            .withSampling(new PixelGrid(4, PixelGrid.Where.EDGES))
            .withWorkers(3, RenderSettings.DEFAULT_TILE_SIZE), settings);
    }

    @Test
    void afterTwoDashesEverythingIsAName() throws RayTracerException {
        assertEquals(Path.of("--seed"), draw("-- --seed --help.png").scene());
    }

    @Test
    void aSeedMayBeNegative() throws RayTracerException {
        assertEquals(-7, draw("s.txt o.png --seed -7").settings().seed());
    }

    @Test
    void shadowsAreTheScenesUnlessTheUserSaysOtherwise() throws RayTracerException {
        assertEquals(ShadowMethod.OF_THE_SCENE, draw("s.txt o.png").settings().shadowMethod());
        assertEquals(ShadowMethod.OF_THE_SCENE, draw("s.txt o.png --shadows sampled").settings().shadowMethod());
        assertEquals(ShadowMethod.Sampled.withRoot(7), draw("s.txt o.png --shadow-rays 7").settings().shadowMethod());
        assertEquals(new ShadowMethod.Exact(), draw("s.txt o.png --shadows=exact").settings().shadowMethod());
    }

    @ParameterizedTest
    @ValueSource(strings = {"0.25", "1", "0.5", ".75", "64", "64.0"})
    void anErrorLimitIsANumberOfSteps(String steps) throws RayTracerException {
        assertEquals(new ErrorLimit(Double.parseDouble(steps)), draw("s.txt o.png --error " + steps).settings().sampling());
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "0.2", "64.1", "-1", "NaN", "1e0", "0x1", "1d", "one", "", "1.", "1,5", "99999999999"})
    void anyOtherErrorLimitIsRefused(String steps) {
        RayTracerException wrong = assertThrows(RayTracerException.class,
            () -> CommandLine.parse("s.txt", "o.png", "--error=" + steps));
        assertEquals("--error: must be a number of steps of 1/255 from 0.25 to 64, such as 1 or 0.5, got " + steps,
            wrong.getMessage());
    }

    @Test
    void underAnErrorLimitShadowsAreExactUnlessTheUserSaysOtherwise() throws RayTracerException {
        assertEquals(new ShadowMethod.Exact(), draw("s.txt o.png --error 1").settings().shadowMethod());
        assertEquals(ShadowMethod.OF_THE_SCENE,
            draw("s.txt o.png --shadows sampled --error 1").settings().shadowMethod());
        assertEquals(ShadowMethod.Sampled.withRoot(7),
            draw("s.txt o.png --error 1 --shadows sampled --shadow-rays 7").settings().shadowMethod());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        --error 1 --samples 4     | --error: finds out how many rays each pixel needs, so it cannot be combined with --samples
        --samples 1 --error 2     | --error: finds out how many rays each pixel needs, so it cannot be combined with --samples
        """)
    void anErrorLimitIsRefusedBesideWhatItDecides(String options, String sentence) {
        RayTracerException wrong =
            assertThrows(RayTracerException.class, () -> draw("s.txt o.png " + options));
        assertEquals(sentence, wrong.getMessage());
    }

    @Test
    void shadowRaysNeedSampledShadowsUnderAnErrorLimit() {
        RayTracerException wrong =
            assertThrows(RayTracerException.class, () -> draw("s.txt o.png --error 1 --shadow-rays 3"));
        assertEquals("--shadow-rays: exact shadows need none, so it cannot be combined with --error, unless with "
            + "--shadows sampled", wrong.getMessage());
    }

    @Test
    void helpAndVersionNeedNoNames() throws RayTracerException {
        assertEquals(new Command.Help(), CommandLine.parse("--help"));
        assertEquals(new Command.Version(), CommandLine.parse("--version"));
        assertEquals(new Command.Help(), CommandLine.parse("s.txt", "--help"));
    }

    @ParameterizedTest(name = "[{index}] {0}")
    @CsvSource(delimiter = '|', quoteCharacter = '"', value = {
        "\"\"                      | no scene and no output: expected SCENE OUTPUT [WIDTH HEIGHT] [options], see --help",
        "s.txt                     | no output: expected SCENE OUTPUT [WIDTH HEIGHT] [options], see --help",
        "s.txt o.png 30            | a width without a height, did you mean s.txt o.png 30 30? See --help",
        "s.txt o.png 30 20 10      | 5 names and sizes, did you mean s.txt o.png 30 20? See --help",
        "s.txt o.tif               | o.tif: unknown picture format, expected a name ending in .png, .jpg, .bmp or .gif",
        "s.txt o                   | o: unknown picture format, expected a name ending in .png, .jpg, .bmp or .gif",
        "s.txt o.gif 65536 2       | width: must be a whole number from 1 to 65535, got 65536",
        "s.txt o.jpg 2 65501       | height: must be a whole number from 1 to 65500, got 65501",
        "s.txt o.png 0 20          | width: must be a whole number from 1 to 715827879, got 0",
        "s.txt o.png 30 -20        | height: must be a whole number from 1 to 715827879, got -20",
        "s.txt o.png 30 2x         | height: must be a whole number from 1 to 715827879, got 2x",
        "s.txt o.png 30 2.0        | height: must be a whole number from 1 to 715827879, got 2.0",
        "s.txt o.bmp 99999 99999   | size: must be at most 500000000 pixels, got 99999 x 99999",
        "s.txt o.gif 65535 65535   | size: must be at most 2147483639 pixels, got 65535 x 65535",
        "s.txt o.png --threads 0   | --threads: must be a whole number from 1 to 1024, got 0",
        "s.txt o.png --threads=1025 | --threads: must be a whole number from 1 to 1024, got 1025",
        "s.txt o.png --threads     | --threads: needs a value, see --help",
        "s.txt o.png --threads=    | --threads: must be a whole number from 1 to 1024, got",
        "s.txt o.png --seed x      | --seed: must be a whole number of at most 18 digits, got x",
        "s.txt o.png --seed 1e3    | --seed: must be a whole number of at most 18 digits, got 1e3",
        "s.txt o.png --shadows no  | --shadows: must be sampled or exact, got no",
        "s.txt o.png --shadow-rays 0 | --shadow-rays: must be a whole number from 1 to 1024, got 0",
        "s.txt o.png --shadow-rays 1025 | --shadow-rays: must be a whole number from 1 to 1024, got 1025",
        "s.txt o.png --shadow-rays 5 --shadows exact | --shadow-rays: exact shadows need none, so it cannot be combined with --shadows exact",
        "s.txt o.png --samples 0   | --samples: must be a whole number from 1 to 32, got 0",
        "s.txt o.png --samples 33  | --samples: must be a whole number from 1 to 32, got 33",
        "s.txt o.png --samples 2x2 | --samples: must be a whole number from 1 to 32, got 2x2, did you mean 2?",
        "s.txt o.png --samples     | --samples: needs a value, see --help",
        "s.txt o.png --help=yes    | --help: takes no value, got yes",
        "s.txt o.png --sead 1      | --sead: unknown option, did you mean --seed? See --help",
        "s.txt o.png --shadow 1    | --shadow: unknown option, did you mean --shadows? See --help",
        "s.txt o.png --treads=4    | --treads: unknown option, did you mean --threads? See --help",
        "s.txt o.png --partial     | --partial: unknown option, see --help",
        "s.txt o.png --gamma 2.2   | --gamma: unknown option, see --help",
        "s.txt o.png -preview      | -preview: unknown option, did you mean --preview? See --help",
        "s.txt o.png --region 0,0,10 | --region: must be X,Y,W,H: left column, top row, width and height, whole numbers with commas, got 0,0,10",
        "s.txt o.png --region -1,0,10,10 | --region: must be X,Y,W,H: left column, top row, width and height, whole numbers with commas, got -1,0,10,10",
        "s.txt o.png --region 0,0,10,0 | --region: must be a part of the picture of 500 x 500 pixels, got 0,0,10,0",
        "s.txt o.png 30 20 --region 20,0,11,20 | --region: must be a part of the picture of 30 x 20 pixels, got 20,0,11,20",
        "s.txt o.png 30 20 --region 0,1,30,20 | --region: must be a part of the picture of 30 x 20 pixels, got 0,1,30,20",
        "s.txt o.png --region 0,0,9999999999,1 | --region: must be a part of the picture of 500 x 500 pixels, got 0,0,9999999999,1",
        "s.txt o.jpg 99999 9 --region 0,0,65501,1 | --region: width and height must be at most 65500 in a file of this format, got 0,0,65501,1",
        "s.txt o.png --stats=xml   | --stats: must be json or nothing, got xml",
        "s.txt o.png --keep-partial --watch | --keep-partial: cannot be combined with --watch, where the picture file is always the last finished picture",
        "s.txt o.png --compare     | --compare: needs a value, see --help",
        "s.txt o.png --compare=    | --compare: needs the name of a picture",
        "s.txt o.png --compare-map m.png | --compare-map: needs --compare FILE, which says what to compare the picture with",
        "s.txt o.png --compare a.png --compare-map m.tif | --compare-map: m.tif: unknown picture format, expected a name ending in .png, .jpg, .bmp or .gif",
        "s.txt o.png 65536 9 --compare a.png --compare-map m.gif | --compare-map: 65536 x 9 pixels are too many for a file of this format; give the map a name ending in .png",
        "s.txt o.png 30000 30000 --compare a.png --compare-map m.bmp | --compare-map: 30000 x 30000 pixels are too many for a file of this format; give the map a name ending in .png",
        "s.txt o.png --compair a.png | --compair: unknown option, did you mean --compare? See --help",
        "s.txt o.png --quiet=1     | --quiet: takes no value, got 1",
        "-h                        | -h: unknown option, did you mean --help? See --help",
    })
    void whatIsWrongIsSaidInOneLine(String line, String expected) {
        RayTracerException wrong = assertThrows(RayTracerException.class, () -> CommandLine.parse(words(line)));
        assertEquals(expected, wrong.getMessage().strip());
    }

    @ParameterizedTest(name = "[{index}] {0}")
    @CsvSource(delimiter = '|', value = {
        "s.txt o.png 500x400      | s.txt o.png 500 400",
        "s.txt o.png 500X400      | s.txt o.png 500 400",
        "s.txt o.png 500,400      | s.txt o.png 500 400",
        "s.txt o.png 500*400      | s.txt o.png 500 400",
        "s.txt o.png 500\u00d7400 | s.txt o.png 500 400",
        "s.txt o.png 500, 400     | s.txt o.png 500 400",
        "s.txt o.png 500 x 400    | s.txt o.png 500 400",
        "s.txt o.png 500 400 0    | s.txt o.png 500 400",
        "s.txt o.png 500 400 4    | s.txt o.png 500 400",
        "s.txt o.png 500          | s.txt o.png 500 500",
        "500 400 s.txt o.png      | s.txt o.png 500 400",
        "o.png s.txt              | s.txt o.png",
        "o.png s.txt 500 400      | s.txt o.png 500 400",
        "o.png s.txt 500x400      | s.txt o.png 500 400",
        "-h                       | --help",
        "-help                    | --help",
        "--h                      | --help",
        "/?                       | --help",
        "help                     | --help",
        "-v                       | --version",
        "-version                 | --version",
        "s.txt o.png --samples 4x4 | 4",
        "s.txt o.png --shadow-rays=5x5 | 5",
    })
    void theNearestRightFormIsSaid(String line, String meant) {
        RayTracerException wrong = assertThrows(RayTracerException.class, () -> CommandLine.parse(words(line)));
        assertTrue(wrong.getMessage().contains(", did you mean " + meant + "?"), wrong.getMessage());
    }

    @ParameterizedTest(name = "[{index}] {0}")
    @ValueSource(strings = {"s.txt", "o.png", "s.txt t.txt", "s.txt o.tif 500x400", "s.txt o.png p.png 500",
        "s.txt o.png 30 2x", "s.txt o.png 0 20", "s.txt o.gif 65536 2", "s.txt o.png --samples 2x3"})
    void whereThereIsNoneNoneIsSaid(String line) {
        RayTracerException wrong = assertThrows(RayTracerException.class, () -> CommandLine.parse(words(line)));
        assertFalse(wrong.getMessage().contains("did you mean"), wrong.getMessage());
    }

    @Test
    void aPictureAloneHasNoScene() {
        assertEquals("no scene: expected SCENE OUTPUT [WIDTH HEIGHT] [options], see --help",
            assertThrows(RayTracerException.class, () -> CommandLine.parse("o.png")).getMessage());
    }

    @Test
    void namesThatNoFileCanHaveAreRefused() {
        RayTracerException wrong =
            assertThrows(RayTracerException.class, () -> CommandLine.parse("a\0b.txt", "o.png"));
        assertTrue(wrong.getMessage().endsWith(": no valid file name"));
    }

    @Test
    void theHelpFitsAScreenAndNamesEveryOption() {
        assertTrue(CommandLine.HELP.lines().count() <= 24);
        assertTrue(CommandLine.HELP.lines().allMatch(line -> line.length() <= 80));
        for (Option option : Option.values()) {
            String word = option.word.replace("=json", "\\[=json\\]");
            assertTrue(Pattern.compile("  " + word + "[ \\[]").matcher(CommandLine.HELP).find(), option.word);
        }
    }

    @ParameterizedTest
    @CsvSource({"--seed, SEED", "--seeds, SEED", "--opaque-shadow, OPAQUE_SHADOWS", "--shadowrays, SHADOW_RAYS",
        "--regoin, REGION", "--prev, PREVIEW", "-q, QUIET", "--stat, STATS", "--kep-partail, KEEP_PARTIAL"})
    void theNearestOptionIsTheOneMeant(String word, Option meant) {
        assertEquals(Optional.of(meant), Option.nearest(word));
    }

    @Test
    void aRegionIsCutOutOfThePictureWhoseSizeMayComeAfterIt() throws RayTracerException {
        RenderSettings settings = draw("s.txt --region 10,20,70,60 o.png 80 80").settings();
        assertEquals(80, settings.width());
        assertEquals(80, settings.height());
        assertEquals(new Region(10, 20, 80, 80), settings.region());
    }

    @Test
    void aPictureIsComparedWithAFileAndMaybeIntoAMap() throws RayTracerException {
        assertEquals(Optional.empty(), draw("s.txt o.png").compare());
        assertEquals(Optional.of(new Command.Compare(Path.of("a.txt"), Optional.empty())),
            draw("s.txt o.png --compare a.txt").compare());
        Command.Compare compare = draw("s.txt --compare-map=m.GIF o.png --compare a.png").compare().orElseThrow();
        assertEquals(Path.of("a.png"), compare.file());
        assertEquals(Path.of("m.GIF"), compare.map().orElseThrow().name());
    }

    /** The map is as large as the region. */
    @Test
    void aMapNeedsNoMorePixelsThanTheRegion() throws RayTracerException {
        Command.Draw draw = draw("s.txt o.png 99999 9 --region 9,0,65500,1 --compare a.png --compare-map m.jpg");
        assertTrue(draw.compare().isPresent());
    }

    @Test
    void aPictureMayBeLargerThanItsFormatIfARegionOfItIsNot() throws RayTracerException {
        assertEquals(100_000, draw("s.txt o.jpg 100000 100000 --region 99990,0,10,10").settings().width());
    }

    @Test
    void nothingIsWantedBesideThePictureUnlessTheUserSaysSo() throws RayTracerException {
        assertEquals(Set.of(), draw("s.txt o.png").extras());
        assertEquals(EnumSet.of(Option.KEEP_PARTIAL, Option.PREVIEW, Option.STATS, Option.STATS_AS_JSON, Option.QUIET),
            draw("s.txt o.png --quiet --preview --stats --stats=json --keep-partial").extras());
        assertEquals(Set.of(Option.WATCH), draw("s.txt --watch o.png").extras());
    }
}
