package raytracing.nasty;

import java.util.ArrayList;
import java.util.List;

/**
 * Ordinary scenes but for one or two numbers of one line, which are at the ends of the range of doubles.
 */
final class RangeEnds {
    private static final double[] SIZES = {4.9e-324, 1e-310, 2.2e-308, 1e-300, 1e-160, 1, 1e160, 1e300, 1.7e308};

    private static final List<String> ORDINARY = List.of(
        "set 0.2 0.3 0.4  2 2",
        "mtl 0.5 0.4 0.3  0.3 0.2 0.1  0.2 0.3 0.4  10 0.25",
        "mtl 0.5 0.4 0.3  0 0 0  0 0 0  1 0",
        "cam 0.1 0.2 -5  0.3 0.4 0.2  0 1 0  1 1.5",
        "sph -0.5 0.1 0.3  0.7 1",
        "pln 0.1 1 0.2  -1 2",
        "box 0.6 0.1 0.2  0.8 1",
        "trg -0.9 -0.6 0.4  0.8 -0.5 -0.8  0.2 0.9 0.1  1",
        "lgt 2 3 -4  1 0.9 0.8  0.8 0.9 0.5");

    private RangeEnds() {
    }

    /**
     * All scenes in which one number of a line, or two, are at the ends of the range. The parser refuses some of them, as where
     * the camera would look at itself.
     *
     * @param line takes the place of the first line with its code
     * @param kinds of its words, a character each, as {@link #ends} reads them
     */
    static List<String> scenes(String line, String kinds) {
        List<String> scenes = new ArrayList<>();
        String[] words = line.split(" ");
        for (int i = 1; i < words.length; i++) {
            for (double end : ends(kinds.charAt(i))) {
                String[] one = with(words, i, end);
                scenes.add(scene(one));
                for (int j = i + 1; j < words.length; j++) {
                    for (double other : ends(kinds.charAt(j))) {
                        scenes.add(scene(with(one, j, other)));
                    }
                }
            }
        }
        return scenes;
    }

    /** Numbers to try: of any sign (s), from 0 on (0), above 0 (+), from 0 to 1 (1), from -1 to 1 (k); none (.). */
    private static List<Double> ends(char kind) {
        List<Double> ends = new ArrayList<>();
        if (kind == '.') {
            return ends;
        }
        if (kind != '+') {
            ends.add(0.0);
        }
        boolean isUpTo1 = kind == '1' || kind == 'k';
        for (double size : SIZES) {
            if (size <= 1 || !isUpTo1) {
                ends.add(size);
            }
            if (kind == 's' || size <= 1 && kind == 'k') {
                ends.add(-size);
            }
        }
        return ends;
    }

    private static String[] with(String[] words, int i, double number) {
        String[] changed = words.clone();
        changed[i] = Double.toString(number);
        return changed;
    }

    private static String scene(String[] words) {
        List<String> lines = new ArrayList<>(ORDINARY);
        for (int i = 0; i < lines.size(); i++) {
            if (lines.get(i).startsWith(words[0])) {
                lines.set(i, String.join(" ", words));
                return String.join("\n", lines);
            }
        }
        throw new IllegalArgumentException("no such line: " + words[0]);
    }
}
