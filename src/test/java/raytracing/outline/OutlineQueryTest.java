package raytracing.outline;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.SceneFiles;
import raytracing.SceneText;
import raytracing.scene.CameraRays;
import raytracing.scene.Scene;
import raytracing.trace.OrdinaryLengths;
import raytracing.trace.PreparedScene;
import raytracing.trace.Queries;
import raytracing.trace.ShadowMode;

/** A pixel that the query calls uniform shows one list of surfaces, whatever ray goes through it; few others do. */
class OutlineQueryTest {
    private static final double[] SCALES = {1, 1, 1, 1e9, 1e-9, 0x1p-100};
    private static final double[] DISTANCES = {0, 0, 0, 100, 1e5, 1e9};
    private static final int SCENES = 48;
    private static final int RAYS_IN_A_PIXEL = 6;
    private static final int HALVINGS = 70;

    private static final String EMPTY = """
        set 0 0 0 1 1
        mtl 1 1 1 0 0 0 0 0 0 1 0
        mtl 1 1 1 0 0 0 0 0 0 1 0.5
        """;

    /** One picture with its answers. */
    private record Picture(CameraRays rays, SeenList seen, int[] answers) {
        static Picture of(Scene scene, int width, int height, double leastSteps) {
            PreparedScene prepared = Queries.prepared(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
            CameraRays rays = new CameraRays(scene.camera(), width, height);
            OutlineQuery query = new OutlineQuery(prepared, scene, rays, leastSteps);
            int[] answers = new int[width * height];
            for (int block = 0; block < blocks(width) * blocks(height); block++) {
                ask(query, block % blocks(width), block / blocks(width), width, height, answers);
            }
            return new Picture(rays, new SeenList(scene, prepared, rays), answers);
        }

        static int blocks(int edge) {
            return (edge + OutlineQuery.BLOCK - 1) / OutlineQuery.BLOCK;
        }

        static void ask(OutlineQuery query, int blockX, int blockY, int width, int height, int[] answers) {
            query.aim(blockX, blockY);
            for (int y = OutlineQuery.BLOCK * blockY; y < Math.min(height, OutlineQuery.BLOCK * (blockY + 1)); y++) {
                for (int x = OutlineQuery.BLOCK * blockX; x < Math.min(width, OutlineQuery.BLOCK * (blockX + 1)); x++) {
                    answers[y * width + x] = query.raysNeeded(x, y);
                }
            }
        }

        int at(double x, double y) {
            return answers[(int) y * rays.width() + (int) x];
        }
    }

    private static Picture random(RandomViews.Kind kind, SplittableRandom random) {
        double scale = SCALES[random.nextInt(SCALES.length)];
        double far = DISTANCES[random.nextInt(DISTANCES.length)];
        Scene scene = new RandomViews(random).scene(kind, scale, far);
        return Picture.of(scene, random.nextInt(8, 50), random.nextInt(8, 50), 0);
    }

    private static int scenes(RandomViews.Kind kind) {
        return isCrowded(kind) ? SCENES / 4 : SCENES;
    }

    private static boolean isCrowded(RandomViews.Kind kind) {
        return kind == RandomViews.Kind.HEAP || kind == RandomViews.Kind.FINE_MESH;
    }

    /** Together over a million pairs of a random ray, or one through a corner, and that through the middle. */
    @ParameterizedTest
    @EnumSource(RandomViews.Kind.class)
    void allRaysOfAUniformPixelSeeTheSame(RandomViews.Kind kind) {
        SplittableRandom random = new SplittableRandom(1);
        long pairs = 0;
        for (int i = 0; i < scenes(kind); i++) {
            Picture picture = random(kind, random);
            for (int pixel = 0; pixel < picture.answers.length; pixel++) {
                if (picture.answers[pixel] == 1) {
                    pairs += RAYS_IN_A_PIXEL;
                    assertOneList(picture, pixel % picture.rays.width(), pixel / picture.rays.width(), random);
                }
            }
        }
        assertTrue(pairs > (isCrowded(kind) ? 30_000 : 140_000), pairs + " pairs");
    }

    private static void assertOneList(Picture picture, int x, int y, SplittableRandom random) {
        long middle = picture.seen.at(x + 0.5, y + 0.5);
        for (int k = 0; k < RAYS_IN_A_PIXEL; k++) {
            double rayX = x + (k < 2 ? random.nextInt(2) : random.nextDouble());
            double rayY = y + (k < 2 ? random.nextInt(2) : random.nextDouble());
            assertEquals(middle, picture.seen.at(rayX, rayY), () -> "pixel " + x + ", " + y + " at " + rayX + ", " + rayY);
        }
    }

