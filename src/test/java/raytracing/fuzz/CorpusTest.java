package raytracing.fuzz;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class CorpusTest {
    static java.util.List<String> lines() {
        return Corpus.inputs().stream().map(Corpus::line).toList();
    }

    @ParameterizedTest
    @MethodSource("lines")
    void theParserOwesAnAnswerToEveryInputKept(String line) {
        AnyBytes.check(Corpus.bytes(line));
    }

    @Test
    void anyByteCanBeKept() {
        byte[] all = new byte[256];
        for (int i = 0; i < all.length; i++) {
            all[i] = (byte) i;
        }
        assertArrayEquals(all, Corpus.bytes(Corpus.line(all)));
    }

    @Test
    void anInputIsOneLine() {
        assertEquals("a\\nb\\x0d\\\\", Corpus.line(new byte[] {'a', '\n', 'b', '\r', '\\'}));
    }
}
