package raytracing.parse;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * The bytes of a scene file as lines of tokens. It accepts every line end (LF, CRLF, CR), a byte-order mark of UTF-8 or
 * UTF-16, and any bytes in a remark: those that are no text become replacement characters, which only matter where a value
 * should stand. A token is a range of bytes and becomes a string only for a message.
 */
final class SceneText {
    private static final byte REMARK = '#';
    private static final char BYTE_ORDER_MARK = '\ufeff';
    private static final int LARGE_BYTE_ORDER_MARK = 0xfeff;
    private static final int SMALL_BYTE_ORDER_MARK = 0xfffe;
    private static final int TOKENS_OF_A_USUAL_LINE = 16;

    /** Ctrl-Z. */
    private static final byte END_OF_FILE = 0x1a;

    /** So many bytes of a token become a string, far more than any message shows: a file without white space is one token. */
    private static final int LONGEST_STRING = 1000;

    /** The least first byte of a character of three bytes in UTF-8; those of shorter ones are less. */
    private static final int FIRST_OF_THREE = 0xe0;

    private final byte[] bytes;
    private final boolean isMarkedUtf16;
    private final DecimalReader decimals;
    private final int end;
    private int position;
    private int lineNumber;
    private int[] starts = new int[TOKENS_OF_A_USUAL_LINE];
    private int[] ends = new int[TOKENS_OF_A_USUAL_LINE];
    private int count;

    SceneText(byte[] bytes) {
        isMarkedUtf16 = isUtf16(bytes);
        this.bytes = withoutEndOfFile(
            isMarkedUtf16 ? new String(bytes, StandardCharsets.UTF_16).getBytes(StandardCharsets.UTF_8) : bytes);
        decimals = new DecimalReader(this.bytes);
        end = this.bytes.length;
    }

    private SceneText(SceneText whole, int from, int to) {
        isMarkedUtf16 = whole.isMarkedUtf16;
        bytes = whole.bytes;
        decimals = new DecimalReader(bytes);
        position = from;
        end = to;
    }

    /** The lines between two places at which lines begin or the text ends; it counts them from 1. */
    SceneText part(int from, int to) {
        return new SceneText(this, from, to);
    }

    /** The first place at or after another one, which is in or before the text, at which a line begins or the text ends. */
    int lineStart(int from) {
        int i = from;
        while (i < end && !(i > 0 && isLineEnd(bytes[i - 1]) && !isPair(i - 1))) {
            i++;
        }
        return Math.min(i, end);
    }

    private boolean isPair(int i) {
        return i + 1 < end && bytes[i] == '\r' && bytes[i + 1] == '\n';
    }

    /** Goes on behind a part whose lines were read elsewhere. */
    void skip(SceneText part) {
        position = part.end;
        lineNumber += part.lineNumber;
    }

    /** How many bytes there are. */
    int length() {
        return end;
    }

    private static boolean isUtf16(byte[] bytes) {
        int first = bytes.length < 2 ? 0 : (bytes[0] & 0xff) << 8 | bytes[1] & 0xff;
        return first == LARGE_BYTE_ORDER_MARK || first == SMALL_BYTE_ORDER_MARK;
    }

    /** The bytes without the Ctrl-Z, one or more, with which old systems end a text. */
    private static byte[] withoutEndOfFile(byte[] bytes) {
        int end = bytes.length;
        for (int i = bytes.length - 1; i >= 0 && (bytes[i] == END_OF_FILE || isPlainWhiteSpace(bytes[i])); i--) {
            if (bytes[i] == END_OF_FILE) {
                end = i;
            }
        }
        return end == bytes.length ? bytes : Arrays.copyOf(bytes, end);
    }

    /** Goes back to before the first line. */
    void rewind() {
        position = 0;
        lineNumber = 0;
    }

    /** Whether the file begins with a byte-order mark of UTF-16. */
    boolean isMarkedUtf16() {
        return isMarkedUtf16;
    }

    /** Number of the line that {@link #nextLine} read last, from 1. */
    int lineNumber() {
        return lineNumber;
    }

