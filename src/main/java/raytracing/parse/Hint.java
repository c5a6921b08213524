package raytracing.parse;

import java.text.Normalizer;
import java.util.List;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Explains why a word that should be a number or a code probably is none: commas between values, a remark as in other
 * languages, a character that only looks like another one. A hint stands in brackets after the quoted word.
 */
final class Hint {
    private static final String REMARK = " (remarks begin with #)";
    private static final List<String> REMARKS = List.of("//", "/*", "*/", ";", "%", "--", "<!--");
    private static final Pattern SEPARATORS = Pattern.compile("[,;|()\\[\\]{}<>]+");

    /** The character that replaces bytes that are no UTF-8. */
    private static final int REPLACEMENT = 0xfffd;

    private static final String MINUS_SIGNS = "\u2212\u02d7\u2796";
    private static final String DECIMAL_POINTS = "\u066b\u00b7";

    private Hint() {
    }

    /** A hint about a word that is no number. */
    static String about(String word) {
        if (isRemark(word)) {
            return REMARK;
        }
        if (isSeparated(word)) {
            return notSeparatedBy(word);
        }
        OptionalInt strange = word.codePoints().filter(character -> !isPlain(character)).findFirst();
        return strange.isPresent() ? " (" + named(strange.getAsInt()) + ")" : "";
    }

    /** A hint about a word that is no code; values may follow it without white space. */
    static String aboutCode(String word) {
        String hint = about(word);
        return hint.isEmpty() && SEPARATORS.matcher(word).find() ? notSeparatedBy(word) : hint;
    }

    /** A hint about a line with too few or too many values. */
    static String aboutValues(List<String> values, int most) {
        for (String value : values) {
            String hint = value.contains(",") ? notSeparatedBy(",") : about(value);
            if (!hint.isEmpty()) {
                return hint;
            }
        }
        return values.size() > most && !DecimalReader.isDecimal(values.get(most)) ? REMARK : "";
    }

    /** Whether a word begins as remarks do in other languages. */
    static boolean isRemark(String word) {
        return REMARKS.stream().anyMatch(word::startsWith) && !DecimalReader.isDecimal(word.replaceFirst("^[-;]+", ""));
    }

    /** Whether only decimal numbers, or nothing, stand between commas or brackets. A comma as decimal sign does not count. */
    static boolean isSeparated(String word) {
        boolean isDecimalWithComma = DecimalReader.isDecimal(word.replace(',', '.')) && !word.endsWith(",");
        return SEPARATORS.matcher(word).find() && !isDecimalWithComma
            && SEPARATORS.splitAsStream(word).allMatch(part -> part.isEmpty() || DecimalReader.isDecimal(part));
    }

    /** A hint about the first separator in a word. */
    private static String notSeparatedBy(String word) {
        Matcher separators = SEPARATORS.matcher(word);
        separators.find();
        String wrong = switch (separators.group().charAt(0)) {
            case ',' -> "commas";
            case ';' -> "semicolons";
            case '|' -> "bars";
            default -> "brackets";
        };
        return " (values are separated by white space, not by " + wrong + ")";
    }

    private static boolean isPlain(int character) {
        return character >= ' ' && character <= '~';
    }

    private static String named(int character) {
        if (character == REPLACEMENT) {
            return "bytes that are not UTF-8";
        }
        String name = Character.getName(character);
        return Printable.code(character) + (name == null ? "" : " " + name) + remedy(character);
    }

    private static String remedy(int character) {
        if (!Printable.isVisible(character)) {
            return ", leave it out";
        }
        String plain = plain(character);
        return plain.length() == 1 && isPlain(plain.charAt(0)) ? ", write " + plain : "";
    }

    /** A word in which plain characters replace those that look like them. */
    static String plain(String word) {
        StringBuilder plain = new StringBuilder();
        word.codePoints().filter(Printable::isVisible).forEach(character -> plain.append(plain(character)));
        return plain.toString();
    }

    /** Unicode maps wide, narrow, raised and decorated forms to plain ones, but not digits of other scripts and dashes. */
    private static String plain(int character) {
        if (Character.getType(character) == Character.DASH_PUNCTUATION || MINUS_SIGNS.indexOf(character) >= 0) {
            return "-";
        }
        if (DECIMAL_POINTS.indexOf(character) >= 0) {
            return ".";
        }
        int digit = Character.digit(character, 10);
        return digit >= 0 ? String.valueOf(digit)
            : Normalizer.normalize(Character.toString(character), Normalizer.Form.NFKC);
    }
}
