package raytracing.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.parallel.ForkJoin;

class SceneWarningsTest {
    private static final String CAM = "cam 0 0 -5  0 0 0  0 1 0  1 2\n";
    private static final String SET = "set 0.1 0.2 0.3  4 10\n";
    private static final String MTL = "mtl 1 1 1  0 0 0  0 0 0  30 0\n";
    private static final String SPH = "sph 0 0 0  1  1\n";
    private static final String LGT = "lgt 9 9 -9  1 1 1  1 1 1\n";
    private static final String NO_LIGHT =
        "warning: no lgt: without a light, surfaces show only what they mirror or let through";
    private static final String NO_SURFACE = "warning: no sph, pln, box or trg: the picture shows nothing but the background";
    private static final String INSIDE = "the camera is inside, the material is opaque, and no lgt is inside";

    private static List<String> warnings(String... lines) {
        try {
            return SceneParser.parse("a.txt", String.join("", lines).getBytes(StandardCharsets.UTF_8),
                ForkJoin.sequential()).warnings();
        } catch (RayTracerException wrong) {
            throw new AssertionError(wrong.getMessage(), wrong);
        }
    }

    @Test
    void whatCanBeMeantIsNotWarnedOf() {
        assertEquals(List.of(), warnings(CAM, SET, MTL, SPH, LGT));
    }

