package raytracing.parse;

import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;

/** Recognises a file that is no scene file at all, so that one sentence can say so instead of an error for each line. */
final class OtherFile {
    private static final String UTF_32 = "UTF-32 text";

    /** What the first word of a file begins with, a character for each byte, in any case. */
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

    /** Letters of Western languages in the encodings of 2 and 4 bytes: zeros beside each. */
    private static final Pattern TWO_BYTES_EACH = Pattern.compile("\0?([^\0]\0)+[^\0]?", Pattern.DOTALL);
    private static final Pattern FOUR_BYTES_EACH = Pattern.compile("\0{0,3}([^\0]\0{3})+([^\0]\0{0,2})?", Pattern.DOTALL);

    /** Bytes of a word from which on it says how it is encoded. */
    private static final int TELLING = 4;

    private OtherFile() {
    }

    /** What it is instead of a scene file, if that can be told; to be asked where no line has a code. */
    static Optional<String> kind(SceneText text) {
        Optional<String> kind = kind(firstTellingWord(text), text.isMarkedUtf16());
        return kind.isEmpty() && hasZeros(text) ? Optional.of("no text") : kind;
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

    private static String firstTellingWord(SceneText text) {
        text.rewind();
        while (text.hasMoreLines()) {
            text.nextLine();
            for (int i = 0; i < text.count(); i++) {
                String word = text.bytesOfToken(i);
                if (word.length() >= TELLING) {
                    return word;
                }
            }
        }
        return "";
    }

    private static boolean hasZeros(SceneText text) {
        text.rewind();
        while (text.hasMoreLines()) {
            text.nextLine();
            if (text.hasZeros()) {
                return true;
            }
        }
        return false;
    }
}
