package raytracing.parse;

import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;

/** Recognises a file that is no scene file at all, so that one message can say so instead of an error for each line. */
final class OtherFile {
    private static final String UTF_32 = "UTF-32 text";

    /** How the first word of a file begins, one character for each byte, in any case. */
    private static final Map<String, String> KINDS = Map.of(
        "\u0089png", "a PNG picture",
        "\u00ff\u00d8\u00ff", "a JPEG picture",
        "gif8", "a GIF picture",
        "pk\u0003\u0004", "a zip or jar file",
        "%pdf-", "a PDF file",
        "{\\rtf", "an RTF file of a word processor",
        "<!doctype", "a web page",
        "<html", "a web page",
        "\0\0\u00fe\u00ff", UTF_32);

    /** Letters of Western languages in encodings of 2 and 4 bytes have zeros next to them. */
    private static final Pattern TWO_BYTES_EACH = Pattern.compile("\0?([^\0]\0)+[^\0]?", Pattern.DOTALL);
    private static final Pattern FOUR_BYTES_EACH = Pattern.compile("\0{0,3}([^\0]\0{3})+([^\0]\0{0,2})?", Pattern.DOTALL);

    /** A word of at least so many bytes shows how it is encoded. */
    private static final int LONG_ENOUGH = 4;

    private OtherFile() {
    }

    /** The kind of a file in which no line has a code, if it is known. */
    static Optional<String> kind(SceneText text) {
        String word = "";
        boolean hasZeros = false;
        text.rewind();
        while (text.nextLine(text.length())) {
            for (int i = 0; i < text.count() && word.length() < LONG_ENOUGH; i++) {
                word = text.token(i, StandardCharsets.ISO_8859_1);
            }
            hasZeros |= text.hasZeros();
        }
        Optional<String> kind = kind(word.length() < LONG_ENOUGH ? "" : word, text.isMarkedUtf16());
        return kind.isEmpty() && hasZeros ? Optional.of("no text") : kind;
    }

    private static Optional<String> kind(String word, boolean isMarkedUtf16) {
        for (Map.Entry<String, String> kind : KINDS.entrySet()) {
            if (word.regionMatches(true, 0, kind.getKey(), 0, kind.getKey().length())) {
                return Optional.of(kind.getValue());
            }
        }
        if (TWO_BYTES_EACH.matcher(word).matches()) {
            return Optional.of(isMarkedUtf16 ? UTF_32 : "UTF-16 text without a byte-order mark");
        }
        return FOUR_BYTES_EACH.matcher(word).matches() ? Optional.of(UTF_32) : Optional.empty();
    }
}
