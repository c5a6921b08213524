package raytracing.program;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import raytracing.film.ImageFormat;

/** Guesses what names and sizes were meant where those that were given are no command. */
final class Rearranged {
    /** One side, where a comma may follow, or both, such as 500x500; 500,500; 500*500. */
    private static final Pattern SIZE = Pattern.compile("([1-9]\\d{0,8})(?:[,;]?|[xX*,;:\u00d7/]([1-9]\\d{0,8}))");

    private Rearranged() {
    }

    /**
     * The words in the order of a command: scene, output, and none or two sizes. Empty if they cannot be found among the
     * operands, or are in this order already.
     */
    static Optional<String> of(List<String> operands) {
        List<String> names = new ArrayList<>();
        List<String> pictures = new ArrayList<>();
        List<String> sizes = new ArrayList<>();
        for (String word : operands) {
            Matcher size = SIZE.matcher(word);
            if (size.matches()) {
                sizes.add(size.group(1));
                if (size.group(2) != null) {
                    sizes.add(size.group(2));
                }
            } else if (ImageFormat.ofEnding(word).isPresent()) {
                pictures.add(word);
            } else if (!word.equals("0") && !word.equalsIgnoreCase("x")) {
                names.add(word);
            }
        }
        boolean isSideMissing = operands.contains("0") && sizes.size() < 2;
        if (names.size() != 1 || pictures.size() != 1 || isSideMissing) {
            return Optional.empty();
        }
        List<String> meant = new ArrayList<>(List.of(names.get(0), pictures.get(0)));
        if (!sizes.isEmpty()) {
            meant.add(sizes.get(0));
            meant.add(sizes.get(sizes.size() == 1 ? 0 : 1));
        }
        return meant.equals(operands) ? Optional.empty() : Optional.of(String.join(" ", meant));
    }
}
