package raytracing.nasty;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import raytracing.math.Vector;
import raytracing.parallel.ForkJoin;
import raytracing.parse.RayTracerException;
import raytracing.parse.SceneParser;
import raytracing.surface.Triangle;

/** Writes the text of a {@link NastyScene}. */
final class NastySceneWriter {
    private static final int PIXELS = NastyDrawing.SIZE * NastyDrawing.SIZE;

    /** How many tests of a shadow ray against a surface a picture may take. */
    private static final double MOST_QUESTIONS = 2e7;

    /** The same where lengths are ordinary, so that tests are quick: an N of 1024 with one lamp and two surfaces. */
    private static final double MOST_ORDINARY_QUESTIONS = 6e8;

    /** Of each of the 10^4 to 10^5 rays of an estimate of ambient light, however small the picture is. */
    private static final double MOST_QUESTIONS_OF_A_RAY = 1500;

    /** Of 4096 that a pixel's rays may meet, for each of 64 reflections. */
    private static final double SURFACES_MET_IN_A_HALL = 64;

    /**
     * A test against a triangle takes as long as this many against another surface where lengths are not ordinary: then mostly
     * exact numbers of thousands of bits decide.
     */
    private static final int TRIANGLE = 400;

    private static final int[] ROOTS = {1, 1, 2, 3, 4, 5, 8, 16, 64, 256, 1024};
    private static final int[] RECURSIONS = {0, 1, 2, 5, 10, 100, 1000};
    private static final double[] EXPONENTS = {0, 1, 0.5, 10, 1.5, 100, 4096, 4097, 1e10, 1e300, 1e-300, 2.5};

    private final NastyNumbers numbers;
    private final StringBuilder text = new StringBuilder();
    private boolean splits;
    private boolean mirrors;
    private boolean isGlassy;
    private boolean isAmbient;
    private int surfaces;

    NastySceneWriter(long seed) {
        numbers = new NastyNumbers(seed);
        write();
    }

    String text() {
        return text.toString();
    }

    /** Whether rays may split in two at every surface. */
    boolean isHall() {
        return splits;
    }

    int surfaces() {
        return surfaces;
    }

    private void write() {
        isAmbient = numbers.oneIn(3);
        int materials = 1 + numbers.below(4);
        for (int i = 0; i < materials; i++) {
            writeMaterial();
        }
        surfaces = numbers.oneIn(6) ? numbers.below(61) : numbers.below(9);
        int lights = numbers.below(4);
        while (questionsOfARay(lights) > MOST_QUESTIONS_OF_A_RAY) {
            lights = Math.max(0, lights - 1);
            surfaces = 9 * surfaces / 10;
        }
        camera();
        for (int i = 0; i < lights; i++) {
            writeLight();
        }
        writeSurfaces(materials);
        writeSettings(lights);
    }

    /** From each surface that a ray of an estimate may meet, it looks on and to every lamp, and any surface may be there. */
    private double questionsOfARay(int lights) {
        return (splits ? 128 : isGlassy ? surfaces : 1) * (1.0 + lights) * surfaces;
    }

    private void line(String code, Object... values) {
        text.append(code);
        for (Object value : values) {
            text.append(' ').append(value instanceof Vector v ? v.x() + " " + v.y() + " " + v.z() : value);
        }
        text.append('\n');
    }

    private void writeMaterial() {
        Vector reflection = numbers.oneIn(3) ? numbers.color() : Vector.ZERO;
        double transparency = numbers.oneIn(3) ? numbers.share() : 0;
        mirrors |= !reflection.isZero();
        isGlassy |= transparency > 0;
        splits |= !reflection.isZero() && transparency > 0;
        Object[] ambient = isAmbient && numbers.oneIn(2) ? new Object[] {numbers.color()} : new Object[0];
        List<Object> values = new ArrayList<>(List.of(numbers.color(), numbers.color(), reflection,
            EXPONENTS[numbers.below(EXPONENTS.length)], transparency));
        values.addAll(List.of(ambient));
        line("mtl", values.toArray());
    }

