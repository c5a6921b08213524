package raytracing.parse;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import raytracing.color.Color;
import raytracing.math.Vector;

/**
 * The values of a scene file, line by line, each line from left to right. A value that may not be what it is becomes a
 * problem, and a harmless stand-in takes its place so that the rest of the line can be checked too.
 */
final class Values {
    /** Allowed everywhere in the format but for fisheye; the scene it would end up in is never made. */
    private static final double STAND_IN = 1;

    /** A colour from here on is more likely counted in bytes than meant. */
    private static final double FAR_BEYOND_FULL = 20;

    private final SceneText text;
    private final Findings problems;
    private final Findings warnings;
    private int next;
    private int problemsFound;
    private boolean areSeparatorsRefused;
    private boolean isColorDoubted;

    Values(SceneText text, Findings problems, Findings warnings) {
        this.text = text;
        this.problems = problems;
        this.warnings = warnings;
    }

    /** Goes back to before the first line. */
    void rewind() {
        text.rewind();
    }

    /** Goes to the next line that is not empty; false if there is none. */
    boolean nextLine() {
        next = 1;
        problemsFound = 0;
        areSeparatorsRefused = false;
        isColorDoubted = false;
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

    /** All values of the line as the file has them. */
    List<String> tokens() {
        List<String> tokens = new ArrayList<>();
        for (int i = 1; i < text.count(); i++) {
            tokens.add(text.token(i));
        }
        return tokens;
    }

    /** A value (from 1) as a decimal number, {@link Double#NaN} if it is none. */
    double decimal(int i) {
        return text.decimal(i);
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
        if (Math.max(red, Math.max(green, blue)) >= FAR_BEYOND_FULL && !isColorDoubted) {
            doubtColor(name);
        }
        return new Color(red, green, blue);
    }

    /** Once for each line. */
    private void doubtColor(String name) {
        isColorDoubted = true;
        warnings.add(line(), "warning: " + token(0) + ": " + name + " is " + Printable.quote(token(next - 3)) + " "
            + Printable.quote(token(next - 2)) + " " + Printable.quote(token(next - 1))
            + ", and 1 is full: 0 to 1, not 0 to 255?");
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
        refuseNumber(name + part, value, text.token(i), range);
        return STAND_IN;
    }

    /** Where commas or brackets stand beside the values of a line, this is said once. */
    private void refuseNumber(String name, double value, String token, Range range) {
        boolean isSeparated = Double.isNaN(value) && Hint.isSeparated(token);
        if (!isSeparated || !areSeparatorsRefused) {
            refuse(name, expected(value, token, range), token);
        }
        areSeparatorsRefused |= isSeparated;
    }

    /** What a number should have been that is none, or too large, or out of range. */
    private static String expected(double value, String token, Range range) {
        if (Double.isNaN(value)) {
            boolean hasComma = !Hint.isSeparated(token) && DecimalReader.isDecimal(token.replace(',', '.'));
            return "a decimal number" + (hasComma ? " with a dot, not a comma" : "");
        }
        return Double.isInfinite(value) ? "within what a double can hold" : range.description();
    }

    boolean flag(String name) {
        String token = text.token(next++);
        String word = token.toLowerCase(Locale.ROOT);
        if (!word.equals("true") && !word.equals("false")) {
            refuse(name, "true or false", token);
        }
        return word.equals("true");
    }

    /** Says what a value must be instead of what it is. */
    void refuse(String name, String expected, String got) {
        problem(() -> name + " must be " + expected + ", got " + Printable.quote(got) + Hint.about(got));
    }

    /** How many values of this line were refused so far, and replaced by stand-ins. */
    int problemsFound() {
        return problemsFound;
    }

    void problem(Supplier<String> message) {
        problemsFound++;
        problems.add(line(), () -> Printable.quote(token(0)) + ": " + message.get());
    }
}
