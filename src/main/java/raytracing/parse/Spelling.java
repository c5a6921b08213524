package raytracing.parse;

import java.util.List;
import java.util.Optional;

/** Finds the word that was probably meant by a misspelt one. */
public final class Spelling {
    private Spelling() {
    }

    /**
     * The nearest word by single letters inserted, left out, replaced, or swapped with the next (Damerau, A technique for
     * computer detection and correction of spelling errors, 1964; no letter is changed twice); of several the first. None if
     * more than a third of it would have to change.
     *
     * @param words that may have been meant, more likely ones first
     */
    public static Optional<String> nearest(String word, List<String> words) {
        Optional<String> nearest = Optional.empty();
        int least = Integer.MAX_VALUE;
        for (String right : words) {
            int distance = distance(word, right);
            if (distance < least && distance <= right.length() / 3) {
                least = distance;
                nearest = Optional.of(right);
            }
        }
        return nearest;
    }

    /** Fills a table of the distances between all beginnings of two words. */
    private static int distance(String from, String to) {
        int[][] table = new int[from.length() + 1][to.length() + 1];
        for (int i = 0; i <= from.length(); i++) {
            for (int j = 0; j <= to.length(); j++) {
                table[i][j] = i == 0 || j == 0 ? i + j : least(table, from, to, i, j);
            }
        }
        return table[from.length()][to.length()];
    }

    private static int least(int[][] table, String from, String to, int i, int j) {
        boolean same = from.charAt(i - 1) == to.charAt(j - 1);
        int replaced = table[i - 1][j - 1] + (same ? 0 : 1);
        int least = Math.min(replaced, 1 + Math.min(table[i - 1][j], table[i][j - 1]));
        boolean swapped = i > 1 && j > 1 && from.charAt(i - 1) == to.charAt(j - 2) && from.charAt(i - 2) == to.charAt(j - 1);
        return swapped ? Math.min(least, table[i - 2][j - 2] + 1) : least;
    }
}
