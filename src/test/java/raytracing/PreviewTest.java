package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The window, on a virtual screen, and where there is none. */
class PreviewTest {
    /** No two neighbours alike: shadows and highlights everywhere. */
    private static final String SCENE = """
        cam 0 6 -8   0 0 0   0 1 0   1 1
        set 0.2 0.3 0.4   8 4
        mtl 0.8 0.7 0.6   0.3 0.3 0.3   0 0 0   20 0
        mtl 0.8 0.3 0.2   0.3 0.3 0.3   0 0 0   20 0
        pln 0 1 0  -1  1
        sph 0 0 0    1  2
        sph 2 0 1    1  2
        sph -2 0 1   1  2
        sph 1 1.5 1  1  2
        lgt 3 7 -3   1 1 1   1 1 6
        """;

    @TempDir
    private Path folder;

    @BeforeEach
    void writeScene() throws Exception {
        Files.writeString(folder.resolve("scene.txt"), SCENE);
    }

    private VirtualScreen screen() throws Exception {
        return VirtualScreen.start(Files.createDirectory(folder.resolve("screen")));
    }

    private WatchedProgram start(VirtualScreen screen, String arguments) throws Exception {
        return WatchedProgram.start(screen, List.of(), folder, arguments.split(" "));
    }

    private BufferedImage picture(String name) throws Exception {
        return ImageIO.read(folder.resolve(name).toFile());
    }

    /**
     * Where the window is on the black screen; its picture is at the upper left corner, where this scene is not black. Java
     * itself may be wrong about that: without a window manager it sometimes misses where the window was put.
     */
    private static Rectangle window(BufferedImage screen) {
        Rectangle window = new Rectangle(0, 0, -1, -1);
        for (int y = 0; y < screen.getHeight(); y++) {
            for (int x = 0; x < screen.getWidth(); x++) {
                if (screen.getRGB(x, y) << 8 != 0) {
                    window.add(new Rectangle(x, y, 1, 1));
                }
            }
        }
        return window;
    }

    /** Where the picture is seen in a window of its width. */
    private static Rectangle awaitView(VirtualScreen screen, int width, int height) throws Exception {
        Patience.await("window of that size", () -> {
            Rectangle window = window(screen.screenshot());
            return window.width == width && window.height > height;
        });
        return new Rectangle(window(screen.screenshot()).getLocation(), new Dimension(width, height));
    }

    /** Whether a part of a picture is on the screen, each pixel a square. */
    private static boolean shows(BufferedImage screen, Rectangle part, int scale, BufferedImage picture, int left, int top) {
        for (int y = 0; y < part.height; y++) {
            for (int x = 0; x < part.width; x++) {
                if ((screen.getRGB(part.x + x, part.y + y) ^ picture.getRGB(left + x / scale, top + y / scale)) << 8 != 0) {
                    return false;
                }
            }
        }
        return true;
    }

    private void awaitPicture(VirtualScreen screen, Rectangle part, int scale, BufferedImage picture, int left, int top)
            throws Exception {
        Patience.await("picture on the screen",
            () -> shows(screen.screenshot(), part, scale, picture, left, top));
    }

    @Test
    void theWindowShowsTheRegionPixelForPixelUntilItIsClosed() throws Exception {
        try (VirtualScreen screen = screen();
             WatchedProgram program = start(screen, "scene.txt out.png 640 480 --region 100,50,400,300 --preview")) {
            Patience.await("end of the drawing",
                () -> program.tell("title").matches("out\\.png: 400 x 300 pixels at 100, 50 of 640 x 480 in \\d+ m?s"));
            assertEquals("400 300", program.tell("size"));
            Rectangle view = awaitView(screen, 400, 300);
            BufferedImage picture = picture("out.png");
            awaitPicture(screen, view, 1, picture, 0, 0);
            program.tell("point " + (view.x + 120) + " " + (view.y + 80));
            for (int scale = 2; scale <= 16; scale *= 2) {
                program.tell("wheel -1");
            }
            int sixteen = 16;
            Rectangle around = new Rectangle(view.x + 120 - 3 * sixteen, view.y + 80 - 2 * sixteen, 10 * sixteen, 8 * sixteen);
            awaitPicture(screen, around, sixteen, picture, 120 - 3, 80 - 2);
            int pixel = picture.getRGB(120, 80);
            assertEquals("220, 130:  " + (pixel >> 16 & 255) + " " + (pixel >> 8 & 255) + " " + (pixel & 255) + " 1600 %",
                program.tell("status"));
            program.tell("grip");
            program.tell("point " + (view.x + 120 + 5 * sixteen) + " " + (view.y + 80 + sixteen));
            program.tell("release");
            awaitPicture(screen, around, sixteen, picture, 120 - 8, 80 - 3);
            Patience.await("focus", () -> program.tell("focus").equals("true"));
            program.tell("type 0");
            awaitPicture(screen, view, 1, picture, 0, 0);
            assertTrue(program.isRunning());
            program.order("escape");
            assertEquals(0, program.await());
        }
    }