    /** Some views cannot be: at the eye itself, or along up. */
    private void camera() {
        String before = text.toString();
        do {
            text.setLength(before.length());
            List<Object> values = new ArrayList<>(List.of(numbers.place(), numbers.place(), numbers.direction(),
                numbers.length(), numbers.length()));
            if (numbers.oneIn(3)) {
                values.set(4, values.get(3));
            }
            if (numbers.oneIn(3)) {
                values.add(true);
                values.add(new double[] {-1, -0.5, -1e-300, 0, 1e-9, 0.5, 1}[numbers.below(7)]);
            }
            line("cam", values.toArray());
        } while (!isScene(text + "set 0 0 0 1 0"));
    }

    private static boolean isScene(String text) {
        try {
            SceneParser.parse("", text.getBytes(StandardCharsets.UTF_8), ForkJoin.sequential());
            return true;
        } catch (RayTracerException refused) {
            return false;
        }
    }

    private void writeLight() {
        line("lgt", numbers.place(), numbers.color(), numbers.factor(), numbers.share(),
            numbers.oneIn(4) ? 0 : numbers.length());
    }

    private void writeSurfaces(int materials) {
        String last = "";
        boolean oneKind = numbers.oneIn(2);
        boolean areTrianglesQuick = numbers.isOrdinary() || !splits && !isAmbient;  // else each is asked a million times
        int kinds = areTrianglesQuick ? 4 : 3;
        int kind = numbers.below(kinds);
        for (int i = 0; i < surfaces; i++) {
            int material = 1 + numbers.below(materials);
            if (i > 0 && numbers.oneIn(8)) {
                text.append(last).append(material).append('\n');
                continue;
            }
            int before = text.length();
            writeSurface(oneKind ? kind : numbers.below(kinds), material);
            last = text.substring(before, text.lastIndexOf(" ") + 1);
        }
    }

    /** A plane goes through a place, as nearly as doubles can say it. */
    private void writeSurface(int kind, int material) {
        Vector place = numbers.place();
        if (kind == 0) {
            line("sph", place, numbers.length(), material);
        } else if (kind == 1) {
            line("box", place, numbers.length(), material);
        } else if (kind == 3) {
            writeTriangle(material);
        } else {
            Vector normal = numbers.direction();
            double offset = normal.dot(place);
            line("pln", normal, NastyNumbers.finite(Double.isNaN(offset) ? 0 : offset), material);
        }
    }

    /** Places may be on one line, or the same; others are tried then. */
    private void writeTriangle(int material) {
        Vector a;
        Vector b;
        Vector c;
        do {
            a = numbers.place();
            b = numbers.place();
            c = numbers.place();
        } while (Triangle.areOnALine(a, b, c));
        line("trg", a, b, c, material);
    }

    private int triangles() {
        return (int) text.toString().lines().filter(line -> line.startsWith("trg")).count();
    }

    private void writeSettings(int lights) {
        int recursion = RECURSIONS[numbers.below(RECURSIONS.length)];
        double met = (splits ? SURFACES_MET_IN_A_HALL : 1) * (mirrors ? 1 + Math.min(64, recursion) : 1);
        double most = numbers.isOrdinary() ? MOST_ORDINARY_QUESTIONS : MOST_QUESTIONS;
        double asked = numbers.isOrdinary() ? surfaces : surfaces + TRIANGLE * triangles() * (isGlassy ? surfaces : 1.0);
        int wanted = numbers.below(ROOTS.length);
        while (wanted > 0 && PIXELS * met * lights * asked * ROOTS[wanted] * ROOTS[wanted] > most) {
            wanted--;
        }
        List<Object> values = new ArrayList<>(List.of(numbers.color(), ROOTS[wanted], recursion));
        if (numbers.oneIn(3)) {
            values.add(numbers.factor());
        }
        line("set", values.toArray());
    }
}
