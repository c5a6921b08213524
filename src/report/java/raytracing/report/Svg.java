package raytracing.report;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A vector graphic as the plotting library wrote it.
 *
 * @param text a whole SVG file
 */
record Svg(String text) {
    private static final Pattern PROLOGUE = Pattern.compile("^.*?(?=<svg )", Pattern.DOTALL);
    private static final Pattern SIZE = Pattern.compile(" (width|height|x|y)=\"[0-9.]+px\"");
    private static final Pattern LONG_NUMBER = Pattern.compile("-?\\d+\\.\\d{2,}");
    private static final Pattern CLIP = Pattern.compile("clip-?\\d+");
    private static final Pattern SPACE = Pattern.compile(">\\s+<");
    private static final Pattern OPENING = Pattern.compile("<svg [^>]*>");

    /** Without what repeats itself and without digits that nobody sees. */
    private String tidied() {
        String bare = SPACE.matcher(SIZE.matcher(PROLOGUE.matcher(text).replaceFirst("")).replaceAll(""))
            .replaceAll("><");
        return LONG_NUMBER.matcher(bare).replaceAll(match -> rounded(match.group()));
    }

    private static String rounded(String number) {
        double tenths = Math.rint(Double.parseDouble(number) * 10) / 10;
        return tenths == Math.rint(tenths) ? String.valueOf((long) tenths) : String.valueOf(tenths);
    }

    /**
     * As a part of a page, in the colours of its style sheet.
     *
     * @param name unlike all others on the page
     * @param description for those who cannot see it
     */
    String inPage(String name, String description) {
        String named = CLIP.matcher(tidied()).replaceAll(name);
        for (Ink ink : Ink.values()) {
            named = named.replace(ink.svg(), ink.variable());
        }
        return OPENING.matcher(named).replaceFirst(match -> Matcher.quoteReplacement(
            match.group().replace("<svg ", "<svg role=\"img\" aria-label=\"" + Html.escaped(description) + "\" ")));
    }

    /** As a file of its own, on white: readable on every page. */
    String onWhite() {
        return OPENING.matcher(tidied()).replaceFirst(match -> Matcher.quoteReplacement(
            match.group() + "<rect width=\"100%\" height=\"100%\" style=\"fill:white\"/>")) + "\n";
    }
}
