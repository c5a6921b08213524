package raytracing.watch;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.util.Optional;

/** Whether this Java can open a window here. */
final class Display {
    private static final String NONE = "no display to open a window on";

    private Display() {
    }

    /** Why it cannot, with what to do about it; none if it can. */
    static Optional<String> obstacle() {
        if (Boolean.getBoolean("java.awt.headless")) {
            return Optional.of("java.awt.headless=true forbids Java to open windows");
        }
        try {
            return GraphicsEnvironment.isHeadless() ? Optional.of(headless(System.getenv("DISPLAY"))) : unreachable();
        } catch (LinkageError missing) {
            return Optional.of("a library that this Java needs for windows is missing (" + missing.getMessage() + ")");
        }
    }

    /** Java calls itself headless if no display is named, but also if one is and its own library for windows is missing. */
    private static String headless(String display) {
        if (display == null || display.isBlank()) {
            return NONE + ", DISPLAY is not set";
        }
        String version = System.getProperty("java.specification.version");
        return "this Java has no windows; on Debian and Ubuntu install openjdk-" + version + "-jre, elsewhere a full JDK";
    }

    private static Optional<String> unreachable() {
        try {
            return GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0
                ? Optional.empty() : Optional.of(NONE);
        } catch (AWTError noAnswer) {
            return Optional.of(NONE + ", DISPLAY is " + System.getenv("DISPLAY") + " and cannot be reached");
        }
    }
}
