package raytracing.fuzz;

import java.io.ByteArrayOutputStream;
import java.util.List;
import java.util.Optional;
import raytracing.parallel.ForkJoin;
import raytracing.parse.ParsedScene;
import raytracing.parse.RayTracerException;
import raytracing.parse.SceneParser;
import raytracing.scene.Scene;

/**
 * What the parser must return for any bytes: a scene with numbers in the ranges of the format, or readable messages; and the
 * same result for the same text with other line ends, or with a byte order mark. Its time is not limited here: a caller with
 * many files gives up on one that does not end.
 */
public final class AnyBytes {
    private static final String FILE = "any.txt";
    private static final int MOST_LISTED = 20;
    private static final int MOST_WARNINGS_LISTED = 10;

    private AnyBytes() {
    }

    /**
     * Checks that.
     *
     * @param bytes of a file
     * @throws AssertionError if they get something else; names what
     */
    public static void check(byte[] bytes) {
        Answer answer = answer(bytes);
        answer.scene.ifPresent(SceneRanges::check);
        checkMessages(answer);
        if (!isUtf16(bytes)) {
            same(answer, answer(marked(bytes)), "a byte-order mark before it");
            same(answer, answer(withLineEnds(bytes, "\r\n")), "line ends CRLF");
            same(answer, answer(withLineEnds(bytes, "\r")), "line ends CR");
        }
    }

    /** A scene and warnings, or none and what is wrong. */
    private record Answer(Optional<Scene> scene, List<String> messages) {
        int mostListed() {
            return scene.isPresent() ? MOST_WARNINGS_LISTED : MOST_LISTED;
        }
    }

    private static Answer answer(byte[] bytes) {
        try {
            ParsedScene parsed = SceneParser.parse(FILE, bytes, ForkJoin.sequential());
            return new Answer(Optional.of(parsed.scene()), parsed.warnings());
        } catch (RayTracerException wrong) {
            return new Answer(Optional.empty(), wrong.messages());
        }
    }

    private static void checkMessages(Answer answer) {
        List<String> messages = answer.messages;
        claim(answer.scene.isPresent() || !messages.isEmpty(), "neither a scene nor a message");
        int most = answer.mostListed();
        claim(messages.size() <= most || messages.size() == most + 1
            && messages.get(most).matches(FILE + ": and [1-9][0-9]* more"), "more messages than there may be");
        for (String message : messages) {
            claim(message.startsWith(FILE + ":") && message.length() > FILE.length() + 2, "no name of the file", message);
            claim(message.codePoints().allMatch(AnyBytes::isVisible), "not one line of visible text", message);
            claim(message.length() <= LONGEST_MESSAGE, "too long to read", message);
            claim(message.contains(": warning: ") || answer.scene.isEmpty() || message.endsWith(" more"), "no warning",
                message);
        }
    }

    /** Twice the quote of forty characters, each maybe of two chars, and the longest list of values of a form. */
    private static final int LONGEST_MESSAGE = 500;

    private static boolean isVisible(int character) {
        return switch (Character.getType(character)) {
            case Character.CONTROL, Character.FORMAT, Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR,
                Character.SURROGATE, Character.PRIVATE_USE, Character.UNASSIGNED -> false;
            default -> true;
        };
    }

    private static boolean isUtf16(byte[] bytes) {
        int first = bytes.length < 2 ? 0 : (bytes[0] & 0xff) << 8 | bytes[1] & 0xff;
        return first == 0xfeff || first == 0xfffe;
    }

    private static byte[] marked(byte[] bytes) {
        ByteArrayOutputStream marked = new ByteArrayOutputStream();
        marked.writeBytes(new byte[] {(byte) 0xef, (byte) 0xbb, (byte) 0xbf});
        marked.writeBytes(bytes);
        return marked.toByteArray();
    }

    /** The same lines with one kind of end; it is a pair that ends one line, so pairs come first. */
    private static byte[] withLineEnds(byte[] bytes, String lineEnd) {
        ByteArrayOutputStream lines = new ByteArrayOutputStream();
        for (int i = 0; i < bytes.length; i++) {
            boolean isPair = bytes[i] == '\r' && i + 1 < bytes.length && bytes[i + 1] == '\n';
            if (bytes[i] == '\n' || bytes[i] == '\r') {
                lineEnd.chars().forEach(lines::write);
                i += isPair ? 1 : 0;
            } else {
                lines.write(bytes[i]);
            }
        }
        return lines.toByteArray();
    }

    private static void same(Answer expected, Answer got, String change) {
        claim(expected.equals(got), "another answer with " + change, expected + " and " + got);
    }

    static void claim(boolean isTrue, String otherwise, Object... seen) {
        if (!isTrue) {
            throw new AssertionError(otherwise + (seen.length == 0 ? "" : ": " + seen[0]));
        }
    }
}
