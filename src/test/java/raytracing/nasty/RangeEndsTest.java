package raytracing.nasty;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.SceneText;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.parallel.ForkJoin;
import raytracing.parse.RayTracerException;
import raytracing.parse.SceneParser;
import raytracing.render.PixelGrid;
import raytracing.render.Region;
import raytracing.render.RenderSettings;
import raytracing.render.Renderers;
import raytracing.scene.Scene;
import raytracing.shadow.ShadowMethod;
import raytracing.trace.ShadowMode;

/**
 * Every number of every line at the ends of the range of doubles, as a scene file may have it: alone and with every other
 * number of its line. Whatever the parser accepts can be drawn, and every pixel is a finite light.
 */
class RangeEndsTest {
    private static final RenderSettings ODD = RenderSettings.DEFAULT.withSize(5, 5).withWorkers(1, 16);
    private static final RenderSettings EVEN = ODD.withSize(4, 4);
    private static final double ROUNDING = 1e-9;

    /** One after the other, scene by scene. */
    private static final List<RenderSettings> WAYS = List.of(
        ODD,
        EVEN,
        ODD.withShadowMethod(new ShadowMethod.Exact()),
        EVEN.withSampling(new PixelGrid(3, PixelGrid.Where.EDGES)),
        ODD.withSampling(new PixelGrid(2, PixelGrid.Where.EVERYWHERE))
            .withShadowMode(ShadowMode.ALL_SURFACES_STOP_LIGHT),
        ODD.withRegion(new Region(2, 2, 3, 3)),
        ODD.withSize(1, 6));

    private static Optional<Scene> read(String text) {
        try {
            return Optional.of(
                SceneParser.parse("scene", text.getBytes(StandardCharsets.UTF_8), ForkJoin.sequential()).scene());
        } catch (RayTracerException refused) {
            return Optional.empty();
        }
    }

