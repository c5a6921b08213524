package raytracing.parse;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/**
 * The errors in a scene file, so that its author can correct them all at once, or the warnings. It keeps the first ones in
 * the order of the lines and counts the others, so a million need as little memory as a few.
 */
final class Findings {
    /** The line of findings about the whole file, which are listed last. */
    static final int WHOLE_FILE = Integer.MAX_VALUE;

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

    /** Adds a finding, whose text is only made if it will be listed. */
    void add(int line, Supplier<String> text) {
        add(line, isListed(line) ? text.get() : "");
    }

    /** Adds a finding after all others of the same line, as those were found further left. */
    void add(int line, String text) {
        if (isListed(line)) {
            if (first.size() == mostListed) {
                first.remove(mostListed - 1);
            }
            int index = first.size();
            while (index > 0 && first.get(index - 1).line > line) {
                index--;
            }
            first.add(index, new Finding(line, fileName + (line == WHOLE_FILE ? "" : ":" + line) + ": " + text));
        }
        count++;
    }

    private boolean isListed(int line) {
        return first.size() < mostListed || line < first.get(mostListed - 1).line;
    }

    boolean isEmpty() {
        return count == 0;
    }

    /** A line of text for each, up to the most that are listed, and one with the number of the others. */
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