    /** Two rays anywhere that see different lists have an outline between them; halving finds it to the last bit. */
    @ParameterizedTest
    @EnumSource(RandomViews.Kind.class)
    void noOutlineIsMissedWhereTwoRaysEncloseIt(RandomViews.Kind kind) {
        SplittableRandom random = new SplittableRandom(2);
        int found = 0;
        for (int i = 0; i < scenes(kind); i++) {
            Picture picture = random(kind, random);
            for (int line = 0; line < 300; line++) {
                found += checkOutline(picture, random);
            }
        }
        int outlines = found;
        assertTrue(found > (kind == RandomViews.Kind.DUST || kind == RandomViews.Kind.SPLINTERS ? 100 : 500), () -> outlines + " outlines");
    }

    /** Returns 1 if there is an outline between two random rays, both ends of which are in one pixel. */
    private static int checkOutline(Picture picture, SplittableRandom random) {
        double width = picture.rays.width();
        double height = picture.rays.height();
        double x = random.nextDouble(width);
        double y = random.nextDouble(height);
        double otherX = random.nextDouble(width);
        double otherY = random.nextDouble(height);
        long list = picture.seen.at(x, y);
        if (list == picture.seen.at(otherX, otherY)) {
            return 0;
        }
        for (int i = 0; i < HALVINGS; i++) {
            double middleX = 0.5 * (x + otherX);
            double middleY = 0.5 * (y + otherY);
            boolean isSame = picture.seen.at(middleX, middleY) == list;
            x = isSame ? middleX : x;
            y = isSame ? middleY : y;
            otherX = isSame ? otherX : middleX;
            otherY = isSame ? otherY : middleY;
        }
        if ((int) x != (int) otherX || (int) y != (int) otherY) {
            return 0;
        }
        String place = x + ", " + y;
        assertTrue(picture.at(x, y) >= 16, () -> "an outline at " + place + " is missed");
        return 1;
    }

    @Test
    void answersDoNotDependOnWhatWasAskedBefore() {
        SplittableRandom random = new SplittableRandom(3);
        for (RandomViews.Kind kind : RandomViews.Kind.values()) {
            Scene scene = new RandomViews(random).scene(kind, 1, 0);
            int width = 50;
            int[] expected = Picture.of(scene, width, width, 0).answers;
            OutlineQuery query = new OutlineQuery(Queries.prepared(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT), scene,
                new CameraRays(scene.camera(), width, width), 0);
            int blocks = Picture.blocks(width);
            int[] answers = new int[width * width];
            for (int block = blocks * blocks - 1; block >= 0; block--) {
                query.aim(random.nextInt(blocks), random.nextInt(blocks));
                Picture.ask(query, block % blocks, block / blocks, width, width, answers);
            }
            assertArrayEquals(expected, answers);
        }
    }

    /**
     * On the project's scenes, 1.12 times as many pixels are said to need rays as 16 x 16 rays find a second list in
     * (measured). An outline exactly along the border of two pixels counts for both of them.
     */
    @Test
    void fewPixelsAreSaidToNeedRaysForNothing() throws IOException {
        int needed = 0;
        int useful = 0;
        for (Path file : SceneFiles.all().toList()) {
            Scene scene = OrdinaryLengths.of(SceneText.scene(Files.readString(file)));
            Picture picture = Picture.of(scene, 200, 200, 0.5);
            for (int pixel = 0; pixel < picture.answers.length; pixel++) {
                if (picture.answers[pixel] > 1) {
                    needed++;
                    useful += hasTwoLists(picture, pixel % 200, pixel / 200) ? 1 : 0;
                }
            }
        }
        double ratio = needed / (double) useful;
        assertTrue(ratio < 1.25, () -> "ratio " + ratio);
    }

    private static boolean hasTwoLists(Picture picture, int x, int y) {
        long middle = picture.seen.at(x + 0.5, y + 0.5);
        for (int k = 0; k < 256; k++) {
            if (picture.seen.at(x + (k % 16 + 0.5) / 16, y + (k / 16 + 0.5) / 16) != middle) {
                return true;
            }
        }
        return false;
    }

    /**
     * The camera's screen is as wide as it is far off: at 100 pixels, a ball at a distance of 100 has its radius in pixels.
     */
    private static int raysForBall(double radius, String lens, double leastSteps) {
        Scene scene = SceneText.scene("cam 0 0 0 0 0 1 0 1 0 1 1" + lens, EMPTY,
            "sph 0.5 0.5 100 " + radius + " 1");
        Picture picture = Picture.of(scene, 100, 100, leastSteps);
        return picture.at(50, 49);
    }

