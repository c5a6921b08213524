package raytracing.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.color.Color;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.parallel.ForkJoin;
import raytracing.scene.Camera;
import raytracing.scene.Fisheye;
import raytracing.scene.Light;
import raytracing.scene.Material;
import raytracing.scene.Pinhole;
import raytracing.scene.Scene;
import raytracing.scene.Settings;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.Sphere;
import raytracing.surface.Triangle;

@Isolated("changes the locale")
class SceneParserTest {
    private static final String CAM = "cam 0 0 -5  0 0 0  0 1 0  1 2\n";
    private static final String SET = "set 0.1 0.2 0.3  4 10\n";
    private static final String MTL = "mtl 1 0.5 0  0.1 0.2 0.3  0 0.4 0  30 0.25\n";

    /** Two lines that every scene needs, then a material: a line under test comes out as line 4. */
    private static final String HEAD = CAM + SET + MTL;

    private static Scene parse(String text) throws RayTracerException {
        return SceneParser.parse("test.txt", text.getBytes(StandardCharsets.UTF_8), ForkJoin.sequential()).scene();
    }

    private static List<String> messages(String text) {
        return assertThrows(RayTracerException.class, () -> parse(text)).messages();
    }

    @Test
    void everyValueEndsUpInItsPlace() throws RayTracerException {
        Scene scene = parse("""
            cam  1 2 3   4 5 6   0 1 0   1.5 2.5  true 0.25
            set  0.1 0.2 0.3   5  7  0.5
            mtl  1 2 3   4 5 6   7 8 9   10  0.5   0.1 0.2 0.3
            sph  1 2 3   4  1
            pln  1 2 3   4  1
            box  1 2 3   4  1
            trg  1 2 3   4 5 6   7 8 -9  1
            lgt  1 2 3   4 5 6   7  0.5  9
            """);
        assertEquals(new Camera(new Vector(1, 2, 3), new Vector(4, 5, 6), new Vector(0, 1, 0), 1.5, 2.5,
            new Fisheye(0.25)), scene.camera());
        assertEquals(new Settings(new Color(0.1, 0.2, 0.3), 5, 7, 0.5), scene.settings());
        assertEquals(List.of(new Material(new Color(1, 2, 3), new Color(4, 5, 6), new Color(7, 8, 9), 10, 0.5,
            new Color(0.1, 0.2, 0.3))), scene.materials());
        assertEquals(List.of(new Sphere(new Vector(1, 2, 3), 4, 0), new Plane(new Vector(1, 2, 3), 4, 0),
            new Box(new Vector(1, 2, 3), 4, 0), new Triangle(1, 2, 3, 4, 5, 6, 7, 8, -9, 0)), scene.surfaces());
        assertEquals(List.of(new Light(new Vector(1, 2, 3), new Color(4, 5, 6), 7, 0.5, 9)), scene.lights());
    }

    @Test
    void optionalValuesHaveTheirDefaults() throws RayTracerException {
        Scene scene = parse(HEAD);
        assertEquals(new Pinhole(), scene.camera().lens());
        assertEquals(1, scene.settings().ambientScale());
        assertEquals(Color.BLACK, scene.materials().get(0).ambient());
    }

    @ParameterizedTest(name = "{0} {1}")
    @CsvSource({"true, 0.75, 0.75", "true, , 0.5", "TRUE, -1, -1"})
    void aFisheyeHasTheGivenKOrOneHalf(String flag, String k, double expected) throws RayTracerException {
        Scene scene = parse(CAM.strip() + " " + flag + (k == null ? "" : " " + k) + "\n" + SET);
        assertEquals(new Fisheye(expected), scene.camera().lens());
    }

