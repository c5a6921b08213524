package raytracing.parse;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import raytracing.color.Color;
import raytracing.math.Vector;

/**
 * The values of a scene file, line by line, each line from left to right. A value that may not be what it is becomes a
 * problem, and a harmless stand-in takes its place so that the rest of the line can be checked too.
 */
final class Values {
    /** Allowed everywhere in the format but for fisheye; the scene it would end up in is never made. */
    private static final double STAND_IN = 1;

    private final SceneText text;
    private final Problems problems;
    private int next;
    private int problemsFound;

    Values(SceneText text, Problems problems) {
        this.text = text;
        this.problems = problems;
    }

    /** Goes to the next line that is not empty; false if there is none. */
    boolean nextLine() {
        next = 1;
        problemsFound = 0;
        while (text.hasMoreLines()) {
            text.nextLine();
            if (text.count() > 0) {
                return true;
            }
        }
        return false;
    }

    int line() {
        return text.lineNumber();
    }

    /** The code of the line, as {@link SceneText#code} packs it. */
    int code() {
        return text.code();
    }

    /** How many values follow the code. */
    int count() {
        return text.count() - 1;
    }

    /** The code (0) or a value (from 1) as the file has it. */
    String token(int i) {
        return text.token(i);
    }

    boolean hasMore() {
        return next < text.count();
    }

    Vector vector(String name) {
        double x = number(name, " x", Range.ANY);
        double y = number(name, " y", Range.ANY);
        double z = number(name, " z", Range.ANY);
        return new Vector(x, y, z);
    }

    Color color(String name) {
        double red = number(name, " red", Range.AT_LEAST_0);
        double green = number(name, " green", Range.AT_LEAST_0);
        double blue = number(name, " blue", Range.AT_LEAST_0);
        return new Color(red, green, blue);
    }

    int wholeNumber(String name, Range range) {
        double value = number(name, range);
        if (value != Math.rint(value)) {
            refuse(name, range.description(), text.token(next - 1));
            return (int) STAND_IN;
        }
        return (int) value;
    }

    double number(String name, Range range) {
        return number(name, "", range);
    }

    /** The two halves of the name meet only in messages: most numbers need none. */
    private double number(String name, String part, Range range) {
        int i = next++;
        double value = text.decimal(i);
        if (Math.abs(value) < Double.POSITIVE_INFINITY && range.contains(value)) {
            return value;
        }
        refuse(name + part, expected(value, text.token(i), range), text.token(i));
        return STAND_IN;
    }

    /** What a number should have been that is none, or too large, or out of range. */
    private static String expected(double value, String token, Range range) {
        if (Double.isNaN(value)) {
            return "a decimal number" + (isDecimal(token.replace(',', '.')) ? " with a dot, not a comma" : "");
        }
        return Double.isInfinite(value) ? "within what a double can hold" : range.description();
    }

    private static boolean isDecimal(String token) {
        byte[] bytes = token.getBytes(StandardCharsets.UTF_8);
        return !Double.isNaN(new DecimalReader(bytes).read(0, bytes.length));
    }

    boolean flag(String name) {
        String token = text.token(next++);
        String word = token.toLowerCase(Locale.ROOT);
        if (!word.equals("true") && !word.equals("false")) {
            refuse(name, "true or false", token);
        }
        return word.equals("true");
    }

    void refuse(String name, String expected, String got) {
        problem(Problems.refusal(name, expected, got));
    }

    /** How many values of this line were refused so far, and replaced by stand-ins. */
    int problemsFound() {
        return problemsFound;
    }

    void problem(String message) {
        problemsFound++;
        problems.add(line(), token(0), message);
    }
}