    /** In 107 of 110 public files, the sixth value means what {@code --samples} does. */
    @ParameterizedTest
    @CsvSource({"4, 4", "2, 2", "32, 32", "3.0, 3", "4e0, 4"})
    void aSixthValueThatDoesNothingGetsBothItsMeanings(String value, String samples) {
        assertEquals(List.of("a.txt:2: warning: set: the sixth value, " + samples + ", scales the ambient light here and "
            + "changes nothing, for no material has an ambient colour; for \"supersample " + samples + " x " + samples
            + "\", as other programs read it, use --samples " + samples),
            warnings(CAM, SET.strip() + " " + value + "\n", MTL, SPH, LGT));
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "0.5, 0.5", "33, 33.0", "1e30, 1.0E30"})
    void aSixthValueThatIsNoNumberOfSamplesGetsOne(String value, String shown) {
        assertEquals(List.of("a.txt:2: warning: set: the sixth value, " + shown + ", scales the ambient light here and "
            + "changes nothing, for no material has an ambient colour"),
            warnings(CAM, SET.strip() + " " + value + "\n", MTL, SPH, LGT));
    }

    @Test
    void aSixthValueThatMeansSomethingOrSaysTheDefaultIsFine() {
        assertEquals(List.of(), warnings(CAM, SET.strip() + " 1\n", MTL, SPH, LGT));
        assertEquals(List.of(), warnings(CAM, SET.strip() + " 4\n", MTL.strip() + " 0 0 0.1\n", SPH, LGT));
    }

    @Test
    void aSceneWithoutSurfacesOrWithoutLights() {
        assertEquals(List.of("a.txt: " + NO_LIGHT), warnings(CAM, SET, MTL, SPH));
        assertEquals(List.of("a.txt: " + NO_SURFACE), warnings(CAM, SET, MTL, LGT));
        assertEquals(List.of("a.txt: " + NO_SURFACE, "a.txt: " + NO_LIGHT), warnings(CAM, SET));
    }

    /** What glows in the light of the sky needs no lamp. */
    @Test
    void aSceneInAmbientLightNeedsNoLights() {
        String ambient = MTL.strip() + " 1 1 1\n";
        assertEquals(List.of(), warnings(CAM, SET, ambient, SPH));
        assertEquals(List.of("a.txt: " + NO_LIGHT), warnings(CAM, "set 0 0 0 1 1\n", ambient, SPH));
        assertEquals(List.of("a.txt: " + NO_LIGHT), warnings(CAM, SET.strip() + " 0\n", ambient, SPH));
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource(delimiter = '|', value = {
        "mtl 255 0 9 0 0 0 0 0 0 1 0         | mtl: diffuse is 255 0 9",
        "mtl 0 0 0 0 0 20 0 0 0 1 0          | mtl: specular is 0 0 20",
        "MTL 0 0 0 0 0 0 0 128.0 0 1 0       | MTL: reflection is 0 128.0 0",
        "mtl 0 0 0 0 0 0 0 0 0 1 0 1e2 0 0   | mtl: ambient is 1e2 0 0",
        "mtl 255 0 0 99 99 99 255 0 0 1 0    | mtl: diffuse is 255 0 0",
        "lgt 0 0 9 255 255 255 1 1 1         | lgt: colour is 255 255 255",
    })
    void aColourCountedInBytesIsNamedOnceForALine(String line, String expected) {
        assertEquals(List.of("a.txt:4: warning: " + expected + ", and 1 is full: 0 to 1, not 0 to 255?"),
            warnings(CAM, SET, MTL, line + "\n", SPH, "sph 5 5 5 1 " + (line.startsWith("lgt") ? 1 : 2) + "\n", LGT));
    }

    @Test
    void aBackgroundCountedInBytesIsNamed() {
        assertEquals(List.of(
            "a.txt:2: warning: set: background is 0 128 0, and 1 is full: 0 to 1, not 0 to 255?"),
            warnings(CAM, "set 0 128 0 1 1\n", MTL, SPH, LGT));
    }

    @ParameterizedTest
    @ValueSource(strings = {"mtl 19.9 2 1 0 0 0 0 0 0 100 0", "lgt 0 90 90 5 5 5 100 1 100"})
    void whatIsOnlyBrightMayBeMeant(String line) {
        assertEquals(List.of(), warnings(CAM, SET, line + "\n", line.startsWith("lgt") ? MTL : LGT, SPH));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "sph 0 0 -4 2 1          | sph",
        "box 0 0 -4 2.1 1        | box",
        "SPH -1000 0 0 1000.02 1 | SPH",
    })
    void anEyeInAnOpaqueBodyWithoutLightIsNamedWithItsLine(String body, String code) {
        assertEquals(List.of("a.txt:7: warning: " + code + ": " + INSIDE), warnings(CAM, "pln 0 1 0 -50 1\n\n", SET, LGT,
            "sph 99 0 0 1 1\n", body + "\n", "sph 0 0 -5 1 1\n", MTL));
    }

    @Test
    void theCameraMayComeAfterTheBodyThatItIsIn() {
        assertEquals(List.of("a.txt:3: warning: box: " + INSIDE),
            warnings("\nsph 9 9 9 1 1\n", "box 0 0 -5 2 1\n", "sph 0 0 -5 3 1\n", SET, MTL, LGT, CAM));
    }

    @ParameterizedTest
    @ValueSource(strings = {"sph 0 0 -4 1 1", "box 0 0 -4 2 1", "sph 0 0 0 1 1", "sph 0 0 -5 1 2", "box 0 0 -5 1 2",
        "sph 0 0 -5 3 1\nlgt 0 0 -6 1 1 1 1 1 1", "sph 0 0 -5 3 1\nlgt 0 0 -8 1 1 1 1 1 1",
        "box 0 0 -5 3 1\nlgt 1.5 1.5 -6.5 1 1 1 1 1 1"})
    void anEyeOutsideOrOnOrInGlassOrWithALightIsFine(String body) {
        assertEquals(List.of(), warnings(CAM, SET, MTL, MTL.replace("30 0", "30 0.1"), LGT, body, "\nsph 50 0 0 1 1\n",
            "sph 50 0 0 1 2\n"));
    }

    @Test
    void materialsThatNothingUsesAreNamedInOneLine() {
        assertEquals(List.of("a.txt: warning: no surface uses material 2"), warnings(CAM, SET, MTL, MTL, SPH, LGT));
        assertEquals(List.of("a.txt: warning: no surface uses materials 1, 3, 4"),
            warnings(CAM, SET, MTL, MTL, MTL, MTL, SPH.replace("1\n", "2\n"), LGT));
        assertEquals(List.of("a.txt: warning: no surface uses materials 1, 3"),
            warnings(CAM, SET, SPH.replace("1\n", "2\n"), MTL, MTL, MTL, LGT));
        assertEquals(List.of("a.txt: warning: no surface uses materials 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 and 89 more"),
            warnings(CAM, SET, MTL.repeat(100), SPH, LGT));
    }

    @Test
    void tenWarningsAreListedInTheOrderOfTheLinesAndTheRestCounted() {
        List<String> warnings = warnings(CAM, "mtl 255 0 0 0 0 0 0 0 0 1 0\n".repeat(12), SET.strip() + " 4\n", SPH);
        List<String> expected = new ArrayList<>(IntStream.range(2, 12).mapToObj(line -> "a.txt:" + line
            + ": warning: mtl: diffuse is 255 0 0, and 1 is full: 0 to 1, not 0 to 255?").toList());
        expected.add("a.txt: and 5 more");
        assertEquals(expected, warnings);
    }

    @Test
    void whatIsQuotedInAWarningCanBeSeen() throws RayTracerException {
        assertEquals(List.of("a<U+202E>.txt: " + NO_SURFACE, "a<U+202E>.txt: " + NO_LIGHT),
            SceneParser.parse("a\u202e.txt", (CAM + SET).getBytes(StandardCharsets.UTF_8), ForkJoin.sequential()).warnings());
    }
}