    private static void assertLight(List<String> texts, int leastDrawn) {
        Map<String, String> defects = new ConcurrentSkipListMap<>();
        AtomicInteger drawn = new AtomicInteger();
        IntStream.range(0, texts.size()).parallel().forEach(i ->
            read(texts.get(i)).ifPresent(scene -> {
                drawn.incrementAndGet();
                NastyDrawing.defect(scene, WAYS.get(i % WAYS.size()))
                    .ifPresent(defect -> defects.put(texts.get(i), defect));
            }));
        assertEquals(Map.of(), defects);
        assertTrue(drawn.get() >= leastDrawn, "the parser refused more than it should: drew " + drawn);
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "cam 0 0 -5 0 0 0 0 1 0 1 1.5,                          .sssssssss++,   13000",
        "cam 0 0 0 0 0 1 0 1 0 1 1.5 true 0.5,                  ..........++.k, 340",
        "cam 0.1 0.2 -5 0.3 0.4 0.2 0 1 0 1 1.5 true -0.5,      .s.s..s...++.k, 2300",
        "set 0.2 0.3 0.4 2 2 1,                                 .000..0,        640",
        "mtl 0.5 0.4 0.3 0.3 0.2 0.1 0.2 0.3 0.4 10 0.25,       .00000000001,   5000",
        "sph -0.5 0.1 0.3 0.7 1,                                .sss+.,         1600",
        "pln 0.1 1 0.2 -1 2,                                    .ssss.,         2200",
        "box 0.6 0.1 0.2 0.8 1,                                 .sss+.,         1600",
        "trg -0.9 -0.6 0.4 0.8 -0.5 -0.8 0.2 0.9 0.1 1,         .sssssssss.,   13000",
        "lgt 2 3 -4 1 0.9 0.8 0.8 0.9 0.5,                      .sss000010,     4600",
    })
    void everyPixelOfEveryLegalSceneIsLight(String line, String kinds, int leastDrawn) {
        assertLight(RangeEnds.scenes(line, kinds), leastDrawn);
    }

    /** Alone, for an estimate of ambient light takes longer than a small picture. */
    @Test
    void everyPixelIsLightWhateverTheAmbientColours() {
        assertLight(RangeEnds.scenes("mtl 0.5 0.4 0.3 0 0 0 0 0 0 1 0 0.3 0.3 0.4", ".0...........00"), 300);
    }

    /** A lamp whose square reaches beyond all doubles, in a scene that also has a length too small to scale it down. */
    @Test
    void aLampMayReachBeyondAllDoubles() {
        assertLight(List.of("cam 0 0 0  0 0 1  0 1 0  1 1\nset 0 0 0  2 3\nmtl 0 0 0  0 0 0  0 0 0  0 0\n"
            + "mtl 0 0 1  0 0 0  0 0 0  1 0\nsph 0 1 0  1 1\nsph 0 0 1e-300  1.7e308 2\n"
            + "lgt 2 3 1.7e308  1 0 0  0 1 1.7e308"), 1);
    }

    /** From a ball whose distance is just above the largest double, a lamp is as far away. */
    @Test
    void aLampMayBeFurtherAwayThanAnyDouble() {
        assertLight(List.of("cam 0 0 0  1e160 1e160 0  0 0 1  1 1\nset 0 0 0  2 3\nmtl 0 0 0  0 0 1  0 0 0  0 0\n"
            + "sph 1.7e308 1.7e308 1e-300  1 1\nlgt 0 3 0  0 0 0  1 0 0"), 1);
    }

    private static Film film(String... lines) {
        return Renderers.film(SceneText.scene(lines), ODD);
    }

    private static String[] ahead(String camera, double unit) {
        String u = " " + unit;
        return new String[] {camera, "set 0.25 0.5 0.75 1 2", "mtl 0.5 0.25 0.75  0.5 0.5 0.5  0.25 0.25 0.25  2 0.5",
            "sph 0 0" + product(4, unit) + u + " 1", "box" + product(0.5, unit) + u + product(3, unit) + u + " 1",
            "pln 0 1 0" + product(-1.5, unit) + " 1",
            "lgt" + product(3, unit) + product(4, unit) + product(-1, unit) + " 1 0.5 0.25  1 0.75 0"};
    }

    private static String product(double a, double b) {
        return " " + a * b;
    }

    private static void assertLike(Film expected, Film found, double tolerance) {
        Color first = expected.get(0, 0);
        boolean isEven = true;
        for (int i = 0; i < 25; i++) {
            Color wanted = expected.get(i % 5, i / 5);
            Color got = found.get(i % 5, i / 5);
            assertEquals(wanted.red(), got.red(), tolerance, "pixel " + i);
            assertEquals(wanted.green(), got.green(), tolerance, "pixel " + i);
            assertEquals(wanted.blue(), got.blue(), tolerance, "pixel " + i);
            isEven &= wanted.equals(first);
        }
        assertTrue(!isEven, "an even picture proves nothing");
    }

    /** All lengths are multiples of 1/2, and so doubles even where only four bits of a double are left. */
    @ParameterizedTest(name = "2^{0}")
    @ValueSource(ints = {-1071, -1022, -700, 700, 1020})
    void aPowerOfTwoTimesAllLengthsIsTheSamePictureBitForBit(int exponent) {
        double unit = Math.scalb(1.0, exponent);
        String camera = "cam 0 0 0  0 0" + product(4, unit) + "  0 1 0" + product(1, unit) + product(2, unit);
        assertLike(film(ahead("cam 0 0 0  0 0 4  0 1 0  1 2", 1)), film(ahead(camera, unit)), 0);
    }

    @ParameterizedTest(name = "{0}")
    @ValueSource(strings = {"0 0 1e300  0 1 0", "0 0 4.9e-324  0 1 0", "0 0 1  0 1e300 0", "0 0 1  0 4.9e-324 0",
        "0 0 1.7e308  0 1.7e308 -1.7e308"})
    void howFarTheViewAndUpReachIsNotSeen(String view) {
        assertLike(film(ahead("cam 0 0 0  0 0 1  0 1 0  1 2", 1)), film(ahead("cam 0 0 0  " + view + "  1 2", 1)),
            ROUNDING);
    }

    @ParameterizedTest(name = "{0}")
    @ValueSource(strings = {"1 2", "1e300 2e300", "1e-300 2e-300", "1e-310 2e-310", "8e307 1.6e308", "5e-324 1e-323"})
    void ofTheScreenOnlyTheShapeIsSeen(String screen) {
        assertLike(film(ahead("cam 0 0 0  0 0 1  0 1 0  1 2", 1)),
            film(ahead("cam 0 0 0  0 0 1  0 1 0  " + screen, 1)), ROUNDING);
    }

    /** Ahead is a black ball, and all around it the sky. */
    @ParameterizedTest(name = "{0}")
    @ValueSource(strings = {"1e-300 1e300", "4.9e-324 1.7e308", "2.2e-308 1.7e308", "1e-160 1e160", "1e-300 1"})
    void aScreenThatIsNothingButWideShowsInTheMiddleWhatIsAheadAndElsewhereWhatIsBeside(String screen) {
        Film film = film("cam 0 0 0  0 0 1  0 1 0  " + screen, "set 1 1 1  1 1", "mtl 0 0 0  0 0 0  0 0 0  1 0",
            "sph 0 0 3 1 1");
        for (int i = 0; i < 25; i++) {
            assertEquals(i == 12 ? Color.BLACK : Color.WHITE, film.get(i % 5, i / 5), "pixel " + i);
        }
    }

    @ParameterizedTest(name = "{0}")
    @ValueSource(strings = {"1e300 1e-300", "1.7e308 4.9e-324", "1 1e-300"})
    void aScreenThatIsNothingButFarShowsThePointAheadEverywhere(String screen) {
        Color ahead = film(ahead("cam 0 0 0  0.07 0.13 1  0 1 0  1 2", 1)).get(2, 2);
        Film film = film(ahead("cam 0 0 0  0.07 0.13 1  0 1 0  " + screen, 1));
        for (int i = 0; i < 25; i++) {
            Color color = film.get(i % 5, i / 5);
            assertEquals(ahead.red(), color.red(), ROUNDING, "pixel " + i);
            assertEquals(ahead.green(), color.green(), ROUNDING, "pixel " + i);
            assertEquals(ahead.blue(), color.blue(), ROUNDING, "pixel " + i);
        }
    }
}
