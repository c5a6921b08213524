package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.render.RenderSettings;
import raytracing.shadow.ShadowMethod;

/**
 * Where two surfaces coincide, the one that stands first in the scene is seen, in every pixel, and has all its light. All
 * of them coincide exactly, as their numbers are written.
 */
class CoincidentSurfacesTest {
    private static final int SIZE = 61;
    private static final double ROUNDING = 1e-12;
    private static final RenderSettings SETTINGS = RenderSettings.DEFAULT.withSize(SIZE, SIZE);

    /** Materials 1 and 2 are the surfaces in question, 3 is all others, 4 is glass, 5 a mirror. */
    private static final List<String> MATERIALS = List.of("mtl 1 0 0  0 0 0  0 0 0  1 0", "mtl 0 1 0  0 0 0  0 0 0  1 0",
        "mtl 0 0 1  0 0 0  0 0 0  1 0", "mtl 0 0 0  0 0 0  0 0 0  1 0.5", "mtl 0 0 0  0 0 0  1 1 1  1 0");
    private static final String RED = " 1";
    private static final String GREEN = " 2";
    private static final String OTHER = " 3";
    private static final String GLASS = " 4";
    private static final String MIRROR = " 5";
    private static final double NEARLY = 1 - 1e-9;

    static Stream<Coincidence> coincidences() {
        Stream<Coincidence> tops = Stream.of(1.0, 3.0, 5.0, 7.0, 10.0, 0.1, -7.0).map(k -> Coincidence.above("box 0 0 0 2",
            "box 0 -1e-9 0 2", "pln 0 " + k + " 0 " + k, "pln 0 " + k + " 0 " + k * NEARLY));
        return Stream.of(tops, planes(), boxes(), spheres(), walls()).flatMap(kind -> kind)
            .flatMap(pair -> Stream.of(pair, pair.swapped()));
    }

    private static Stream<Coincidence> planes() {
        return Stream.of(
            Coincidence.above("pln 0 1 0 0", "pln 0 1 0 -1e-9", "pln 0 -7 0 0", "pln 0 -7 0 7e-9"),
            Coincidence.above("pln 0 3 0 3", "pln 0 3 0 2.999999997", "pln 0 10 0 10", "pln 0 10 0 9.99999999"),
            Coincidence.above("pln 3 4 0 5", "pln 3 4 0 4.999999995", "pln 6 8 0 10", "pln 6 8 0 9.99999999"),
            Coincidence.above("pln 3 4 0 5", "pln 3 4 0 4.999999995", "pln 0.75 1 0 1.25", "pln 0.75 1 0 1.249999998"),
            Coincidence.above("pln 3 4 0 5", "pln 3 4 0 4.999999995", "pln -9 -12 0 -15", "pln -9 -12 0 -14.99999998"),
            Coincidence.above("pln 1 7 -2 3", "pln 1 7 -2 2.999999995", "pln 3 21 -6 9", "pln 3 21 -6 8.99999998"));
    }

    private static Stream<Coincidence> boxes() {
        return Stream.of(
            Coincidence.above("box 0 0 0 2", "box 0 -1e-9 0 2", "box 0.5 0.5 0.25 1", "box 0.5 0.499999999 0.25 1"),
            Coincidence.above("box 0 0 0 2", "box 0 -1e-9 0 2", "box 0.25 -0.5 -0.125 3", "box 0.25 -0.500000001 -0.125 3"),
            Coincidence.above("box 0 0 0 2", "box 0 -1e-9 0 2", "box 0 0 0 2", "box 0 -1e-9 0 2"));
    }

    private static Stream<Coincidence> spheres() {
        return Stream.of(
            Coincidence.above("sph 0 0 0 1", "sph 0 0 0 0.999999999", "sph 0 0 0 1", "sph 0 0 0 0.999999999"),
            Coincidence.above("sph 0.1 0.2 0.3 0.7", "sph 0.1 0.2 0.3 0.699999999", "sph 0.1 0.2 0.3 0.7",
                "sph 0.1 0.2 0.3 0.699999999"));
    }

    private static Stream<Coincidence> walls() {
        return Stream.of(
            Coincidence.inFront("box 0 1 5 2", "box 0 1 5.000000001 2", "pln 0 0 -5 -20", "pln 0 0 -5 -20.000000005"),
            Coincidence.inFront("box 0 1 5 2", "box 0 1 5.000000001 2", "pln 0 0 3 12", "pln 0 0 3 12.000000003"),
            Coincidence.inFront("box 0 1 5 2", "box 0 1 5.000000001 2", "box 0.25 0.5 4.25 0.5",
                "box 0.25 0.5 4.250000001 0.5"));
    }

