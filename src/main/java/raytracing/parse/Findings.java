package raytracing.parse;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/**
 * What is said about a scene file: errors, so that its author can mend them all at once, or warnings. Keeps the first in
 * the order of the lines, counts the rest, and so needs as little memory for a million as for a few.
 */
final class Findings {
    /** Sorts after every line: what concerns the whole file comes last. */
    private static final int WHOLE_FILE = Integer.MAX_VALUE;

    private final String fileName;
    private final int mostListed;
    private final List<Finding> first = new ArrayList<>();
    private int count;

    private record Finding(int line, String text) {
    }

    Findings(String fileName, int mostListed) {
        this.fileName = fileName;
        this.mostListed = mostListed;
    }

    /** The text is only asked for if it will be listed. */
    void add(int line, Supplier<String> text) {
        if (hasRoomFor(line)) {
            add(line, text.get());
        } else {
            count++;
        }
    }

    void add(int line, String text) {
        if (hasRoomFor(line)) {
            insert(line, fileName + ":" + line + ": " + text);
        }
        count++;
    }

    void addForWholeFile(String text) {
        if (hasRoomFor(WHOLE_FILE)) {
            insert(WHOLE_FILE, fileName + ": " + text);
        }
        count++;
    }

    private boolean hasRoomFor(int line) {
        return first.size() < mostListed || line < first.get(mostListed - 1).line;
    }

    /** Behind all of the same line: what stands further right there was found later. */
    private void insert(int line, String text) {
        if (first.size() == mostListed) {
            first.remove(mostListed - 1);
        }
        int place = first.size();
        while (place > 0 && first.get(place - 1).line > line) {
            place--;
        }
        first.add(place, new Finding(line, text));
    }

    boolean isEmpty() {
        return count == 0;
    }

    /** A line of text for each, up to as many as may be listed, and one that counts the rest. */
    List<String> listed() {
        List<String> lines = new ArrayList<>();
        for (Finding finding : first) {
            lines.add(Printable.of(finding.text));
        }
        if (count > first.size()) {
            lines.add(Printable.of(fileName) + ": and " + (count - first.size()) + " more");
        }
        return lines;
    }
}