    @Test
    void oneToOneIsSoOnFineScreensToo() throws Exception {
        try (VirtualScreen screen = screen();
             WatchedProgram program = WatchedProgram.start(screen, List.of("-Dsun.java2d.uiScale=2"), folder,
                 "scene.txt", "out.png", "800", "600", "--shadow-rays", "1", "--preview")) {
            Patience.await("end of the drawing", () -> program.tell("title").contains(" pixels in "));
            assertEquals("400 300", program.tell("size"), "in units of two pixels each way");
            Rectangle view = awaitView(screen, 800, 600);
            awaitPicture(screen, view, 1, picture("out.png"), 0, 0);
            program.order("close");
            assertEquals(0, program.await());
        }
    }

    /** Edges of the squares are 16 or 4 pixels. How many shadow rays keep them there until they are seen is up to the machine. */
    @Test
    void aSlowPictureIsCoarseAtFirst() throws Exception {
        try (VirtualScreen screen = screen()) {
            int root = 64;
            while (!wasCoarse(screen, root)) {
                root *= 2;
            }
        }
    }

    private boolean wasCoarse(VirtualScreen screen, int root) throws Exception {
        Dimension size = new Dimension(320, 240);
        try (WatchedProgram program = start(screen, "scene.txt out.png 320 240 --shadow-rays " + root + " --preview")) {
            Patience.await("coarse look, or end of the drawing",
                () -> program.tell("title").contains(" pixels in ") || isCoarse(screen.screenshot(), size));
            return !program.tell("title").contains(" pixels in ");
        }
    }

    /** Not even the coarse look at this picture comes to an end. */
    @Test
    void escapeLeavesTheOlderFile() throws Exception {
        Files.writeString(folder.resolve("out.png"), "older");
        try (VirtualScreen screen = screen();
             WatchedProgram program = start(screen, Endless.arguments(folder, "out.png") + " --preview")) {
            Patience.await("beginning of the drawing", () -> program.tell("title").startsWith("out.png - 0 %"));
            Patience.await("focus", () -> program.tell("focus").equals("true"));
            program.order("escape");
            assertEquals(130, program.await(), program.errors());
            assertTrue(program.errors().matches("(?s).*out\\.png: stopped at 0 %, the file is as it was\\R"),
                program.errors());
        }
        assertEquals("older", Files.readString(folder.resolve("out.png")));
    }

    /** Most squares of 4 x 4 pixels are even, and there are many colours: no picture of this scene is like that. */
    private static boolean isCoarse(BufferedImage screen, Dimension size) {
        Rectangle view = new Rectangle(window(screen).getLocation(), size);
        if (window(screen).width < view.width) {
            return false;
        }
        int edge = 4;
        int even = 0;
        Set<Integer> colours = new HashSet<>();
        for (int y = 0; y < view.height; y += edge) {
            for (int x = 0; x < view.width; x += edge) {
                Set<Integer> inSquare = new HashSet<>();
                for (int i = 0; i < edge * edge; i++) {
                    inSquare.add(screen.getRGB(view.x + x + i % edge, view.y + y + i / edge));
                }
                even += inSquare.size() == 1 && isWarm(inSquare.iterator().next()) ? 1 : 0;
                colours.addAll(inSquare);
            }
        }
        return colours.size() > 100 && edge * edge * even > 0.7 * view.width * view.height;
    }

    /** All of this scene is; what is not drawn yet is not. */
    private static boolean isWarm(int rgb) {
        return (rgb >> 16 & 255) >= (rgb & 255);
    }

    /** The window must be closed before the picture is finished: how large a picture takes so long is up to the machine. */
    @Test
    void aClosedWindowTakesNothingFromThePicture() throws Exception {
        try (VirtualScreen screen = screen()) {
            int root = 32;
            while (!wasClosedWhileDrawing(screen, root)) {
                root *= 2;
            }
            Program.run(folder, "scene.txt", "unwatched.png", "400", "300", "--shadow-rays", String.valueOf(root));
        }
        assertEquals(-1, Files.mismatch(folder.resolve("unwatched.png"), folder.resolve("out.png")));
    }

