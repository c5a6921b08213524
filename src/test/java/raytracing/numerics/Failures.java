package raytracing.numerics;

import static org.junit.jupiter.api.Assertions.fail;

import java.util.List;
import java.util.stream.Stream;

/** One assertion for many rows, so that a broken kernel is reported in a screenful. */
final class Failures {
    private static final int SHOWN = 8;

    private Failures() {
    }

    static void assertNone(Stream<String> failures) {
        List<String> all = failures.toList();
        if (!all.isEmpty()) {
            fail(all.size() + " failures:\n" + String.join("\n", all.subList(0, Math.min(SHOWN, all.size()))));
        }
    }
}
