package raytracing.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.parallel.ForkJoin;

/** What is said where a number should be and is none: what is wrong with it, and not only that. */
class WrongValuesTest {
    private static final String HEAD = "cam 0 0 -5  0 0 0  0 1 0  1 2\nset 0 0 0  4 10\nmtl 1 1 1  0 0 0  0 0 0  30 0\n";
    private static final String COUNT = "expected 5 values (centre 3, radius, material), got ";

    private static List<String> messages(String line) {
        byte[] bytes = (HEAD + line + "\n").getBytes(StandardCharsets.UTF_8);
        return assertThrows(RayTracerException.class,
            () -> SceneParser.parse("test.txt", bytes, ForkJoin.sequential())).messages();
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource(delimiter = '|', value = {
        "sph 0, 1, 0, 1, 1 | centre x must be a decimal number, got 0, (values are separated by white space, not by commas)",
        "sph (0 1 0) 1 1   | centre x must be a decimal number, got (0 (values are separated by white space, not by brackets)",
        "sph [0 1 0] 1 1   | centre x must be a decimal number, got [0 (values are separated by white space, not by brackets)",
        "sph 0 1 0 1 1;    | material must be a decimal number, got 1; (values are separated by white space, not by semicolons)",
        "sph 0 1 0 1,2 1   | radius must be a decimal number with a dot, not a comma, got 1,2",
        "sph 0 1 0 ,5 1    | radius must be a decimal number with a dot, not a comma, got ,5",
        "sph 0 1 0 1.5,2 1 | radius must be a decimal number, got 1.5,2 (values are separated by white space, not by commas)",
        "sph 0 1 0 1,2,3 1 | radius must be a decimal number, got 1,2,3 (values are separated by white space, not by commas)",
    })
    void valuesAreSeparatedByWhiteSpaceWhichIsSaidOnceForALine(String line, String expected) {
        assertEquals(List.of("test.txt:4: sph: " + expected), messages(line));
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource(delimiter = '|', quoteCharacter = '"', value = {
        "sph 0,1,0,1,1          | 1 (values are separated by white space, not by commas)",
        "sph 0,1 0 1 1          | 4 (values are separated by white space, not by commas)",
        "sph 1;2;3              | 1 (values are separated by white space, not by semicolons)",
        "sph (0,1,0) 1 1        | 3 (values are separated by white space, not by commas)",
        "sph (0 1 0)            | 3 (values are separated by white space, not by brackets)",
        "sph ( 0 1 0 ) 1 1      | 7, first surplus value 1 (values are separated by white space, not by brackets)",
        "sph 0 1 0 1 1 // ball  | 7, first surplus value // (remarks begin with #)",
        "sph 0 1 0 1 1 //ball   | 6, first surplus value //ball (remarks begin with #)",
        "sph 0 1 0 1 1 ; ball   | 7, first surplus value ; (remarks begin with #)",
        "sph 0 1 0 1 1 % ball   | 7, first surplus value % (remarks begin with #)",
        "sph 0 1 0 1 1 -- ball  | 7, first surplus value -- (remarks begin with #)",
        "sph 0 1 0 1 1 /* a */  | 8, first surplus value /* (remarks begin with #)",
        "sph 0 1 0 1 1 a ball   | 7, first surplus value a (remarks begin with #)",
        "sph 0 1 0 1 1 7        | 6, first surplus value 7",
        "sph 0 1 0              | 3",
    })
    void aWrongNumberOfValuesMayBeASeparatorOrARemark(String line, String expected) {
        assertEquals(List.of("test.txt:4: sph: " + COUNT + expected), messages(line));
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource(delimiter = '|', value = {
        "\u22125     | \u22125 (U+2212 MINUS SIGN, write -)",
        "\u20115     | \u20115 (U+2011 NON-BREAKING HYPHEN, write -)",
        "\u20135     | \u20135 (U+2013 EN DASH, write -)",
        "\u20145     | \u20145 (U+2014 EM DASH, write -)",
        "\uff0d5     | \uff0d5 (U+FF0D FULLWIDTH HYPHEN-MINUS, write -)",
        "1\uff15     | 1\uff15 (U+FF15 FULLWIDTH DIGIT FIVE, write 5)",
        "1\uff0e5    | 1\uff0e5 (U+FF0E FULLWIDTH FULL STOP, write .)",
        "\u0661\u0662 | \u0661\u0662 (U+0661 ARABIC-INDIC DIGIT ONE, write 1)",
        "1\u066b5    | 1\u066b5 (U+066B ARABIC DECIMAL SEPARATOR, write .)",
        "1\u00b75    | 1\u00b75 (U+00B7 MIDDLE DOT, write .)",
        "\ud835\udfcf | \ud835\udfcf (U+1D7CF MATHEMATICAL BOLD DIGIT ONE, write 1)",
        "1\uff45\uff13 | 1\uff45\uff13 (U+FF45 FULLWIDTH LATIN SMALL LETTER E, write e)",
        "\u041e      | \u041e (U+041E CYRILLIC CAPITAL LETTER O)",
        "\u00bd      | \u00bd (U+00BD VULGAR FRACTION ONE HALF)",
        "1\u202e2    | 1<U+202E>2 (U+202E RIGHT-TO-LEFT OVERRIDE, leave it out)",
        "1\u200b     | 1<U+200B> (U+200B ZERO WIDTH SPACE, leave it out)",
        "\ue000      | <U+E000> (U+E000 PRIVATE USE AREA E000, leave it out)",
        "--5         | --5",
        "//5         | //5 (remarks begin with #)",
    })
    void aCharacterThatOnlyLooksRightIsNamed(String value, String expected) {
        assertEquals(List.of("test.txt:4: sph: centre x must be a decimal number, got " + expected),
            messages("sph " + value + " 1 0 1 1"));
    }

    @Test
    void aMinusInAnotherEncodingIsNoUtf8() {
        byte[] bytes = (HEAD + "sph \u00965 1 0 1 1\n").getBytes(StandardCharsets.ISO_8859_1);
        assertEquals(List.of(
            "test.txt:4: sph: centre x must be a decimal number, got \ufffd5 (bytes that are not UTF-8)"),
            assertThrows(RayTracerException.class, () -> SceneParser.parse("test.txt", bytes, ForkJoin.sequential())).messages());
    }

    @Test
    void theWordsOfTheFisheyeAreLookedAtLikewise() {
        assertEquals(List.of("test.txt:1: cam: fisheye must be true or false, got \uff54rue "
            + "(U+FF54 FULLWIDTH LATIN SMALL LETTER T, write t)"), assertThrows(RayTracerException.class,
            () -> SceneParser.parse("test.txt", ("cam 0 0 -5  0 0 0  0 1 0  1 2  \uff54rue\nset 0 0 0  4 10\n")
                .getBytes(StandardCharsets.UTF_8), ForkJoin.sequential())).messages());
    }
}