    @ParameterizedTest
    @MethodSource("coincidences")
    void theFirstOfTwoIsSeenInEveryPixel(Coincidence pair) {
        for (String camera : pair.side().eyes()) {
            assertFirstIsSeen(pair, camera, List.of());
        }
    }

    @ParameterizedTest
    @MethodSource("coincidences")
    void theFirstOfTwoIsSeenThroughGlass(Coincidence pair) {
        for (int i = 0; i < pair.side().eyes().size(); i++) {
            assertFirstIsSeen(pair, pair.side().eyes().get(i), List.of(pair.side().panes().get(i) + GLASS));
        }
    }

    @ParameterizedTest
    @MethodSource("coincidences")
    void theFirstOfTwoIsSeenInAMirror(Coincidence pair) {
        assertFirstIsSeen(pair, pair.side().mirrored(), List.of(pair.side().mirror() + MIRROR));
    }

    /** More bodies of a kind than are tested without a hierarchy, far away. */
    @ParameterizedTest
    @MethodSource("coincidences")
    void theFirstOfTwoIsSeenInACrowd(Coincidence pair) {
        List<String> crowd = new ArrayList<>();
        for (int i = 0; i < 60; i++) {
            crowd.add("box " + (3.0 * i - 90) + " -40 " + (i % 7) * 3 + " 1.5" + OTHER);
            crowd.add("sph " + (3.0 * i - 90) + " -50 " + (i % 5) * 3 + " 1" + OTHER);
        }
        for (String camera : pair.side().eyes()) {
            assertFirstIsSeen(pair, camera, crowd);
        }
    }

    private static void assertFirstIsSeen(Coincidence pair, String camera, List<String> others) {
        String expected = seen(camera, pair, pair.first() + RED, pair.secondBehind() + GREEN, others);
        String found = seen(camera, pair, pair.first() + RED, pair.second() + GREEN, others);
        assertTrue(expected.contains("R"), "the first is not in the picture of " + camera);
        assertEquals(0, differences(expected, found), "pixels wrong for " + camera + ", " + pair);
    }

    private static long differences(String expected, String found) {
        return IntStream.range(0, SIZE * SIZE).filter(i -> found.charAt(i) != expected.charAt(i)).count();
    }

    /** A letter for each pixel; lamps that cast no shadows light whatever is seen. */
    private static String seen(String camera, Coincidence pair, String first, String second, List<String> others) {
        List<String> lines = new ArrayList<>(List.of(camera, "set 0 0 0  1 1", first, second));
        lines.addAll(others);
        pair.side().lamps().forEach(place -> lines.add("lgt " + place + "  1 1 1  1 0 0"));
        return letters(picture(SETTINGS, lines));
    }

    private static String letters(Film film) {
        StringBuilder letters = new StringBuilder();
        for (int i = 0; i < SIZE * SIZE; i++) {
            letters.append(letter(film.get(i % SIZE, i / SIZE)));
        }
        return letters.toString();
    }

    private static char letter(Color color) {
        return color.red() > 0 ? 'R' : color.green() > 0 ? 'G' : color.blue() > 0 ? 'B' : '-';
    }

    private static Film picture(RenderSettings settings, List<String> lines) {
        List<String> all = new ArrayList<>(MATERIALS);
        all.addAll(lines);
        return Steps.renderScene(SceneText.scene(all.toArray(String[]::new)), settings);
    }

    /** A surface that is nearer by the last bit of a number is seen, whatever the order in the scene. */
    static Stream<Coincidence> nearerByABit() {
        String above1 = "pln 0 1 0 1.0000000000000002";
        String below1 = "pln 0 1 0 0.9999999999999999";
        return Stream.of(
            Coincidence.above(above1, "", "box 0 0 0 2", "box 0 -1e-9 0 2"),
            Coincidence.above("pln 0 7 0 7.000000000000001", "", "box 0 0 0 2", "box 0 -1e-9 0 2"),
            Coincidence.above("box 0 0 0 2", "", below1, "pln 0 1 0 0.999999999"),
            Coincidence.above("box 0 0 0 2", "", "pln 0 -3 0 -2.9999999999999996", "pln 0 -3 0 -2.999999997"),
            Coincidence.above("box 0 0 0 2.0000000000000004", "", "pln 0 3 0 3", "pln 0 3 0 2.999999997"),
            Coincidence.above("box 0 0 0 2.0000000000000004", "", "box 0 0 0 2", "box 0 -1e-9 0 2"),
            Coincidence.above(above1, "", "pln 0 -7 0 -7", "pln 0 -7 0 -6.999999993"),
            Coincidence.above("pln 3 4 0 5.000000000000001", "", "pln 6 8 0 10", "pln 6 8 0 9.99999999"),
            Coincidence.above("sph 0 0 0 1.0000000000000002", "", "sph 0 0 0 1", "sph 0 0 0 0.999999999"),
            Coincidence.above("sph 0.1 0.2 0.3 0.7", "", "sph 0.1 0.2 0.3 0.6999999999999998",
                "sph 0.1 0.2 0.3 0.699999999"));
    }

