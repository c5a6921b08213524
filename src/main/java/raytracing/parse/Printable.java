package raytracing.parse;

import java.util.Locale;

/**
 * Text of the user as messages show it. What would not be seen, or would move or colour what stands around it on a
 * terminal, is named instead: {@code <U+001B>} for the escape character.
 */
public final class Printable {
    /** So many characters of a piece of a file are shown. */
    private static final int LONGEST_QUOTE = 40;

    /** Letters and a symbol by their class in Unicode, but without ink: fillers of Hangul, the blank of Braille. */
    private static final String BLANK_LETTERS = "\u115f\u1160\u3164\uffa0\u2800";

    private Printable() {
    }

    /**
     * A whole text, for instance a message that names a file.
     *
     * @param text any
     * @return the same in one line of visible characters and plain spaces
     */
    public static String of(String text) {
        int plain = 0;
        while (plain < text.length() && text.charAt(plain) >= ' ' && text.charAt(plain) <= '~') {
            plain++;
        }
        if (plain == text.length()) {
            return text;
        }
        StringBuilder shown = new StringBuilder();
        for (int i = 0; i < text.length(); i += Character.charCount(text.codePointAt(i))) {
            append(text.codePointAt(i), shown);
        }
        return shown.toString();
    }

    /** A piece of a scene file, short enough to read. An accent at its start is named: it would join what is before it. */
    static String quote(String piece) {
        StringBuilder shown = new StringBuilder();
        int i = 0;
        while (i < piece.length() && shown.length() < LONGEST_QUOTE) {
            int character = piece.codePointAt(i);
            if (i == 0 && isAccent(character)) {
                appendName(character, shown);
            } else {
                append(character, shown);
            }
            i += Character.charCount(character);
        }
        return i < piece.length() ? shown + "..." : shown.toString();
    }

    private static void append(int character, StringBuilder shown) {
        if (isVisible(character)) {
            shown.appendCodePoint(character);
        } else {
            appendName(character, shown);
        }
    }

    private static void appendName(int character, StringBuilder shown) {
        shown.append('<').append(code(character)).append('>');
    }

    /** As Unicode writes it, for instance U+202E. */
    static String code(int character) {
        String digits = Integer.toHexString(character).toUpperCase(Locale.ROOT);
        return "U+" + "0".repeat(Math.max(0, 4 - digits.length())) + digits;
    }

    static boolean isVisible(int character) {
        return switch (Character.getType(character)) {
            case Character.CONTROL, Character.FORMAT, Character.SURROGATE, Character.PRIVATE_USE, Character.UNASSIGNED,
                Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR -> false;
            case Character.SPACE_SEPARATOR -> character == ' ';
            default -> BLANK_LETTERS.indexOf(character) < 0;
        };
    }

    private static boolean isAccent(int character) {
        int type = Character.getType(character);
        return type == Character.NON_SPACING_MARK || type == Character.COMBINING_SPACING_MARK
            || type == Character.ENCLOSING_MARK;
    }
}
