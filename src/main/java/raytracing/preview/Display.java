package raytracing.preview;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.util.Optional;
import raytracing.render.Region;

/** Whether this Java can show pictures in a window here. */
final class Display {
    /** Larger pictures are not shown: this many pixels take 256 MB. */
    private static final long MOST_PIXELS = 1 << 26;

    /** Bytes of memory that a pixel needs: 4 to be shown, at most a quarter of all, since the drawing must not lack memory. */
    private static final int MEMORY_PER_PIXEL = 16;

    private static final String NONE = "no display to open a window on";

    private Display() {
    }

    /** Why a window cannot show some pictures of a region at once, and what to do about it; empty if it can. */
    static Optional<String> obstacle(Region region, int pictures) {
        if (region.pixelCount() > MOST_PIXELS) {
            return Optional.of("pictures of more than " + MOST_PIXELS + " pixels are not shown");
        }
        if (pictures * MEMORY_PER_PIXEL * region.pixelCount() > Runtime.getRuntime().maxMemory()) {
            return Optional.of("not enough memory to show so many pixels");
        }
        if (Boolean.getBoolean("java.awt.headless")) {
            return Optional.of("java.awt.headless=true forbids Java to open windows");
        }
        try {
            if (GraphicsEnvironment.isHeadless()) {
                return Optional.of(headless());
            }
            return GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0
                ? Optional.empty() : Optional.of(NONE);
        } catch (AWTError noReply) {
            return Optional.of(NONE + ", DISPLAY is " + System.getenv("DISPLAY") + " and cannot be reached");
        } catch (LinkageError missing) {
            return Optional.of("a library that this Java needs for windows is missing (" + missing.getMessage() + ")");
        }
    }

    /** Java calls itself headless if no display is named, but also if one is and its own library for windows is missing. */
    private static String headless() {
        String display = System.getenv("DISPLAY");
        return display == null || display.isBlank() ? NONE + ", DISPLAY is not set"
            : "this Java has no windows; on Debian and Ubuntu install openjdk-" + Runtime.version().feature()
                + "-jre, elsewhere a full JDK";
    }
}