    @ParameterizedTest
    @MethodSource("nearerByABit")
    void theNearerOfTwoIsSeenEvenIfItIsNearerByTheLastBit(Coincidence pair) {
        for (String camera : pair.side().eyes()) {
            assertFirstIsSeen(pair, camera, List.of());
            String expected = seen(camera, pair, pair.secondBehind() + GREEN, pair.first() + RED, List.of());
            String found = seen(camera, pair, pair.second() + GREEN, pair.first() + RED, List.of());
            assertEquals(0, differences(expected, found), "pixels of the farther, the first in the scene, for " + camera);
        }
    }

    /** From straight above, only the ray in the middle meets both in one point; everywhere else the outer is in front. */
    @ParameterizedTest
    @CsvSource({"sph 0 0 0 1, pln 0 1 0 1", "sph 0 0 0 1, pln 0 -7 0 -7", "sph 0 0 0 2, pln 0 3 0 6",
        "sph 0 0 0 1, box 0 0 0 2", "sph 0 1 0 1, sph 0 0 0 2", "sph 0 1.5 0 0.5, box 0 1 0 2"})
    void whereABallTouchesFromInsideTheFirstIsSeen(String ball, String outer) {
        List<String> above = List.of("cam 0 4 0  0 1 0  0 0 1  1 0.5", "set 0 0 0  1 1", "lgt 0 4 0  1 1 1  1 0 0");
        String ballFirst = letters(picture(SETTINGS, with(above, ball + RED, outer + GREEN)));
        String outerFirst = letters(picture(SETTINGS, with(above, outer + GREEN, ball + RED)));
        int middle = SIZE * SIZE / 2;
        assertEquals("G".repeat(middle) + "R" + "G".repeat(middle), ballFirst);
        assertEquals("G".repeat(SIZE * SIZE), outerFirst);
    }

    private static List<String> with(List<String> lines, String... more) {
        return Stream.concat(lines.stream(), Stream.of(more)).toList();
    }

    /** The rays of the middle column touch both in that edge alone. */
    @ParameterizedTest
    @CsvSource({"box 0 0 0 2, box 2 2 0 2", "box 2 2 0 2, box 0 0 0 2", "box 0.5 0.5 0 1, box 2 2 0 2",
        "box 2 2 0 2, box 0.5 0.5 0 1"})
    void ofTwoBoxesWithACommonEdgeTheFirstIsSeenInIt(String first, String second) {
        Film film = picture(SETTINGS, List.of("cam -1 3 0  1 1 0  0 0 1  1 0.25", "set 0 0 0  1 1", first + RED,
            second + GREEN,
            "lgt -1 3 0  1 1 1  1 0 0"));
        List<Character> found = IntStream.range(0, SIZE).mapToObj(y -> letter(film.get(SIZE / 2, y))).distinct().toList();
        assertEquals(List.of('R'), found);
    }

