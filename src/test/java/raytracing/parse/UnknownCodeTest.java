package raytracing.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class UnknownCodeTest {
    private static final String CODES = "expected cam, set, mtl, sph, pln, box, trg or lgt";

    @ParameterizedTest
    @CsvSource({"cub, box", "cube, box", "CUBE, box", "sphere, sph", "shpere, sph", "spr, sph", "ball, sph", "plane, pln",
        "plain, pln", "pnl, pln", "light, lgt", "lihgt, lgt", "ligth, lgt", "lgth, lgt", "camera, cam", "cma, cam",
        "material, mtl", "materail, mtl", "mat, mtl", "mlt, mtl", "settings, set", "sett, set", "bxo, box", "boxes, box",
        "tri, trg", "TRIANGLE, trg", "triangel, trg", "triangles, trg", "tgr, trg", "trgl, trg", "trg:, trg",
        "sph:, sph", "sph=1, sph", "sph1, sph", "sph-1, sph"})
    void aMisspeltCodeGetsTheNearest(String code, String meant) {
        assertEquals("unknown code, " + CODES + ", did you mean " + meant + "?", UnknownCode.message(code));
    }

    @ParameterizedTest
    @CsvSource({"cyl, cylinders", "cylinder, cylinders", "cilinder, cylinders", "elp, ellipsoids", "ellipsoid, ellipsoids",
        "cone, cones", "torus, tori", "disk, discs", "rect, rectangles", "polygon, polygons", "obj, models from other files"})
    void aShapeThatIsNotSupportedIsNamed(String code, String shapes) {
        assertEquals(shapes + " are not supported, expected sph, pln, box or trg", UnknownCode.message(code));
    }

    /** Also where a short name of a shape is near: "res" is no misspelt "rec". */
    @ParameterizedTest
    @ValueSource(strings = {"xyz", "hello", "=", "1", "res", "col", "tex", "fog", "s", "-1"})
    void whatIsNearToNothingGetsNoSuggestion(String code) {
        assertEquals("unknown code, " + CODES, UnknownCode.message(code));
    }

    @ParameterizedTest
    @ValueSource(strings = {"//", "//sph", "/*", "*/", ";", ";sph", "%", "%sph", "--", "---", "--sph", "<!--"})
    void aRemarkOfAnotherLanguageIsToldHowRemarksBegin(String code) {
        assertEquals("unknown code, remarks begin with #", UnknownCode.message(code));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "\uff53\uff50\uff48 | (U+FF53 FULLWIDTH LATIN SMALL LETTER S, write s)",
        "s\u0440h           | (U+0440 CYRILLIC SMALL LETTER ER)",
        "s\u200bph          | (U+200B ZERO WIDTH SPACE, leave it out)",
        "\u2212sph          | (U+2212 MINUS SIGN, write -)",
        "sph(0,0,0)         | (values are separated by white space, not by brackets)",
        "sph,0,0,0,1,1      | (values are separated by white space, not by commas)",
    })
    void aCharacterThatOnlyLooksRightIsNamed(String code, String expected) {
        assertEquals("unknown code " + expected + ", " + CODES + ", did you mean sph?", UnknownCode.message(code));
    }

    @Test
    void aWordOfAnotherScriptIsNamedToo() {
        assertEquals("unknown code (U+05DB HEBREW LETTER KAF), " + CODES, UnknownCode.message("\u05db\u05d3\u05d5\u05e8"));
    }
}