    /** How many bytes were read so far. */
    int bytesRead() {
        return position;
    }

    /** Goes to the next line that has a token and begins before a place; false if there is none, the place is reached then. */
    boolean nextLine(int limit) {
        count = 0;
        while (count == 0 && position < limit) {
            readLine();
        }
        return count > 0;
    }

    /** Reads the next line, whose tokens end where its remark begins; an empty line has none. */
    private void readLine() {
        lineNumber++;
        int i = position;
        while (i < end && !isLineEnd(bytes[i])) {
            int whiteSpace = whiteSpaceLength(i);
            if (whiteSpace > 0) {
                i += whiteSpace;
            } else if (bytes[i] == REMARK) {
                while (i < end && !isLineEnd(bytes[i])) {
                    i++;
                }
            } else {
                int tokenEnd = tokenEnd(i);
                add(i, tokenEnd);
                i = tokenEnd;
            }
        }
        position = Math.min(isPair(i) ? i + 2 : i + 1, end);
    }

    /** How many tokens this line has, the code included. */
    int count() {
        return count;
    }

    /** A token of this line, from 0; only the beginning of a very long one. */
    String token(int i) {
        return token(i, StandardCharsets.UTF_8);
    }

    /** The same in another encoding. */
    String token(int i, Charset charset) {
        return new String(bytes, starts[i], Math.min(ends[i] - starts[i], LONGEST_STRING), charset);
    }

    /** Whether a token of this line has a byte 0, which no text has. */
    boolean hasZeros() {
        for (int token = 0; token < count; token++) {
            for (int i = starts[token]; i < ends[token]; i++) {
                if (bytes[i] == 0) {
                    return true;
                }
            }
        }
        return false;
    }

    /** A token of this line as a decimal number, {@link Double#NaN} if it is none. */
    double decimal(int i) {
        return decimals.read(starts[i], ends[i]);
    }

    /** The first token of this line as a code. */
    Code code() {
        int start = starts[0];
        return ends[0] - start == 3 ? Code.of(bytes[start], bytes[start + 1], bytes[start + 2]) : Code.UNKNOWN;
    }

    /** Whether the line is a surface with as many values as its code takes. */
    boolean isCompleteSurface() {
        return code().isSurface() && code().allows(count - 1);
    }

    private void add(int start, int tokenEnd) {
        if (count == starts.length) {
            starts = Arrays.copyOf(starts, 2 * count);
            ends = Arrays.copyOf(ends, 2 * count);
        }
        starts[count] = start;
        ends[count] = tokenEnd;
        count++;
    }

    private int tokenEnd(int start) {
        int i = start;
        while (i < end && (bytes[i] > ' ' || !isLineEnd(bytes[i]) && whiteSpaceLength(i) == 0)) {
            i++;
        }
        return i;
    }

    private static boolean isLineEnd(byte b) {
        return b == '\n' || b == '\r';
    }

    /** How many bytes the white space at an index has, 0 if there is none. */
    private int whiteSpaceLength(int i) {
        byte b = bytes[i];
        if (b < 0) {
            return wideWhiteSpaceLength(i);
        }
        return b <= ' ' && isPlainWhiteSpace(b) ? 1 : 0;
    }

    private static boolean isPlainWhiteSpace(byte b) {
        return b > 0 && Character.isWhitespace(b);
    }

    /**
     * Also the spaces that editors and web pages put in place of a plain one, and a byte-order mark in mid-file. All of
     * them have two or three bytes in UTF-8, and the first of these is never a later byte of another character.
     */
    private int wideWhiteSpaceLength(int i) {
        int length = (bytes[i] & 0xff) < FIRST_OF_THREE ? 2 : 3;
        char c = new String(bytes, i, Math.min(length, bytes.length - i), StandardCharsets.UTF_8).charAt(0);
        return Character.isWhitespace(c) || Character.isSpaceChar(c) || c == BYTE_ORDER_MARK ? length : 0;
    }
}