    /** The scene and the count of the report of the fault. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 3, 5, 7, 10, 0.1})
    void theTopOfABoxHasAllItsPixelsBeforeAPlane(double k) {
        int size = 240;
        Film film = Steps.renderScene(SceneText.scene("cam 2.2 2.6 -4  0 0.3 0  0 1 0  1 1", "set 0.1 0.1 0.2  1 4",
            "mtl 0.9 0.2 0.2  0 0 0  0 0 0  10 0", "mtl 0.7 0.7 0.6  0 0 0  0 0 0  1 0", "box 0 0 0 2 1",
            "pln 0 " + k + " 0 " + k + " 2", "lgt 3 5 -4  0.8 0.8 0.8  1 1 0"), RenderSettings.DEFAULT.withSize(size, size));
        long red = IntStream.range(0, size * size).mapToObj(i -> film.get(i % size, i / size))
            .filter(color -> color.red() > 2 * color.green()).count();
        assertEquals(3581, red);
    }

    @Test
    void noPixelOfAFloorShowsTheSecondFloorInIt() {
        Film film = picture(SETTINGS, List.of("cam 2.2 2.6 -4  0 0.3 0  0 1 0  1 1", "set 0 0 0  1 4", "pln 0 1 0 0" + RED,
            "pln 0 -7 0 0" + GREEN, "lgt 3 5 -4  1 1 1  1 1 0"));
        String letters = letters(film);
        assertEquals(0, letters.chars().filter(letter -> letter == 'G').count());
        assertTrue(letters.chars().filter(letter -> letter == 'R').count() > SIZE * SIZE / 2, "too dark to mean anything");
    }

    static Stream<ShadowMethod> methods() {
        return Stream.of(ShadowMethod.Sampled.withRoot(1), ShadowMethod.Sampled.withRoot(3), new ShadowMethod.Exact());
    }

    /** The second is opaque or transparent, and lies in the first or a billionth behind it: that changes no light. */
    @ParameterizedTest
    @MethodSource("methods")
    void aSurfaceInTheFirstTakesNoLightFromIt(ShadowMethod method) {
        List<String> wrong = new ArrayList<>();
        for (Coincidence pair : coincidences().toList()) {
            for (String material : List.of(GREEN, GLASS)) {
                String camera = pair.side().eyes().get(0);
                Film expected = lit(method, camera, pair.first() + RED, pair.secondBehind() + material);
                Film found = lit(method, camera, pair.first() + RED, pair.second() + material);
                long count = redPixels(expected).filter(i -> !isSame(at(found, i), at(expected, i))).count();
                if (count > 0) {
                    wrong.add("\n" + count + " of " + pair + material);
                }
            }
        }
        assertEquals(List.of(), wrong, "pixels of the first that change by the second in it");
    }

    /** Half of the light comes from the first, half from what is behind it: the second, at no distance, and as bright. */
    @ParameterizedTest
    @CsvSource({"pln 0 1 0 1, pln 0 -7 0 -7", "pln 3 4 0 5, pln 6 8 0 10", "pln 1 7 -2 3, pln 3 21 -6 9",
        "box 0 0 0 2, box 0 0 0 2", "sph 0.1 0.2 0.3 0.7, sph 0.1 0.2 0.3 0.7"})
    void throughATransparentSurfaceTheOneInTheSamePlaceIsSeen(String first, String second) {
        for (String camera : Coincidence.Side.ABOVE.eyes()) {
            ShadowMethod hard = ShadowMethod.Sampled.withRoot(1);
            Film redAlone = lit(hard, camera, first + RED);
            Film greenAlone = lit(hard, camera, second + GREEN);
            Film both = lit(hard, camera, "mtl 1 0 0  0 0 0  0 0 0  1 0.5", first + " 6", second + GREEN);
            long wrong = IntStream.range(0, SIZE * SIZE).filter(i -> !isMean(at(both, i), at(redAlone, i), at(greenAlone, i)))
                .count();
            assertEquals(0, wrong, "pixels that are not the mean of both, for " + camera);
        }
    }

    /** Exact shadows add up areas of the shadow of each surface, and so may round. */
    private static boolean isSame(Color found, Color expected) {
        return Math.abs(found.red() - expected.red()) <= ROUNDING && Math.abs(found.green() - expected.green()) <= ROUNDING
            && Math.abs(found.blue() - expected.blue()) <= ROUNDING;
    }

    private static boolean isMean(Color mean, Color red, Color green) {
        return Math.abs(mean.red() - red.red() / 2) <= ROUNDING && Math.abs(mean.green() - green.green() / 2) <= ROUNDING;
    }

    private static Film lit(ShadowMethod method, String camera, String... lines) {
        List<String> all = new ArrayList<>(List.of(camera, "set 0 0 0  1 1", "lgt 3 9 -6  1 1 1  1 1 0.5",
            "lgt -0.5 4.75 1  0.5 0.5 0.5  1 1 0"));
        all.addAll(List.of(lines));
        return picture(SETTINGS.withShadowMethod(method), all);
    }

    private static IntStream redPixels(Film film) {
        return IntStream.range(0, SIZE * SIZE).filter(i -> letter(at(film, i)) == 'R');
    }

    private static Color at(Film film, int pixel) {
        return film.get(pixel % SIZE, pixel / SIZE);
    }
}