    /** A disc of radius rho holds a cell of a net of n points if rho^2 n is at least 2; a power of four. */
    @ParameterizedTest
    @CsvSource({"0.4, 16", "0.36, 16", "0.35, 64", "0.18, 64", "0.17, 256", "0.05, 1024", "0.04, 4096", "0.001, 4096"})
    void aSmallBallNeedsSoManyRaysThatOneHitsIt(double radius, int rays) {
        assertEquals(rays, raysForBall(radius, "", 0));
        assertEquals(rays, raysForBall(radius, " true 0", 0));
        assertEquals(rays, raysForBall(radius, " true 0.5", 0));
        assertEquals(rays, raysForBall(radius, " true -0.5", 0));
    }

    /** Half a step is an area of 0.00196 pixels: a radius of 0.02497. */
    @Test
    void aBallOfLessThanTheLeastStepsIsNotLookedFor() {
        assertEquals(4096, raysForBall(0.0251, "", 0.5));
        assertEquals(1, raysForBall(0.0249, "", 0.5));
    }

    @Test
    void ballsOfTogetherMoreThanTheLeastStepsAreLookedFor() {
        StringBuilder balls = new StringBuilder();
        for (int i = 0; i < 5; i++) {
            balls.append("sph ").append(0.3 + 0.1 * i).append(" 0.5 100 0.012 1\n");
        }
        String camera = "cam 0 0 0 0 0 1 0 1 0 1 1";
        Scene five = SceneText.scene(camera, EMPTY, balls.toString());
        Scene four = SceneText.scene(camera, EMPTY, balls.substring(0, balls.lastIndexOf("sph")));
        assertEquals(4096, Picture.of(five, 100, 100, 0.5).at(50, 49));
        assertEquals(1, Picture.of(four, 100, 100, 0.5).at(50, 49));
    }

    /** Of a cube, the ball inside counts: half the edge. */
    @Test
    void aSmallBoxCountsAsTheBallInIt() {
        Scene scene = SceneText.scene("cam 0 0 0 0 0 1 0 1 0 1 1", EMPTY, "box 0.5 0.5 100 0.101 1");
        assertEquals(1024, Picture.of(scene, 100, 100, 0.5).at(50, 49));
    }

    /** The equidistant lens shows black from R = pi / 2 on: 25 pi / 2 = 39.27 pixels from the middle of this picture. */
    @ParameterizedTest
    @ValueSource(strings = {"0", "0.000001", "-0.000001"})
    void pixelsOnTheBorderOfBlackNeedRaysAndThoseBeyondDoNot(String k) {
        Scene scene = SceneText.scene("cam 0 0 0 0 0 1 0 1 0 0.25 1 true " + k, EMPTY, "pln 0 0 1 9 1", "pln 0 0 1 -9 1");
        Picture picture = Picture.of(scene, 100, 100, 0);
        assertEquals(16, picture.at(50 + 39, 50));
        assertEquals(1, picture.at(50 + 40, 50));
        assertEquals(1, picture.at(50 + 37, 50));
        assertEquals(1, picture.at(2, 97));
        long border = Arrays.stream(picture.answers).filter(rays -> rays > 1).count();
        assertTrue(border > 300 && border < 380, () -> border + " pixels");   // a circle crosses 8 r = 314 of them
    }

    /** Behind a wall nothing is looked for, and behind glass all is. */
    @ParameterizedTest
    @CsvSource({"1, 1", "2, 16"})
    void bodiesBehindAWallDoNotMatter(int material, int rays) {
        Scene scene = SceneText.scene("cam 0 0 0 0 0 1 0 1 0 1 1", EMPTY, "sph 0.5 0.5 100 0.5 1",
            "pln 0 0 1 50 " + material);
        assertEquals(rays, Picture.of(scene, 100, 100, 0).at(50, 49));
    }

    /** The eye lies in the plane of a face: the other faces are told apart all the same. */
    @Test
    void aBoxOnTheLevelOfTheEyeIsUniformInsideItsFace() {
        Scene scene = SceneText.scene("cam 0 0 0 0 0 1 0 1 0 1 1", EMPTY, "box 0 10 50 20 1");
        Picture picture = Picture.of(scene, 100, 100, 0);
        assertEquals(1, picture.at(50, 40));
        assertEquals(1, picture.at(50, 60));
        assertEquals(16, picture.at(50, 50));
    }
}
