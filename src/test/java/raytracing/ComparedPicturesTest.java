package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** {@code --compare} and {@code --compare-map}, as users see them. */
class ComparedPicturesTest {
    private static final int WIDTH = 8;
    private static final int HEIGHT = 4;

    /** Nothing but the sky, whose colour is {@link #SKY} in every pixel: 0.25 of 255 is 63.75, and the half 127.5. */
    private static final String SCENE = "cam 0 0 -5 0 0 0 0 1 0 1 1\nset 0.25 0.5 1 1 1\n";
    private static final int SKY = 0x4080ff;

    /** Of three pixels: 3 steps in red; 1 in green; 64, 128 and 255 in all channels. The mean square is 85515 / 96. */
    private static final String FIGURES = "RMS 29.85 steps, PSNR 18.63 dB, largest difference 255 of 255, "
        + "6.25 % of the pixels off by more than 1 step";
    private static final String EQUAL =
        "RMS 0 steps, PSNR Infinity dB, largest difference 0 of 255, 0 % of the pixels off by more than 1 step";
    private static final Pattern SENTENCE = Pattern.compile("RMS (\\S+) steps, PSNR (\\S+) dB, "
        + "largest difference (\\d+) of 255, (\\S+) % of the pixels off by more than 1 step\\R$");

    @TempDir
    private Path folder;

    @BeforeEach
    void writeScene() throws IOException {
        Files.writeString(folder.resolve("scene.txt"), SCENE);
    }