    private boolean wasClosedWhileDrawing(VirtualScreen screen, int root) throws Exception {
        Files.deleteIfExists(folder.resolve("out.png"));
        try (WatchedProgram program = start(screen, "scene.txt out.png 400 300 --shadow-rays " + root + " --preview")) {
            program.tell("title");
            program.order("close");
            Patience.await("closed window", () -> !program.isRunning() || window(screen.screenshot()).isEmpty());
            boolean isDrawing = !Files.exists(folder.resolve("out.png"));
            assertEquals(0, program.await(), program.errors());
            assertTrue(program.errors().matches(".*\\Rout\\.png: 400 x 300 pixels in \\d+ m?s\\R"), program.errors());
            return isDrawing;
        }
    }

    /** Some 128,000 pixels of the screen in a row, if it were drawn as a whole. */
    @Test
    void aLargePictureIsSeenAtTheLargestScale() throws Exception {
        try (VirtualScreen screen = screen();
             WatchedProgram program = start(screen, "scene.txt out.png 2000 2000 --shadow-rays 1 --preview")) {
            Patience.await("end of the drawing", () -> program.tell("title").contains(" pixels in "));
            program.tell("point 640 512");
            for (int i = 0; i < 9; i++) {
                program.tell("wheel -1");
            }
            Patience.await("largest scale", () -> program.tell("status").endsWith(" 6400 %"));
            String status = program.tell("status");
            int column = Integer.parseInt(status.split(",")[0]);
            int row = Integer.parseInt(status.split("[ :]+")[1]);
            int rgb = picture("out.png").getRGB(column, row);
            Patience.await("that pixel as a square", () -> (screen.screenshot().getRGB(640, 512) ^ rgb) << 8 == 0);
            program.order("escape");
            assertEquals(0, program.await());
        }
    }

    private String withoutAWindow(Path javaHome, List<String> javaOptions, String display) throws Exception {
        Program program = Program.run(javaHome, javaOptions, Map.of("DISPLAY", display), folder,
            "scene.txt", "out.png", "40", "30", "--preview", "--quiet");
        assertEquals(0, program.status());
        assertEquals(40, picture("out.png").getWidth());
        return program.errors();
    }

    @ParameterizedTest(name = "{0}, DISPLAY={1}")
    @CsvSource(delimiter = '|', value = {
        "-Djava.awt.headless=true  | :987    | java.awt.headless=true forbids Java to open windows",
        "-Djava.awt.headless=true  | ''      | java.awt.headless=true forbids Java to open windows",
        "-Djava.awt.headless=false | :987    | no display to open a window on, DISPLAY is :987 and cannot be reached",
        "-Ddefault                 | ''      | no display to open a window on, DISPLAY is not set",
        "-Ddefault                 | :987    | no display to open a window on, DISPLAY is :987 and cannot be reached",
        "-Ddefault                 | nowhere | no display to open a window on, DISPLAY is nowhere and cannot be reached",
    })
    void withoutADisplayASentenceComesAndThePictureToo(String option, String display, String sentence) throws Exception {
        Skipped.unless(VirtualScreen.isOpenTo(Program.JAVA_HOME), "this Java has no windows");
        assertEquals("--preview: " + sentence + "; drawing goes on without it" + System.lineSeparator(),
            withoutAWindow(Program.JAVA_HOME, List.of(option), display));
    }

    @Test
    void aJavaWithoutWindowsSaysWhichHasThem() throws Exception {
        try (JavaWithout java = JavaWithout.file(VirtualScreen.WINDOWS, folder.resolve("java"))) {
            assertEquals("--preview: this Java has no windows; on Debian and Ubuntu install openjdk-"
                + Runtime.version().feature() + "-jre, elsewhere a full JDK; drawing goes on without it"
                + System.lineSeparator(), withoutAWindow(java.home(), List.of(), ":987"));
            assertEquals("--preview: no display to open a window on, DISPLAY is not set; drawing goes on without it"
                + System.lineSeparator(), withoutAWindow(java.home(), List.of(), ""));
        }
    }

    /** As where Java is unpacked from an archive, on a system without the X libraries. */
    @Test
    void aMissingLibraryIsNamed() throws Exception {
        try (JavaWithout java = JavaWithout.file(VirtualScreen.WINDOWS, folder.resolve("java"))) {
            Files.writeString(java.home().resolve(VirtualScreen.WINDOWS), "");
            Program program = Program.run(java.home(), List.of(), Map.of("DISPLAY", ":987"), folder,
                "scene.txt", "out.png", "40", "30", "--preview");
            assertTrue(program.errors().lines().anyMatch(line -> line.matches("--preview: a library that this Java needs for "
                + "windows is missing \\(.*libawt_xawt\\.so.*\\); drawing goes on without it")), program.errors());
        }
    }
}
