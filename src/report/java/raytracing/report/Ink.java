package raytracing.report;

import java.awt.Color;
import java.util.Locale;

/**
 * What plots are drawn with, on white paper. A page with a dark theme puts its own in their places, by name. Blue,
 * vermilion and green are of the set of Okabe and Ito (Color Universal Design, 2008), which the colour-blind can tell apart.
 */
enum Ink {
    TEXT(0x33383d), FRAME(0x8c9196), GRID(0xe4e6e8), FRONT(0xc3c8cc),
    BLUE(0x0072b2), VERMILION(0xd55e00), PURPLE(0xb0578d), GREEN(0x009e73);

    private final Color color;

    Ink(int color) {
        this.color = new Color(color);
    }

    Color color() {
        return color;
    }

    /** As an SVG file has it. */
    String svg() {
        return "rgb(" + color.getRed() + "," + color.getGreen() + "," + color.getBlue() + ")";
    }

    /** As a page's style sheet may set it. */
    String variable() {
        return "var(--" + name().toLowerCase(Locale.ROOT) + ")";
    }
}