    @Test
    void aFisheyeFlagOfFalseLeavesThePinholeWhateverK() throws RayTracerException {
        assertEquals(new Pinhole(), parse(CAM.strip() + " false 1\n" + SET).camera().lens());
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource(delimiter = '|', value = {
        "tabs and several blanks | sph\t0 \t 0   0\f1\u000b1",
        "blanks before the code  |    sph 0 0 0 1 1",
        "no-break space          | sph\u00a00\u20030 0 1 1",
        "upper case              | SPH 0 0 0 1 1",
        "mixed case              | sPh 0 0 0 1 1",
        "remark behind           | sph 0 0 0 1 1 # a ball",
        "remark without a blank  | sph 0 0 0 1 1 #a ball",
        "whole numbers as such   | sph 0 0 0 1.0 1.0",
        "signs and exponents     | sph +0 -0 0e0 1e+0 10E-1",
        "dots at either end      | sph .0 0. 0 1. 1",
        "leading zeros           | sph 00 0 0 01 1",
        "a mark in mid-file      | \ufeffsph 0 0 0 1 1",
    })
    void waysToWriteTheSameSphere(String why, String line) throws RayTracerException {
        assertEquals(List.of(new Sphere(Vector.ZERO, 1, 0)), normalised(parse(HEAD + line + "\n")), why);
    }

    private static List<Sphere> normalised(Scene scene) {
        return scene.surfaces().stream().map(surface -> (Sphere) surface)
            .map(sphere -> new Sphere(Vectors.plus(sphere.centre(), Vector.ZERO), sphere.radius(),
                sphere.material())).toList();
    }

    @ParameterizedTest
    @ValueSource(strings = {"\n", "\r\n", "\r"})
    void everyLineEndIsALineEnd(String lineEnd) throws RayTracerException {
        assertEquals(parse(HEAD), parse(HEAD.replace("\n", lineEnd)));
        List<String> messages = messages(HEAD.replace("\n", lineEnd) + lineEnd + "xyz");
        assertEquals("test.txt:5: xyz: unknown code, expected cam, set, mtl, sph, pln, box, trg or lgt", messages.get(0));
    }

    @Test
    void blankLinesAndRemarksAreSkipped() throws RayTracerException {
        assertEquals(parse(HEAD), parse("# title\n\n   \n" + CAM + "\t# note\n#\n" + SET + "##\n" + MTL + "  "));
    }

    @Test
    void theLastLineNeedsNoEnd() throws RayTracerException {
        assertEquals(parse(HEAD), parse(HEAD.strip()));
        assertEquals(parse(HEAD), parse(HEAD + "# the end"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"UTF-8", "UTF-16LE", "UTF-16BE"})
    void aByteOrderMarkIsNoPartOfTheFirstCode(String encoding) throws RayTracerException {
        byte[] marked = ("\ufeff" + HEAD).getBytes(Charset.forName(encoding));
        assertEquals(parse(HEAD), SceneParser.parse("test.txt", marked, ForkJoin.sequential()).scene());
    }

    @ParameterizedTest
    @ValueSource(strings = {"UTF-8", "UTF-16LE", "UTF-16BE"})
    void aByteOrderMarkAloneIsAnEmptyFile(String encoding) {
        byte[] mark = "\ufeff".getBytes(Charset.forName(encoding));
        assertEquals(messages(""),
            assertThrows(RayTracerException.class, () -> SceneParser.parse("test.txt", mark, ForkJoin.sequential())).messages());
    }

    /** Course files have remarks in several encodings of Hebrew. Every pair of bytes that is no line end must do. */
    @Test
    void aRemarkMayHoldAnyBytes() throws RayTracerException {
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        for (int first = 0; first < 256; first++) {
            for (int second = 0; second < 256; second++) {
                if (first != '\n' && first != '\r' && second != '\n' && second != '\r') {
                    text.write('#');
                    text.write(first);
                    text.write(second);
                    text.write('\n');
                }
            }
        }
        text.writeBytes(HEAD.getBytes(StandardCharsets.US_ASCII));
        assertEquals(parse(HEAD), SceneParser.parse("test.txt", text.toByteArray(), ForkJoin.sequential()).scene());
    }

    /** Bytes of which a wide space could be made, but is not: part of the word, and shown as the library replaces them. */
    @ParameterizedTest
    @ValueSource(strings = {"c0a0", "e080a0", "c2", "a0", "e280", "e3", "eda080", "f09f98", "ff"})
    void whatOnlyLooksLikeAWideSpaceIsNone(String hexadecimal) {
        assertIsOneWord(hexadecimal, "x\n");
        assertIsOneWord(hexadecimal, "");
    }

    private static void assertIsOneWord(String hexadecimal, String end) {
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        text.writeBytes((HEAD + "x").getBytes(StandardCharsets.UTF_8));
        text.writeBytes(HexFormat.of().parseHex(hexadecimal));
        text.writeBytes(end.getBytes(StandardCharsets.UTF_8));
        String word = text.toString(StandardCharsets.UTF_8).substring(HEAD.length()).strip();
        assertEquals(List.of("test.txt:4: " + word + ": unknown code (bytes that are not UTF-8), "
            + "expected cam, set, mtl, sph, pln, box, trg or lgt"),
            assertThrows(RayTracerException.class,
                () -> SceneParser.parse("test.txt", text.toByteArray(), ForkJoin.sequential())).messages());
    }

    @Test
    void aWideSpaceMayStandAtTheVeryEnd() throws RayTracerException {
        assertEquals(parse(HEAD), parse(HEAD + "\u3000"));
        assertEquals(parse(HEAD), parse(HEAD.strip() + "\u00a0"));
    }

    @Test
    void aLineMayHaveMoreValuesThanAnyFormAndIsToldHowMany() {
        assertEquals(List.of("test.txt:4: sph: expected 5 values (centre 3, radius, material), got 1000, "
            + "first surplus value 5"), messages(HEAD + "sph 0 1 2 3 4" + " 5".repeat(995) + "\n"));
    }

    /** The least double above 0 is above 0. */
    @Test
    void aRadiusMayBeAsSmallAsThereIs() throws RayTracerException {
        assertEquals(List.of(new Sphere(Vector.ZERO, Double.MIN_VALUE, 0)),
            parse(HEAD + "sph 0 0 0 4.9e-324 1\n").surfaces());
        assertEquals(List.of("test.txt:4: sph: radius must be above 0, got 1e-400"),
            messages(HEAD + "sph 0 0 0 1e-400 1\n"));
    }

    /** The last digit of a double decides, also where products of coordinates are no doubles any more. */
    @ParameterizedTest
    @ValueSource(strings = {"0 0 0 1 1 1 3 3 3.0000000000000004", "0 0 0 1e-300 1e-300 1e-300 3e-300 3e-300 3.000000000000001e-300",
        "-1e308 -1e308 -1e308 0 0 0 1e308 1e308 1.0000000000000002e308", "0 0 0 4.9e-324 0 0 0 4.9e-324 0"})
    void cornersBarelyBesideALineAreThoseOfATriangle(String corners) throws RayTracerException {
        assertEquals(1, parse(HEAD + "trg " + corners + " 1\n").surfaces().size());
    }

    @ParameterizedTest
    @ValueSource(strings = {"0.1 0.1 0.1 0.3 0.3 0.3 0.7 0.7 0.7", "0 0 0 1e-300 1e-300 1e-300 3e-300 3e-300 3e-300",
        "-1e308 -1e308 -1e308 0 0 0 1e308 1e308 1e308", "0 0 0 4.9e-324 0 0 1e-323 0 0", "1 2 3 1 2 3 1 2 3"})
    void cornersOnALineAreRefusedAtAnyScale(String corners) {
        List<String> messages = messages(HEAD + "trg " + corners + " 1\n");
        assertEquals(1, messages.size());
        assertTrue(messages.get(0).startsWith("test.txt:4: trg: corners must be three points that are not on one line, got "),
            messages.get(0));
    }

    /** What replaces a wrong number may be on a line with the rest; that would be no mistake of the author. */
    @Test
    void ofCornersWithAWrongNumberOnlyThatIsSaid() {
        assertEquals(List.of("test.txt:4: trg: second corner x must be a decimal number, got x"),
            messages(HEAD + "trg 0 0 0 x 1 1 2 2 2 1\n"));
    }

    @Test
    void linesMayStandInAnyOrder() throws RayTracerException {
        Scene scene = parse("sph 0 0 0 1 2\n" + MTL + SET + MTL + CAM);
        assertEquals(1, scene.surfaces().get(0).material());
        assertEquals(2, scene.materials().size());
    }

    @Test
    void numbersHaveADotWhateverTheLocale() throws RayTracerException {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.GERMANY);
            assertEquals(0.25, parse(HEAD).materials().get(0).transparency());
            Locale.setDefault(Locale.forLanguageTag("tr"));
            assertEquals(1, parse("MTL" + MTL.substring(3) + CAM + SET + "LGT 0 0 0 1 1 1 1 1 1").lights().size());
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void aSceneMayBeWithoutSurfacesLightsAndMaterials() throws RayTracerException {
        Scene scene = parse(CAM + SET);
        assertEquals(List.of(), scene.surfaces());
        assertEquals(List.of(), scene.lights());
    }

    @Test
    void coloursAboveOneAreFine() throws RayTracerException {
        assertEquals(1.1, parse(CAM + SET + MTL.replace("0.5", "1.1")).materials().get(0).diffuse().green());
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource(delimiter = '|', quoteCharacter = '"', value = {
        "sph 0 0 0 -1 1            | sph: radius must be above 0, got -1",
        "sph 0 0 0 0 1             | sph: radius must be above 0, got 0",
        "sph 0 0 0 1e-400 1        | sph: radius must be above 0, got 1e-400",
        "sph 0 0 0 1 2             | sph: material must be from 1 to 1, got 2",
        "sph 0 0 0 1 0             | sph: material must be a whole number from 1 on, got 0",
        "sph 0 0 0 1 1.5           | sph: material must be a whole number from 1 on, got 1.5",
        "sph 0 0 0 1 9e9           | sph: material must be a whole number from 1 on, got 9e9",
        "sph 0 0 x 1 1             | sph: centre z must be a decimal number, got x",
        "sph 0 0 NaN 1 1           | sph: centre z must be a decimal number, got NaN",
        "sph 0 0 Infinity 1 1      | sph: centre z must be a decimal number, got Infinity",
        "sph 0 0 -inf 1 1          | sph: centre z must be a decimal number, got -inf",
        "sph 0 0 0x1p3 1 1         | sph: centre z must be a decimal number, got 0x1p3",
        "sph 0 0 1d 1 1            | sph: centre z must be a decimal number, got 1d",
        "sph 0 0 1f 1 1            | sph: centre z must be a decimal number, got 1f",
        "sph 0 0 1e 1 1            | sph: centre z must be a decimal number, got 1e",
        "sph 0 0 . 1 1             | sph: centre z must be a decimal number, got .",
        "sph 0 0 - 1 1             | sph: centre z must be a decimal number, got -",
        "sph 0 0 1.2.3 1 1         | sph: centre z must be a decimal number, got 1.2.3",
        "sph 0 0 1,5 1 1           | sph: centre z must be a decimal number with a dot, not a comma, got 1,5",
        "sph 0 0 \u0665 1 1        | sph: centre z must be a decimal number, got \u0665 (U+0665 ARABIC-INDIC DIGIT FIVE, write 5)",
        "sph 0 0 1e999 1 1         | sph: centre z must be within what a double can hold, got 1e999",
        "sph 0 0 0 1               | sph: expected 5 values (centre 3, radius, material), got 4",
        "sph                       | sph: expected 5 values (centre 3, radius, material), got 0",
        "sph 0 0 0 1 1 7           | sph: expected 5 values (centre 3, radius, material), got 6, first surplus value 7",
        "sph 0 0 0 1 1;            | sph: material must be a decimal number, got 1; (values are separated by white space, not by semicolons)",
        "SPH 0 0 0 1 # 1           | SPH: expected 5 values (centre 3, radius, material), got 4",
        "pln 0 0 0 1 1             | pln: normal must be a direction, not zero, got 0.0 0.0 0.0",
        "pln 0 1 0 1 5             | pln: material must be from 1 to 1, got 5",
        "pln 0 1 0 1               | pln: expected 5 values (normal 3, offset, material), got 4",
        "box 0 0 0 0 1             | box: edge must be above 0, got 0",
        "box 0 0 0 1 3             | box: material must be from 1 to 1, got 3",
        "box 0 0 0 1 1 1           | box: expected 5 values (centre 3, edge, material), got 6, first surplus value 1",
        "trg 0 0 0 1 0 0 0 x 0 1   | trg: third corner y must be a decimal number, got x",
        "trg 0 0 0 1 0 0 0 1 0 0   | trg: material must be a whole number from 1 on, got 0",
        "trg 0 0 0 1 0 0 0 1 0 2   | trg: material must be from 1 to 1, got 2",
        "trg 0 0 0 1 0 0 2 0 0 1   | trg: corners must be three points that are not on one line, got 0.0 0.0 0.0, 1.0 0.0 0.0 and 2.0 0.0 0.0",
        "trg 1 2 3 1 2 3 4 5 7 1   | trg: corners must be three points that are not on one line, got 1.0 2.0 3.0, 1.0 2.0 3.0 and 4.0 5.0 7.0",
        "trg 1.111111 2.111111 3.111111 1.111111 2.111111 3.111111 4 5 7 1 | trg: corners must be three points that are not on one line, got 1.111111 2.111111 3.111111, 1.111111 2.111111 3.111111 and 4.0 5.0 7.0",
        "trg 0 0 0 1 1             | trg: expected 10 values (corners 3 + 3 + 3, material), got 5",
        "trg 0 0 0 1 0 0 0 1 0     | trg: expected 10 values (corners 3 + 3 + 3, material), got 9",
        "trg 0 0 0 1 0 0 0 1 0 1 1 | trg: expected 10 values (corners 3 + 3 + 3, material), got 11, first surplus value 1",
        "cyl 0 0 0 1 1             | cyl: cylinders are not supported, expected sph, pln, box or trg",
        "lgt 0 0 0 -1 1 1 1 1 1    | lgt: colour red must be at least 0, got -1",
        "lgt 0 0 0 1 1 -1e-9 1 1 1 | lgt: colour blue must be at least 0, got -1e-9",
        "lgt 0 0 0 1 1 1 -1 1 1    | lgt: specular intensity must be at least 0, got -1",
        "lgt 0 0 0 1 1 1 1 1.01 1  | lgt: shadow intensity must be from 0 to 1, got 1.01",
        "lgt 0 0 0 1 1 1 1 -0.01 1 | lgt: shadow intensity must be from 0 to 1, got -0.01",
        "lgt 0 0 0 1 1 1 1 1 -1    | lgt: width must be at least 0, got -1",
        "lgt 0 0 0 1 1 1 1 1       | lgt: expected 9 values (position 3, colour 3, specular intensity, shadow intensity, width), got 8",
        "mtl 1 1 1 0 0 -2 0 0 0 1 0 | mtl: specular blue must be at least 0, got -2",
        "mtl 1 1 1 0 0 0 0 0 0 -1 0 | mtl: Phong exponent must be at least 0, got -1",
        "mtl 1 1 1 0 0 0 0 0 0 1 2  | mtl: transparency must be from 0 to 1, got 2",
        "mtl 1 1 1 0 0 0 0 0 0 1 -1 | mtl: transparency must be from 0 to 1, got -1",
        "mtl 1 1 1 0 0 0 0 0 0 1 0 -1 0 0 | mtl: ambient red must be at least 0, got -1",
        "mtl 1 1 1 0 0 0 0 0 0 1 0 1 1 | mtl: expected 11 or 14 values (diffuse 3, specular 3, reflection 3, Phong exponent, transparency, [ambient 3]), got 13",
        "set 0 0 0 1 1             | set: one too many, the first is on line 2, expected exactly one",
        "cam 0 0 0 1 1 1 0 1 0 1 1 | cam: one too many, the first is on line 1, expected exactly one",
        "cam 0                     | cam: one too many, the first is on line 1, expected exactly one",
        "sphere 0 0 0 1 1          | sphere: unknown code, expected cam, set, mtl, sph, pln, box, trg or lgt, did you mean sph?",
        "= 1                       | =: unknown code, expected cam, set, mtl, sph, pln, box, trg or lgt",
    })
    void aWrongLineIsNamedWithItsCure(String line, String expected) {
        assertEquals(List.of("test.txt:4: " + expected), messages(HEAD + line + "\n"));
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource(delimiter = '|', value = {
        "cam 0 0 0 0 0 0 0 1 0 1 1           | look-at must be another point than the position, such as 0 0 1, got 0.0 0.0 0.0",
        "cam 1 2 3 1 2 3 0 1 0 1 1           | look-at must be another point than the position, such as 0 0 0, got 1.0 2.0 3.0",
        "cam 0 0 0 -0 0 0 0 1 0 1 1          | look-at must be another point than the position, such as 0 0 1, got -0.0 0.0 0.0",
        "cam 0 0 0 0 0 1 0 0 0 1 1           | up must be a direction, not zero, such as 0 1 0, got 0.0 0.0 0.0",
        "cam 0 0 0 0 0 1 0 0 5 1 1           | up must be at an angle to the view 0.0 0.0 1.0, such as 0 1 0, got 0.0 0.0 5.0",
        "cam 0 9 0 0 0 0 0 1 0 1 1           | up must be at an angle to the view 0.0 -1.0 0.0, such as 0 0 1, got 0.0 1.0 0.0",
        "cam 0 0 0 0 1 1 0 2 2 1 1           | up must be at an angle to the view 0.0 0.7071067811865475 0.7071067811865475, such as 1 0 0, got 0.0 2.0 2.0",
        "cam 0 0 0 0 0 1 0 0 -5 1 1          | up must be at an angle to the view 0.0 0.0 1.0, such as 0 1 0, got 0.0 0.0 -5.0",
        "cam 0 0 0 0 0 1 0 1e-15 1 1 1       | up must be at an angle to the view 0.0 0.0 1.0, such as 0 1 0, got 0.0 1.0E-15 1.0",
        "cam 0 0 0 0 0 1 0 1e-10 1 1 1       | up must be at an angle to the view 0.0 0.0 1.0, such as 0 1 0, got 0.0 1.0E-10 1.0",
        "cam 0 0 0 0 0 1 0 1 0 0 1           | screen distance must be above 0, got 0",
        "cam 0 0 0 0 0 1 0 1 0 -1 1          | screen distance must be above 0, got -1",
        "cam 0 0 0 0 0 1 0 1 0 1 0           | screen width must be above 0, got 0",
        "cam 0 0 0 0 0 1 0 1 0 1 1 true 1.5  | k must be from -1 to 1, got 1.5",
        "cam 0 0 0 0 0 1 0 1 0 1 1 true -1.5 | k must be from -1 to 1, got -1.5",
        "cam 0 0 0 0 0 1 0 1 0 1 1 false 2   | k must be from -1 to 1, got 2",
        "cam 0 0 0 0 0 1 0 1 0 1 1 yes       | fisheye must be true or false, got yes",
        "cam 0 0 0 0 0 1 0 1 0 1 1 1         | fisheye must be true or false, got 1",
    })
    void aWrongCameraIsNamedWithItsCure(String line, String expected) {
        assertEquals(List.of("test.txt:1: cam: " + expected), messages(line + "\n" + SET));
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource(delimiter = '|', value = {
        "set -1 0 0 1 1      | background red must be at least 0, got -1",
        "set 0 0 0 0 1       | shadow ray root must be a whole number from 1 to 1024, got 0",
        "set 0 0 0 1025 1    | shadow ray root must be a whole number from 1 to 1024, got 1025",
        "set 0 0 0 1.5 1     | shadow ray root must be a whole number from 1 to 1024, got 1.5",
        "set 0 0 0 1 -1      | maximum recursion must be a whole number from 0 to 1000, got -1",
        "set 0 0 0 1 1001    | maximum recursion must be a whole number from 0 to 1000, got 1001",
        "set 0 0 0 1 1 -0.5  | ambient scale must be at least 0, got -0.5",
        "set 0 0 0 1         | expected 5 or 6 values (background 3, shadow ray root, maximum recursion, [ambient scale]), got 4",
    })
    void wrongSettingsAreNamedWithTheirCure(String line, String expected) {
        assertEquals(List.of("test.txt:1: set: " + expected), messages(line + "\n" + CAM));
    }

    @ParameterizedTest
    @ValueSource(strings = {"set 0 0 0 1024 1000 0", "set 9 9 9 1 0"})
    void theEndsOfTheRangesAreAllowed(String line) throws RayTracerException {
        parse(line + "\n" + CAM.strip() + " true -1\n" + "mtl 0 0 0 0 0 0 0 0 0 0 1\n" + "lgt 0 0 0 0 0 0 0 0 0\n");
    }

    @Test
    void aMissingCameraAndMissingSettingsAreNamed() {
        assertEquals(List.of("test.txt: cam: missing, expected exactly one",
            "test.txt: set: missing, expected exactly one"), messages(""));
    }

    @Test
    void allErrorsOfALineAndOfAllLinesComeInOrder() {
        assertEquals(List.of(
            "test.txt:3: sph: material must be from 1 to 1, got 4",
            "test.txt:4: sph: centre x must be a decimal number, got a",
            "test.txt:4: sph: radius must be above 0, got -2",
            "test.txt:6: hello: unknown code, expected cam, set, mtl, sph, pln, box, trg or lgt",
            "test.txt: set: missing, expected exactly one"),
            messages(CAM + "\nsph 0 0 0 1 4\nsph a 0 0 -2 1\n" + MTL + "hello\n"));
    }

    @Test
    void aWrongMaterialStillCounts() {
        assertEquals(List.of("test.txt:3: mtl: diffuse red must be a decimal number, got red"),
            messages(CAM + SET + "mtl red 0 0 0 0 0 0 0 0 1 0\n" + MTL + "sph 0 0 0 1 2\n"));
        assertEquals(1, messages(CAM + SET + "mtl 1\n" + MTL + "sph 0 0 0 1 2\n").size());
    }

    @Test
    void aSurfaceWithoutAnyMaterialIsToldSo() {
        assertEquals(List.of("test.txt:3: sph: material must be that of a mtl line, and there is none, got 1"),
            messages(CAM + SET + "sph 0 0 0 1 1\n"));
    }

    /**
     * What stands in for a refused value must not be refused in its turn: neither a camera at 1 0 0 nor a material 1, nor
     * a normal that is zero but for it.
     */
    @ParameterizedTest
    @ValueSource(strings = {"cam x 0 0  1 0 0  0 1 0  1 1\n" + SET, CAM + SET + "sph 0 0 0 1 red\n",
        HEAD + "pln x 0 0 1 1\n"})
    void aMistakeIsReportedOnce(String text) {
        assertEquals(1, messages(text).size());
    }

    @Test
    void twentyErrorsAreListedAndTheRestCounted() {
        List<String> messages = messages(HEAD + String.join("\n", Collections.nCopies(33, "sph 0 0 0 0 1")));
        assertEquals(21, messages.size());
        assertEquals("test.txt:23: sph: radius must be above 0, got 0", messages.get(19));
        assertEquals("test.txt: and 13 more", messages.get(20));
    }

    /** That no line has a material is known at the end of the file only. */
    @Test
    void anErrorThatIsFoundLateTakesThePlaceOfItsLine() {
        List<String> messages = messages(HEAD + "sph 0 0 0 1 7\n" + "sph 0 0 0 0 1\n".repeat(30) + "box 0 0 0 1 7\n");
        assertEquals(21, messages.size());
        assertEquals("test.txt:4: sph: material must be from 1 to 1, got 7", messages.get(0));
        assertEquals("test.txt:23: sph: radius must be above 0, got 0", messages.get(19));
        assertEquals("test.txt: and 12 more", messages.get(20));
    }

    @Test
    void nothingIsCountedBehindTwentyErrors() {
        List<String> messages = messages(HEAD + String.join("\n", Collections.nCopies(20, "sph 0 0 0 0 1")));
        assertEquals(20, messages.size());
        assertEquals("test.txt:23: sph: radius must be above 0, got 0", messages.get(19));
    }

    @ParameterizedTest
    @CsvSource({"40, ''", "41, ..."})
    void fortyCharactersAreQuotedAndDotsStandForMore(int length, String dots) {
        assertEquals(List.of("test.txt:4: " + "x".repeat(40) + dots
            + ": unknown code, expected cam, set, mtl, sph, pln, box, trg or lgt"), messages(HEAD + "x".repeat(length) + "\n"));
    }

    @Test
    void whatIsQuotedFromTheFileIsShortAndSafeToPrint() {
        assertEquals("test.txt:4: <U+001B>[31m: unknown code (U+001B ESCAPE, leave it out), expected cam, set, mtl, sph, pln, box, trg or lgt",
            messages(HEAD + "\u001b[31m\n").get(0));
        String message = messages(HEAD + "sph 0 0 " + "7x".repeat(10_000) + " 1 1\n").get(0);
        assertTrue(message.length() < 120, message);
    }

    @Test
    void aMissingFileAndAFolderAreTheUsersMistakes(@TempDir Path folder) {
        Path missing = folder.resolve("none.txt");
        assertEquals(missing + ": no such file, expected a scene file",
            assertThrows(RayTracerException.class, () -> SceneParser.parseFile(missing, ForkJoin.sequential())).getMessage());
        assertEquals(folder + ": is a folder, expected a scene file",
            assertThrows(RayTracerException.class, () -> SceneParser.parseFile(folder, ForkJoin.sequential())).getMessage());
    }

    /** Files of more than 64 kB are read in pieces: every line must be there, once and in its place. */
    @Test
    void aLargeFileIsTheSameSceneAsItsText(@TempDir Path folder) throws Exception {
        StringBuilder text = new StringBuilder(HEAD);
        for (int i = 0; i < 20_000; i++) {
            text.append("sph ").append(i).append(" 0 0 1 1\n");
        }
        Path file = folder.resolve("large.txt");
        Files.writeString(file, text);
        Scene scene = SceneParser.parseFile(file, ForkJoin.sequential()).scene();
        assertEquals(20_000, scene.surfaces().size());
        for (int i = 0; i < 20_000; i++) {
            assertEquals(new Sphere(new Vector(i, 0, 0), 1, 0), scene.surfaces().get(i));
        }
    }

    @Test
    void aFileIsNamedInItsMessagesAsTheUserNamedIt(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("pool.txt");
        Files.writeString(file, HEAD + "sph 0 0 0 -1 1\n");
        assertEquals(file + ":4: sph: radius must be above 0, got -1",
            assertThrows(RayTracerException.class, () -> SceneParser.parseFile(file, ForkJoin.sequential())).getMessage());
    }
}
