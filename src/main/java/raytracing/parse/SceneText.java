package raytracing.parse;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * The bytes of a scene file as lines of tokens. Accepts every line end (LF, CRLF, CR), a byte-order mark of UTF-8 or
 * UTF-16, and any bytes at all in a remark: whatever is no text becomes a replacement character, which only matters
 * where a value should stand.
 */
final class SceneText {
    private static final char REMARK = '#';
    private static final char BYTE_ORDER_MARK = '\ufeff';

    private final String text;
    private int position;
    private int lineNumber;

    SceneText(byte[] bytes) {
        text = new String(bytes, charset(bytes));
    }

    private static Charset charset(byte[] bytes) {
        int first = bytes.length < 2 ? 0 : (bytes[0] & 0xff) << 8 | bytes[1] & 0xff;
        return first == 0xfeff || first == 0xfffe ? StandardCharsets.UTF_16 : StandardCharsets.UTF_8;
    }

    /** Number of the line that {@link #nextLine} returned last, from 1. */
    int lineNumber() {
        return lineNumber;
    }

    boolean hasMoreLines() {
        return position < text.length();
    }

    /** The tokens of the next line up to its remark: none on an empty line. */
    List<String> nextLine() {
        lineNumber++;
        List<String> tokens = new ArrayList<>();
        while (position < text.length() && !isLineEnd(text.charAt(position))) {
            if (isWhiteSpace(text.charAt(position))) {
                position++;
            } else if (text.charAt(position) == REMARK) {
                skipToLineEnd();
            } else {
                tokens.add(token());
            }
        }
        skipLineEnd();
        return tokens;
    }

    private String token() {
        int start = position;
        while (position < text.length() && !isLineEnd(text.charAt(position)) && !isWhiteSpace(text.charAt(position))) {
            position++;
        }
        return text.substring(start, position);
    }

    private void skipToLineEnd() {
        while (position < text.length() && !isLineEnd(text.charAt(position))) {
            position++;
        }
    }

    private void skipLineEnd() {
        if (position < text.length()) {
            boolean carriageReturn = text.charAt(position) == '\r';
            position++;
            if (carriageReturn && position < text.length() && text.charAt(position) == '\n') {
                position++;
            }
        }
    }

    private static boolean isLineEnd(char c) {
        return c == '\n' || c == '\r';
    }

    /** Also the spaces that editors and web pages put in place of a plain one, and a mark left in mid-file. */
    private static boolean isWhiteSpace(char c) {
        return c == ' ' || (c < ' ' || c > '~')
            && (Character.isWhitespace(c) || Character.isSpaceChar(c) || c == BYTE_ORDER_MARK);
    }
}
