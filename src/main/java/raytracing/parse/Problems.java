package raytracing.parse;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Collects what is wrong with a scene file, so that its author can mend it all at once. */
final class Problems {
    private static final int MOST_LISTED = 20;

    /** Sorts after every line: what concerns the whole file comes last. */
    private static final int WHOLE_FILE = Integer.MAX_VALUE;

    private final String fileName;
    private final List<Problem> problems = new ArrayList<>();

    private record Problem(int line, String message) {
    }

    Problems(String fileName) {
        this.fileName = fileName;
    }

    void add(int line, String code, String message) {
        problems.add(new Problem(line, fileName + ":" + line + ": " + Printable.quote(code) + ": " + message));
    }

    /** Says what a value must be instead of what it is. */
    static String refusal(String name, String expected, String got) {
        return name + " must be " + expected + ", got " + Printable.quote(got);
    }

    void addForWholeFile(String code, String message) {
        problems.add(new Problem(WHOLE_FILE, fileName + ": " + code + ": " + message));
    }

    /** Throws if anything was added: the first messages in the order of the lines, and how many more there are. */
    void throwIfAny() throws RayTracerException {
        if (problems.isEmpty()) {
            return;
        }
        problems.sort(Comparator.comparingInt(Problem::line));
        List<String> messages = new ArrayList<>();
        for (Problem problem : problems.subList(0, Math.min(problems.size(), MOST_LISTED))) {
            messages.add(problem.message);
        }
        if (problems.size() > MOST_LISTED) {
            messages.add(fileName + ": and " + (problems.size() - MOST_LISTED) + " more");
        }
        throw new RayTracerException(messages);
    }
}
