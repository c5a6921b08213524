package raytracing.watch;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Standard error, which may be a person's terminal or somebody's file. */
final class Terminal {
    private static final Path STANDARD_ERROR = Path.of("/proc/self/fd/2");

    private Terminal() {
    }

    /**
     * Whether a person reads standard error as it is written. Where the system does not say, as on all but Linux, the
     * program's other two streams stand for it.
     */
    static boolean isThere() {
        try {
            String device = Files.readSymbolicLink(STANDARD_ERROR).toString();
            return device.startsWith("/dev/pts/") || device.startsWith("/dev/tty") || device.equals("/dev/console");
        } catch (IOException | UnsupportedOperationException notLinux) {
            return System.console() != null;
        }
    }
}
