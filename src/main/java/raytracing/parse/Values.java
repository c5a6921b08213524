package raytracing.parse;

import java.util.List;
import java.util.Locale;
import raytracing.color.Color;
import raytracing.math.Vector;

/**
 * The values of one scene line, read from left to right. A value that may not be what it is becomes a problem, and a
 * harmless stand-in takes its place so that the rest of the line can be checked too.
 */
final class Values {
    /** Allowed everywhere in the format but for fisheye; the scene it would end up in is never made. */
    private static final double STAND_IN = 1;

    private final int line;
    private final String code;
    private final List<String> tokens;
    private final Problems problems;
    private int next;
    private int problemsFound;

    Values(int line, String code, List<String> tokens, Problems problems) {
        this.line = line;
        this.code = code;
        this.tokens = tokens;
        this.problems = problems;
    }

    int line() {
        return line;
    }

    int count() {
        return tokens.size();
    }

    String token(int i) {
        return tokens.get(i);
    }

    boolean hasMore() {
        return next < tokens.size();
    }

    Vector vector(String name) {
        double x = number(name + " x", Range.ANY);
        double y = number(name + " y", Range.ANY);
        double z = number(name + " z", Range.ANY);
        return new Vector(x, y, z);
    }

    Color color(String name) {
        double red = number(name + " red", Range.AT_LEAST_0);
        double green = number(name + " green", Range.AT_LEAST_0);
        double blue = number(name + " blue", Range.AT_LEAST_0);
        return new Color(red, green, blue);
    }

    int wholeNumber(String name, int smallest, int largest) {
        return (int) number(name, Range.whole(smallest, largest));
    }

    double number(String name, Range range) {
        String token = tokens.get(next++);
        if (!isDecimal(token)) {
            String hint = isDecimal(token.replace(',', '.')) ? " with a dot, not a comma" : "";
            refuse(name, "a decimal number" + hint, token);
            return STAND_IN;
        }
        double value = Double.parseDouble(token);
        if (Double.isInfinite(value)) {
            refuse(name, "within what a double can hold", token);
            return STAND_IN;
        }
        if (!range.contains().test(value)) {
            refuse(name, range.description(), token);
            return STAND_IN;
        }
        return value;
    }

    boolean flag(String name) {
        String token = tokens.get(next++);
        String word = token.toLowerCase(Locale.ROOT);
        if (!word.equals("true") && !word.equals("false")) {
            refuse(name, "true or false", token);
        }
        return word.equals("true");
    }

    void refuse(String name, String expected, String got) {
        problem(name + " must be " + expected + ", got " + Problems.printable(got));
    }

    /** How many values of this line were refused so far, and replaced by stand-ins. */
    int problemsFound() {
        return problemsFound;
    }

    void problem(String message) {
        problemsFound++;
        problems.add(line, code, message);
    }

    /** Sign, digits with at most one dot among or beside them, exponent: no words, no hexadecimal, no type suffix. */
    static boolean isDecimal(String token) {
        int i = skipSign(token, 0);
        int afterWhole = skipDigits(token, i);
        int digits = afterWhole - i;
        i = afterWhole;
        if (i < token.length() && token.charAt(i) == '.') {
            int afterFraction = skipDigits(token, i + 1);
            digits += afterFraction - (i + 1);
            i = afterFraction;
        }
        if (digits == 0) {
            return false;
        }
        if (i < token.length() && (token.charAt(i) == 'e' || token.charAt(i) == 'E')) {
            int exponent = skipSign(token, i + 1);
            i = skipDigits(token, exponent);
            return i > exponent && i == token.length();
        }
        return i == token.length();
    }

    private static int skipSign(String token, int i) {
        return i < token.length() && (token.charAt(i) == '+' || token.charAt(i) == '-') ? i + 1 : i;
    }

    private static int skipDigits(String token, int start) {
        int i = start;
        while (i < token.length() && token.charAt(i) >= '0' && token.charAt(i) <= '9') {
            i++;
        }
        return i;
    }
}
