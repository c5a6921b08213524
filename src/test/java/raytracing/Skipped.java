package raytracing;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/** Tests that need what is not on every machine are skipped without it, which a line on standard error says once. */
public final class Skipped {
    private static final Set<String> SAID = ConcurrentHashMap.newKeySet();

    private Skipped() {
    }

    /** Skips the test that asks, unless what it needs is there. */
    public static void unless(boolean isThere, String reason) {
        if (!isThere && SAID.add(reason)) {
            System.err.println("SKIPPED: " + reason);
        }
        assumeTrue(isThere, reason);
    }
}
