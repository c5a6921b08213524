package raytracing.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import raytracing.film.ImageFormat;

/** Names and sizes as they were probably meant, where those that were given are no command. */
final class Rearranged {
    /** A comma may stand behind the first of two. */
    private static final Pattern SIZE = Pattern.compile("([1-9]\\d{0,8})[,;]?");

    /** 500x500, 500,500, 500*500. */
    private static final Pattern TWO_SIZES = Pattern.compile("([1-9]\\d{0,8})[xX*,;:\u00d7/]([1-9]\\d{0,8})");

    private Rearranged() {
    }

    /**
     * The same words in the order of a command.
     *
     * @param operands as the user gave them
     * @return scene, output, and none or two sizes; none if they are not to be found, or are in this order already
     */
    static Optional<String> of(List<String> operands) {
        List<String> names = new ArrayList<>();
        List<String> pictures = new ArrayList<>();
        List<String> sizes = new ArrayList<>();
        boolean hasZero = false;
        for (String word : operands) {
            Matcher one = SIZE.matcher(word);
            Matcher two = TWO_SIZES.matcher(word);
            if (one.matches()) {
                sizes.add(one.group(1));
            } else if (two.matches()) {
                sizes.addAll(List.of(two.group(1), two.group(2)));
            } else if (ImageFormat.ofEnding(word).isPresent()) {
                pictures.add(word);
            } else if (word.equals("0")) {
                hasZero = true;
            } else if (!word.equalsIgnoreCase("x")) {
                names.add(word);
            }
        }
        boolean isSideMissing = hasZero && sizes.size() < 2;
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
