package raytracing.parse;

import java.util.Locale;

/**
 * Text of the user as messages show it. Characters that are invisible, or that would move or colour the text around them on
 * a terminal, are shown by name: {@code <U+001B>} for the escape character.
 */
public final class Printable {
    /** So many characters of a piece of a file are shown. */
    private static final int LONGEST_QUOTE = 40;

    /** Letters and a symbol by their class in Unicode, but invisible: fillers of Hangul, the blank of Braille. */
    private static final String BLANK_LETTERS = "\u115f\u1160\u3164\uffa0\u2800";

    private Printable() {
    }

    /** A whole text, for instance a message that names a file, as one line of visible characters and plain spaces. */
    public static String of(String text) {
        StringBuilder shown = new StringBuilder();
        for (int i = 0; i < text.length(); i += Character.charCount(text.codePointAt(i))) {
            shown.append(shown(text.codePointAt(i)));
        }
        return shown.toString();
    }

    /** A piece of a scene file, cut if long. An accent at its start is shown by name, as it would join what is before it. */
    static String quote(String piece) {
        StringBuilder shown = new StringBuilder();
        int i = 0;
        while (i < piece.length() && shown.length() < LONGEST_QUOTE) {
            int character = piece.codePointAt(i);
            shown.append(i == 0 && isAccent(character) ? name(character) : shown(character));
            i += Character.charCount(character);
        }
        return i < piece.length() ? shown + "..." : shown.toString();
    }

    private static String shown(int character) {
        return isVisible(character) ? Character.toString(character) : name(character);
    }

    private static String name(int character) {
        return "<" + code(character) + ">";
    }

    /** The character's number as Unicode writes it, for instance U+202E. */
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
