package raytracing.parse;

import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Finds out what was probably meant by an unknown code, from its spelling or from the codes of similar programs. */
final class UnknownCode {
    /** Each code, and words for it. */
    private static final List<Meaning> CODES = List.of(
        new Meaning("cam", "cam", "camera", "eye", "view"),
        new Meaning("set", "set", "setting", "settings", "general"),
        new Meaning("mtl", "mtl", "mat", "material"),
        new Meaning("sph", "sph", "sphere", "ball"),
        new Meaning("pln", "pln", "plane", "plain"),
        new Meaning("box", "box", "boxes", "cub", "cube"),
        new Meaning("trg", "trg", "tri", "triangle", "triangles"),
        new Meaning("lgt", "lgt", "light", "lamp"));

    /** Things that have no code, and words for them. */
    private static final List<Meaning> NOT_SUPPORTED = List.of(
        new Meaning("cylinders", "cyl", "cylinder"),
        new Meaning("ellipsoids", "elp", "ell", "ellipsoid"),
        new Meaning("cones", "con", "cone"),
        new Meaning("tori", "tor", "torus"),
        new Meaning("discs", "dsc", "disc", "disk"),
        new Meaning("rectangles", "rec", "rect", "rectangle", "quad"),
        new Meaning("polygons", "pol", "poly", "polygon"),
        new Meaning("models from other files", "obj", "ply", "stl", "mesh", "model"));

    /** Shorter words are similar to too many others: "res" is no misspelt "rec". */
    private static final int LONG_ENOUGH = 5;

    private record Meaning(String meant, List<String> words) {
        Meaning(String meant, String... words) {
            this(meant, List.of(words));
        }
    }

    private UnknownCode() {
    }

    /** The message about the first word of a line. */
    static String message(String code) {
        if (Hint.isRemark(code)) {
            return "unknown code, remarks begin with #";
        }
        String word = letters(code);
        Optional<String> unsupported = meaning(word, NOT_SUPPORTED);
        if (unsupported.isPresent()) {
            return unsupported.get() + " are not supported, expected sph, pln, box or trg";
        }
        return "unknown code" + Hint.aboutCode(code) + ", expected cam, set, mtl, sph, pln, box, trg or lgt"
            + meaning(word, CODES).map(known -> ", did you mean " + known + "?").orElse("");
    }

    /** The letters, or characters that look like letters, at the start of a word; a number may follow them. */
    private static String letters(String code) {
        return Hint.plain(code).toLowerCase(Locale.ROOT).replaceFirst("(?<=[a-z])[\\p{ASCII}&&[^a-z]].*", "");
    }

    private static Optional<String> meaning(String word, List<Meaning> meanings) {
        List<String> words = meanings.stream().flatMap(meaning -> meaning.words.stream())
            .filter(right -> right.equals(word) || meanings == CODES || right.length() >= LONG_ENOUGH).toList();
        return Spelling.nearest(word, words).flatMap(right ->
            meanings.stream().filter(meaning -> meaning.words.contains(right)).map(Meaning::meant).findFirst());
    }
}
