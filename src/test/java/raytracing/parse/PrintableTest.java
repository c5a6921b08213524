package raytracing.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class PrintableTest {
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "a\u001b[31m.txt       | a<U+001B>[31m.txt",
        "a\u202egpj.txt        | a<U+202E>gpj.txt",
        "a\u200b\u00ad\ufeffb  | a<U+200B><U+00AD><U+FEFF>b",
        "a\u2028b\u2029c       | a<U+2028>b<U+2029>c",
        "a\u00a0b\u3000c       | a<U+00A0>b<U+3000>c",
        "a\ud800b              | a<U+D800>b",
        "a\ue000b\uffffc       | a<U+E000>b<U+FFFF>c",
        "a\udb40\udc41b        | a<U+E0041>b",
        "a\u3164b\u2800c       | a<U+3164>b<U+2800>c",
        "a\u0085\u007fb        | a<U+0085><U+007F>b",
    })
    void whatWouldNotBeSeenOrWouldMoveTheRestIsNamed(String text, String shown) {
        assertEquals(shown, Printable.of(text));
        assertEquals(shown, Printable.quote(text));
    }

    @Test
    void aLineEndInANameStartsNoLine() {
        assertEquals("a<U+000A>b<U+000D>c", Printable.of("a\nb\rc"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "scene one.txt", "~!{}", "\u05e9\u05dc\u05d5\u05dd.txt", "e\u0301t\u00e9.txt",
        "\u5834\u9762.txt", "\ud83d\ude00.txt", "\ufffd", "<U+202E>"})
    void whatIsVisibleStaysAsItIs(String text) {
        assertEquals(text, Printable.of(text));
    }

    @Test
    void anAccentAtTheStartOfAQuoteDoesNotJoinWhatIsBeforeIt() {
        assertEquals("<U+0301>1", Printable.quote("\u03011"));
        assertEquals("1\u0301", Printable.quote("1\u0301"));
    }

    @Test
    void aQuoteEndsAfterFortyCharactersAndNeverWithinOne() {
        assertEquals("x".repeat(40), Printable.quote("x".repeat(40)));
        assertEquals("x".repeat(40) + "...", Printable.quote("x".repeat(41)));
        assertEquals("\ud83d\ude00".repeat(20) + "...", Printable.quote("\ud83d\ude00".repeat(21)));
        assertEquals("<U+0001>".repeat(5) + "...", Printable.quote("\u0001".repeat(1000)));
    }
}
