package raytracing;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/** Skips tests that need what is not on every machine. A line on standard error says so once. */
public final class Skipped {
    private static final Set<String> SAID = ConcurrentHashMap.newKeySet();

    private Skipped() {
    }

    /** Skips the calling test if what it needs is missing. */
    public static void unless(boolean isThere, String reason) {
        if (!isThere && SAID.add(reason)) {
            System.err.println("SKIPPED: " + reason);
        }
        assumeTrue(isThere, reason);
    }
}
