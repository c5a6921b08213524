package raytracing.parse;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import raytracing.color.Color;
import raytracing.math.Vector;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;

/**
 * The values of a scene file, line by line, each line from left to right. A value that is not allowed is reported as a
 * problem, and an allowed one takes its place, so that the rest of the line can be checked too.
 */
final class Values {
    /** Replaces a refused number, as it is allowed everywhere in the format; no scene with a refused number is ever made. */
    private static final double REPLACEMENT = 1;

    /** A colour value from here on was more likely meant as one from 0 to 255. */
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

    /** Goes to the next line that has a code; false if there is none. */
    boolean nextLine() {
        return nextLine(text.length());
    }

    /** Goes to the next line that has a code and begins before a place in the text; false if there is none. */
    boolean nextLine(int limit) {
        next = 1;
        problemsFound = 0;
        areSeparatorsRefused = false;
        isColorDoubted = false;
        return text.nextLine(limit);
    }

    /** Whether this line has as many values as its code takes; reports a problem if not. */
    boolean isComplete(Code code) {
        boolean complete = code.allows(text.count() - 1);
        if (!complete) {
            problem(() -> wrongCount(code));
        }
        return complete;
    }

    private String wrongCount(Code code) {
        List<String> values = new ArrayList<>();
        for (int i = 1; i < text.count(); i++) {
            values.add(text.token(i));
        }
        int most = code.most();
        return code.expectation() + ", got " + values.size()
            + (values.size() > most ? ", first surplus value " + Printable.quote(values.get(most)) : "")
            + Hint.aboutValues(values, most);
    }

    boolean hasMore() {
        return next < text.count();
    }

    /** The surface of a complete line; its material's line may still follow. */
    Surface surface(Code code) {
        // Java evaluates arguments from left to right, so each constructor reads its values in the order of the line.
        return switch (code) {
            case SPH -> new Sphere(vector("centre"), number("radius", Range.ABOVE_0), materialIndex());
            case BOX -> new Box(vector("centre"), number("edge", Range.ABOVE_0), materialIndex());
            case TRG -> triangle();
            default -> new Plane(normal(), number("offset", Range.ANY), materialIndex());
        };
    }

    private Triangle triangle() {
        Vector a = vector("first corner");
        Vector b = vector("second corner");
        Vector c = vector("third corner");
        if (problemsFound == 0 && Triangle.areOnALine(a, b, c)) {
            problem(() -> "corners must be three points that are not on one line, got " + shown(a) + ", " + shown(b)
                + " and " + shown(c));
        }
        return Triangle.of(a, b, c, materialIndex());
    }

    private Vector normal() {
        Vector normal = vector("normal");
        if (normal.isZero()) {
            refuse("normal", "a direction, not zero", shown(normal));
        }
        return normal;
    }

    /** A vector as a message shows it. */
    static String shown(Vector vector) {
        return vector.x() + " " + vector.y() + " " + vector.z();
    }

    private int materialIndex() {
        return wholeNumber("material", Range.WHOLE_FROM_1) - 1;
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
            isColorDoubted = true;              // one warning is enough for a line
            warnings.add(text.lineNumber(), "warning: " + text.token(0) + ": " + name + " is "
                + Printable.quote(text.token(next - 3)) + " " + Printable.quote(text.token(next - 2)) + " "
                + Printable.quote(text.token(next - 1)) + ", and 1 is full: 0 to 1, not 0 to 255?");
        }
        return new Color(red, green, blue);
    }

    int wholeNumber(String name, Range range) {
        return (int) number(name, range);
    }

    double number(String name, Range range) {
        return number(name, "", range);
    }

    /** The name and the part of it are joined for messages only, which most numbers do not need. */
    private double number(String name, String part, Range range) {
        int i = next++;
        double value = text.decimal(i);
        if (Math.abs(value) < Double.POSITIVE_INFINITY && range.contains(value)) {
            return value;
        }
        String token = text.token(i);
        boolean isSeparated = Double.isNaN(value) && Hint.isSeparated(token);
        if (!isSeparated || !areSeparatorsRefused) {        // once for each line
            refuse(name + part, expected(value, token, range), token);
        }
        areSeparatorsRefused |= isSeparated;
        return REPLACEMENT;
    }

    /** What was expected instead of a token that is no number, or one too large, or out of range. */
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

    /** Reports what a value must be, and what it is. */
    void refuse(String name, String expected, String got) {
        problem(() -> name + " must be " + expected + ", got " + Printable.quote(got) + Hint.about(got));
    }

    /** How many values of this line were refused so far, and replaced. */
    int problemsFound() {
        return problemsFound;
    }

    void problem(Supplier<String> message) {
        problemsFound++;
        problems.add(text.lineNumber(), () -> Printable.quote(text.token(0)) + ": " + message.get());
    }
}
