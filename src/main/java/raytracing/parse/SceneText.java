package raytracing.parse;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * The bytes of a scene file as lines of tokens. Accepts every line end (LF, CRLF, CR), a byte-order mark of UTF-8 or
 * UTF-16, and any bytes at all in a remark: whatever is no text becomes a replacement character, which only matters
 * where a value should stand.
 *
 * <p>A token is a range of bytes and becomes a string only where somebody asks for one: in a scene of a million
 * surfaces, nobody does.
 */
final class SceneText {
    private static final byte REMARK = '#';
    private static final char BYTE_ORDER_MARK = '\ufeff';
    private static final int LARGE_BYTE_ORDER_MARK = 0xfeff;
    private static final int SMALL_BYTE_ORDER_MARK = 0xfffe;
    private static final int TOKENS_OF_A_USUAL_LINE = 16;

    /** The first byte of a character of three bytes in UTF-8, and of nothing shorter. */
    private static final int FIRST_OF_THREE = 0xe0;

    private final byte[] bytes;
    private final DecimalReader decimals;
    private int position;
    private int lineNumber;
    private int[] starts = new int[TOKENS_OF_A_USUAL_LINE];
    private int[] ends = new int[TOKENS_OF_A_USUAL_LINE];
    private int count;

    SceneText(byte[] bytes) {
        this.bytes = isUtf16(bytes)
            ? new String(bytes, StandardCharsets.UTF_16).getBytes(StandardCharsets.UTF_8) : bytes;
        decimals = new DecimalReader(this.bytes);
    }

    private static boolean isUtf16(byte[] bytes) {
        int first = bytes.length < 2 ? 0 : (bytes[0] & 0xff) << 8 | bytes[1] & 0xff;
        return first == LARGE_BYTE_ORDER_MARK || first == SMALL_BYTE_ORDER_MARK;
    }

    /** Number of the line that {@link #nextLine} read last, from 1. */
    int lineNumber() {
        return lineNumber;
    }

    boolean hasMoreLines() {
        return position < bytes.length;
    }

    /** Goes to the next line, whose tokens end where its remark begins: an empty line has none. */
    void nextLine() {
        lineNumber++;
        count = 0;
        int i = position;
        while (i < bytes.length && !isLineEnd(bytes[i])) {
            int whiteSpace = whiteSpaceLength(i);
            if (whiteSpace > 0) {
                i += whiteSpace;
            } else if (bytes[i] == REMARK) {
                i = lineEnd(i);
            } else {
                int end = tokenEnd(i);
                add(i, end);
                i = end;
            }
        }
        position = afterLineEnd(i);
    }

    /** How many tokens this line has. */
    int count() {
        return count;
    }

    /** A token of this line, from 0. */
    String token(int i) {
        return new String(bytes, starts[i], ends[i] - starts[i], StandardCharsets.UTF_8);
    }

    /** A token of this line as a decimal number, {@link Double#NaN} if it is none. */
    double decimal(int i) {
        return decimals.read(starts[i], ends[i]);
    }

    /**
     * The first token of this line as a code of three letters in any case, packed into a number so that no line needs a
     * string to be recognised; another number if it is no such code.
     */
    int code() {
        int start = starts[0];
        return ends[0] - start == 3
            ? lowerCase(bytes[start]) << 16 | lowerCase(bytes[start + 1]) << 8 | lowerCase(bytes[start + 2]) : 0;
    }

    /** Right for letters; what is no letter stays none. */
    private static int lowerCase(byte letter) {
        return (letter | 0x20) & 0xff;
    }

    private void add(int start, int end) {
        if (count == starts.length) {
            starts = Arrays.copyOf(starts, 2 * count);
            ends = Arrays.copyOf(ends, 2 * count);
        }
        starts[count] = start;
        ends[count] = end;
        count++;
    }

    private int tokenEnd(int start) {
        int i = start;
        while (i < bytes.length && (bytes[i] > ' ' || !isLineEnd(bytes[i]) && whiteSpaceLength(i) == 0)) {
            i++;
        }
        return i;
    }

    private int lineEnd(int start) {
        int i = start;
        while (i < bytes.length && !isLineEnd(bytes[i])) {
            i++;
        }
        return i;
    }

    private int afterLineEnd(int i) {
        boolean isPair = i + 1 < bytes.length && bytes[i] == '\r' && bytes[i + 1] == '\n';
        return Math.min(isPair ? i + 2 : i + 1, bytes.length);
    }

    private static boolean isLineEnd(byte b) {
        return b == '\n' || b == '\r';
    }

    /** How many bytes the white space at a place has, 0 if there is none. */
    private int whiteSpaceLength(int i) {
        byte b = bytes[i];
        if (b > ' ') {
            return 0;
        }
        if (b < 0) {
            return wideWhiteSpaceLength(i);
        }
        return Character.isWhitespace(b) ? 1 : 0;
    }

    /**
     * Also the spaces that editors and web pages put in place of a plain one, and a mark left in mid-file. All of them
     * have two or three bytes in UTF-8, the first of which is never a later byte of something else.
     */
    private int wideWhiteSpaceLength(int i) {
        int length = (bytes[i] & 0xff) < FIRST_OF_THREE ? 2 : 3;
        char c = new String(bytes, i, Math.min(length, bytes.length - i), StandardCharsets.UTF_8).charAt(0);
        return Character.isWhitespace(c) || Character.isSpaceChar(c) || c == BYTE_ORDER_MARK ? length : 0;
    }
}