    private static BufferedImage sky(int width, int height) {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < width * height; i++) {
            image.setRGB(i % width, i / width, SKY);
        }
        return image;
    }

    private static BufferedImage changedSky() {
        BufferedImage image = sky(WIDTH, HEIGHT);
        image.setRGB(0, 0, 0x4380ff);
        image.setRGB(5, 2, 0x407fff);
        image.setRGB(7, 3, 0);
        return image;
    }

    private Path save(BufferedImage image, String name) throws IOException {
        Path file = folder.resolve(name);
        assertTrue(ImageIO.write(image, name.substring(name.lastIndexOf('.') + 1), file.toFile()));
        return file;
    }

    /** Draws the scene with some more words, which are divided by spaces. */
    private Program draw(String words) throws Exception {
        return Program.run(folder, ("scene.txt out.png " + WIDTH + " " + HEIGHT + " " + words).split(" "));
    }

    private static String line(String sentence) {
        return sentence + System.lineSeparator();
    }

    private void assertRefused(String sentence, Program program) {
        assertEquals(line(sentence), program.errors());
        assertEquals("", program.output());
        assertEquals(2, program.status());
    }

    @Test
    void theFiguresAreALineOnStandardOutput() throws Exception {
        save(changedSky(), "other.png");
        Program program = draw("--compare other.png --quiet");
        assertEquals(line("out.png: compared with other.png: " + FIGURES), program.output());
        assertEquals("", program.errors());
        assertEquals(0, program.status());
    }

    @Test
    void theUsualMessagesStayOnStandardError() throws Exception {
        save(sky(WIDTH, HEIGHT), "other.png");
        Program program = draw("--compare other.png --compare-map map.png");
        assertEquals(line("out.png: compared with other.png: " + EQUAL), program.output());
        assertTrue(program.errors().matches("(?s).*out\\.png: 8 x 4 pixels in \\d+ ms\\R"
            + "map\\.png: where the pictures differ: black equal, blue 1 step, violet 4, red 16, yellow 64, white 255\\R"),
            program.errors());
    }

    @Test
    void aSingleStepInOnePixelIsNotRoundedAway() throws Exception {
        BufferedImage image = sky(500, 500);
        image.setRGB(250, 250, 0x4080fe);
        save(image, "other.png");
        Program program = Program.run(folder, "scene.txt", "out.png", "--compare", "other.png", "--quiet");
        assertEquals(line("out.png: compared with other.png: RMS 0.001155 steps, PSNR 106.88 dB, "
            + "largest difference 1 of 255, 0 % of the pixels off by more than 1 step"), program.output());
    }

    /** Of jpg and gif, what the format has lost counts. */
    @ParameterizedTest
    @ValueSource(strings = {"png", "jpg", "bmp", "gif"})
    void whatIsComparedIsThePictureInItsFile(String ending) throws Exception {
        Files.writeString(folder.resolve("scene.txt"), "cam 0 2 -6  0 0 0  0 1 0  1 1\nset 0.2 0.3 0.4  1 4\n"
            + "mtl 0.8 0.4 0.2  0.5 0.5 0.5  0.2 0.2 0.2  20 0\npln 0 1 0 -1 1\nsph 0 0 0 1 1\n"
            + "lgt 3 5 -3  1 1 1  1 0.9 0\n");
        BufferedImage other = ImageIO.read(Path.of("scenes", "ball.png").toFile()).getSubimage(200, 100, 60, 50);
        save(other, "other.png");
        Program program =
            Program.run(folder, "scene.txt", "out." + ending, "60", "50", "--compare", "other.png", "--quiet");
        PictureDifference difference = new PictureDifference(ImageIO.read(folder.resolve("out." + ending).toFile()), other);
        Matcher figures = SENTENCE.matcher(program.output());
        assertTrue(figures.find(), program.output() + program.errors());
        assertEquals(difference.rootMeanSquare(), Double.parseDouble(figures.group(1)), 5e-4 * difference.rootMeanSquare());
        assertEquals(String.format(Locale.ROOT, "%.2f", difference.psnr()), figures.group(2));
        assertEquals(difference.largest(), Integer.parseInt(figures.group(3)));
        assertEquals(100 * difference.shareOffByMoreThan(1), Double.parseDouble(figures.group(4)), 0.05);
    }

    @Test
    void theFileMayBeTheOutputItself() throws Exception {
        save(changedSky(), "out.png");
        assertEquals(line("out.png: compared with out.png: " + FIGURES), draw("--compare out.png --quiet").output());
        assertEquals(line("out.png: compared with ./out.png: " + EQUAL), draw("--compare ./out.png --quiet").output());
    }

    /** In a heap of 32 MB, 524,288 pixels are kept. Others are read again from the file that the output has replaced. */
    @Test
    void theFileMayBeTheOutputAlsoIfItIsTooLargeToBeKept() throws Exception {
        BufferedImage image = sky(800, 700);
        image.setRGB(799, 699, 0);
        save(image, "out.png");
        Program program = Program.run(Program.JAVA_HOME, List.of("-Xmx32m"), folder, "scene.txt", "out.png", "800", "700",
            "--compare", "out.png", "--compare-map", "map.png", "--quiet", "--threads", "1");
        assertEquals(line("out.png: compared with out.png: RMS 0.2256 steps, PSNR 61.06 dB, largest difference 255 of 255, "
            + "0.0001786 % of the pixels off by more than 1 step"), program.output(), program.errors());
        BufferedImage map = ImageIO.read(folder.resolve("map.png").toFile());
        assertEquals(0xffffffff, map.getRGB(799, 699));
        assertEquals(0xff000000, map.getRGB(798, 699));
    }

    @Test
    void aRegionIsComparedWithAFileOfItsSize() throws Exception {
        save(sky(3, 2), "part.png");
        assertEquals(line("out.png: compared with part.png: " + EQUAL),
            draw("--region 4,1,3,2 --compare part.png --quiet").output());
        save(sky(WIDTH, HEIGHT), "whole.png");
        assertRefused("--compare: whole.png: has 8 x 4 pixels, but what is to be drawn has 3 x 2 pixels; "
            + "draw the same size, or compare with another file", draw("--region 4,1,3,2 --compare whole.png"));
    }

    /** The scene is missing too, which is not said: it has not been looked for yet. */
    @ParameterizedTest(name = "{0}")
    @CsvSource(delimiter = '|', value = {
        "none.png  | none.png: no such file, expected a picture",
        "sub       | sub: is a folder, expected a picture",
        "empty.png | empty.png: is empty, expected a picture",
        "text.png  | text.png: is no picture that can be read, expected a png, jpg, bmp or gif",
        "cut.png   | cut.png: cannot be read to its end, as it is damaged, cut off or of a rare kind; save it again as png",
        "small.png | small.png: has 7 x 4 pixels, but what is to be drawn has 8 x 4 pixels; draw the same size, or compare with another file",
    })
    void whatCannotBeComparedIsRefusedBeforeAnythingIsDrawn(String file, String sentence) throws Exception {
        Files.delete(folder.resolve("scene.txt"));
        Files.writeString(folder.resolve("out.png"), "older");
        Files.createDirectory(folder.resolve("sub"));
        Files.createFile(folder.resolve("empty.png"));
        Files.writeString(folder.resolve("text.png"), SCENE);
        save(sky(7, HEIGHT), "small.png");
        byte[] whole = Files.readAllBytes(save(sky(WIDTH, HEIGHT), "cut.png"));
        Files.write(folder.resolve("cut.png"), Arrays.copyOf(whole, whole.length - 20));
        List<String> before = Folders.names(folder);
        assertRefused("--compare: " + sentence, draw("--compare " + file + " --compare-map map.png"));
        assertEquals("older", Files.readString(folder.resolve("out.png")));
        assertEquals(before, Folders.names(folder));
    }

    /** Some lead there through links, or are another name of the file; the output need not exist yet. */
    @ParameterizedTest(name = "{0}: {1}")
    @CsvSource(delimiter = '|', value = {
        "true                      | none/map.png | no such folder",
        "mkdir map.png             | map.png      | is a folder, expected a file name",
        "true                      | out.png      | is the picture itself; give the map another name",
        "touch out.png             | ./out.png    | is the picture itself; give the map another name",
        "mkdir sub                 | sub/../out.png | is the picture itself; give the map another name",
        "ln -s out.png map.png     | map.png      | is the picture itself; give the map another name",
        "ln -s map.png out.png     | map.png      | is the picture itself; give the map another name",
        "touch out.png; ln out.png map.png | map.png | is the picture itself; give the map another name",
        "true                      | other.png    | is the picture to compare with; give the map another name",
        "ln -s other.png map.png   | map.png      | is the picture to compare with; give the map another name",
        "ln other.png map.png      | map.png      | is the picture to compare with; give the map another name",
        "mv scene.txt scene.png; ln -s scene.png scene.txt | scene.png | is the scene itself, which the picture would replace; give the picture another name",
        "ln scene.txt map.png      | map.png      | is the scene itself, which the picture would replace; give the picture another name",
    })
    void aMapThatWouldReplaceAnotherFileIsRefusedBeforeAnythingIsDrawn(String commands, String map, String sentence)
            throws Exception {
        byte[] other = Files.readAllBytes(save(sky(WIDTH, HEIGHT), "other.png"));
        assertEquals(new Shell(0, ""), Shell.run(folder, commands));
        List<String> before = Folders.names(folder);
        assertRefused("--compare-map: " + map + ": " + sentence, draw("--compare other.png --compare-map " + map));
        assertEquals(before, Folders.names(folder));
        assertTrue(Arrays.equals(other, Files.readAllBytes(folder.resolve("other.png"))));
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "bmp"})
    void theMapShowsTheDifferencesInFalseColours(String ending) throws Exception {
        save(changedSky(), "other.png");
        assertEquals(0, draw("--compare other.png --compare-map map." + ending).status());
        BufferedImage map = ImageIO.read(folder.resolve("map." + ending).toFile());
        assertEquals(WIDTH, map.getWidth());
        assertEquals(HEIGHT, map.getHeight());
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            int expected = switch (i) {
                case 0 -> 0xff7525c5;                // two thirds of the way from blue to violet
                case 2 * WIDTH + 5 -> 0xff2020b0;
                case 3 * WIDTH + 7 -> 0xffffffff;
                default -> 0xff000000;
            };
            assertEquals(Integer.toHexString(expected), Integer.toHexString(map.getRGB(i % WIDTH, i / WIDTH)), "pixel " + i);
        }
        assertEquals(List.of("map." + ending, "other.png", "out.png", "scene.txt"), Folders.names(folder));
    }

    @ParameterizedTest
    @ValueSource(strings = {"jpg", "gif"})
    void aMapMayHaveAFormatThatLosesSomething(String ending) throws Exception {
        save(sky(WIDTH, HEIGHT), "other.png");
        assertEquals(0, draw("--compare other.png --compare-map map." + ending).status());
        BufferedImage map = ImageIO.read(folder.resolve("map." + ending).toFile());
        assertEquals(0, new PictureDifference(map, new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB)).largest());
    }

    @Test
    void aMapThatDoesNotFitOnTheDiskLeavesTheOlderOneAndTheFigures() throws Exception {
        Path disk = Files.createDirectory(folder.resolve("disk"));
        Shell mount = Shell.run(folder, "mount -t tmpfs -o size=16k tmpfs disk");
        Skipped.unless(mount.status() == 0, "no small disk may be mounted here, so none is full");
        try {
            save(sky(WIDTH, HEIGHT), "other.png");
            Files.writeString(disk.resolve("map.bmp"), "older");
            Shell.run(folder, "head -c 8192 /dev/zero > disk/full");
            save(sky(90, 90), "other.png");
            Program program = Program.run(folder, "scene.txt", "out.png", "90", "90", "--quiet", "--compare", "other.png",
                "--compare-map", "disk/map.bmp");
            assertEquals(line("disk/map.bmp: could not be written: No space left on device; the file is as it was"),
                program.errors());
            assertEquals(1, program.status());
            assertEquals(line("out.png: compared with other.png: " + EQUAL), program.output());
            assertEquals("older", Files.readString(disk.resolve("map.bmp")));
            assertEquals(List.of("full", "map.bmp"), Folders.names(disk));
        } finally {
            Shell.run(folder, "umount disk");
        }
    }

    /** Standard output has nothing but the one object, and the sentence is a message. */
    @Test
    void inJsonTheFiguresAreAGroup() throws Exception {
        save(changedSky(), "other.png");
        Program program = draw("--compare other.png --stats=json");
        JsonObject figures = JsonParser.parseString(program.output()).getAsJsonObject().getAsJsonObject("comparison");
        assertEquals(1, program.output().lines().count());
        assertEquals("other.png", figures.get("file").getAsString());
        assertEquals(Math.sqrt(85515 / 96.0), figures.get("RMS_in_steps").getAsDouble(), 1e-12);
        assertEquals(18.6331, figures.get("PSNR_in_dB").getAsDouble(), 1e-4);
        assertEquals(255, figures.get("largest_difference_in_steps").getAsInt());
        assertEquals(0.0625, figures.get("share_of_pixels_off_by_more_than_a_step").getAsDouble());
        assertTrue(program.errors().contains(line("out.png: compared with other.png: " + FIGURES)), program.errors());
        save(sky(WIDTH, HEIGHT), "other.png");
        assertTrue(JsonParser.parseString(draw("--compare other.png --stats=json --quiet").output()).getAsJsonObject()
            .getAsJsonObject("comparison").get("PSNR_in_dB").isJsonNull());
    }

    @Test
    void theTableOfStatisticsAndTheFiguresGoToDifferentStreams() throws Exception {
        save(sky(WIDTH, HEIGHT), "other.png");
        Program program = draw("--compare other.png --stats --quiet");
        assertEquals(line("out.png: compared with other.png: " + EQUAL), program.output());
        assertTrue(program.errors().startsWith("scene"), program.errors());
    }

    @Test
    void aStoppedPictureIsNotCompared() throws Exception {
        save(sky(Endless.WIDTH, Endless.HEIGHT), "other.png");
        try (TerminalProgram program = TerminalProgram.start(folder, "", Endless.arguments(folder, "out.png"),
            "--keep-partial --compare other.png --compare-map map.png")) {
            program.awaitShown("out.png  50 %");
            program.signal("TERM");
            assertEquals(143, program.awaitEnd());
            assertTrue(program.shown().contains("out.png: not compared with other.png, as the picture is not whole"),
                program.shown());
            assertFalse(program.shown().contains("RMS"), program.shown());
        }
        assertFalse(Files.exists(folder.resolve("map.png")));
    }

    /** A start of the program takes as long as before where nothing is to be compared. */
    @Test
    void nothingIsLoadedForAComparisonThatIsNotAskedFor() throws Exception {
        save(sky(WIDTH, HEIGHT), "other.png");
        List<String> log = List.of("-Xlog:class+load:file=classes");
        Pattern loaded = Pattern.compile("raytracing\\.\\w+\\.(ComparedPicture|Comparison|StoredPicture|DifferenceMap)\\b");
        Program.run(Program.JAVA_HOME, log, folder, "scene.txt", "out.png", "8", "4");
        assertFalse(loaded.matcher(Files.readString(folder.resolve("classes"))).find());
        Program.run(Program.JAVA_HOME, log, folder, "scene.txt", "out.png", "8", "4", "--compare", "other.png");
        assertTrue(loaded.matcher(Files.readString(folder.resolve("classes"))).find());
    }
}
