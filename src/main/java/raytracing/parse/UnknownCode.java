package raytracing.parse;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Says what was probably meant by a code that is none: by its spelling, or as other programs of the kind have it. */
final class UnknownCode {
    /** Each code, and the words that mean it. */
    private static final List<Meaning> CODES = List.of(
        new Meaning("cam", "cam", "camera", "eye", "view"),
        new Meaning("set", "set", "setting", "settings", "general"),
        new Meaning("mtl", "mtl", "mat", "material"),
        new Meaning("sph", "sph", "sphere", "ball"),
        new Meaning("pln", "pln", "plane", "plain"),
        new Meaning("box", "box", "boxes", "cub", "cube"),
        new Meaning("lgt", "lgt", "light", "lamp"));

    /** What no code makes, and the words that would mean it. */
    private static final List<Meaning> NOT_SUPPORTED = List.of(
        new Meaning("triangles", "trg", "tri", "triangle"),
        new Meaning("cylinders", "cyl", "cylinder"),
        new Meaning("ellipsoids", "elp", "ell", "ellipsoid"),
        new Meaning("cones", "con", "cone"),
        new Meaning("tori", "tor", "torus"),
        new Meaning("discs", "dsc", "disc", "disk"),
        new Meaning("rectangles", "rec", "rect", "rectangle", "quad"),
        new Meaning("polygons", "pol", "poly", "polygon"),
        new Meaning("models from other files", "obj", "ply", "stl", "mesh", "model"));

    private static final String EXPECTED_SURFACES = "expected sph, pln or box";
    private static final String EXPECTED_CODES = "expected cam, set, mtl, sph, pln, box or lgt";

    /** Shorter words are near to too many others: "res" is no misspelt "rec". */
    private static final int LONG_ENOUGH = 5;

    private record Meaning(String meant, List<String> words) {
        Meaning(String meant, String... words) {
            this(meant, List.of(words));
        }
    }

    private UnknownCode() {
    }

    /** What is wrong with the first word of a line. */
    static String message(String code) {
        if (Hint.isRemark(code)) {
            return "unknown code, remarks begin with #";
        }
        String word = letters(code);
        Optional<Meaning> unknown = meaning(word, NOT_SUPPORTED);
        if (unknown.isPresent()) {
            return unknown.get().meant + " are not supported, " + EXPECTED_SURFACES;
        }
        Optional<Meaning> known = meaning(word, CODES);
        return "unknown code" + Hint.aboutCode(code) + ", " + EXPECTED_CODES
            + (known.isPresent() ? ", did you mean " + known.get().meant + "?" : "");
    }

    /** As far as it consists of letters, or of what looks like them: a number may be glued to it. */
    private static String letters(String code) {
        return Hint.plain(code).toLowerCase(Locale.ROOT).replaceFirst("(?<=[a-z])[\\p{ASCII}&&[^a-z]].*", "");
    }

    private static Optional<Meaning> meaning(String word, List<Meaning> meanings) {
        List<String> words = new ArrayList<>();
        for (Meaning meaning : meanings) {
            for (String right : meaning.words) {
                if (right.equals(word) || meanings == CODES || right.length() >= LONG_ENOUGH) {
                    words.add(right);
                }
            }
        }
        return Spelling.nearest(word, words).flatMap(
            right -> meanings.stream().filter(meaning -> meaning.words.contains(right)).findFirst());
    }
}
