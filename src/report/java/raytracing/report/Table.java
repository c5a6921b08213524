package raytracing.report;

import java.util.List;
import java.util.stream.Collectors;
import raytracing.MarkdownTable;

/**
 * A table of plain text, for a page or a document.
 *
 * @param caption what it shows
 * @param heads of the columns; the first one has the names of the rows, the others have figures
 * @param rows as many cells as heads
 */
record Table(String caption, List<String> heads, List<List<String>> rows) {
    String html() {
        return "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"" + Html.escaped(label()) + "\">"
            + "<table><caption><span>" + Markdown.inline(caption) + "</span></caption><thead>"
            + row("<th scope=\"col\">", "</th>", "th", heads) + "</thead><tbody>\n"
            + rows.stream().map(cells -> row("<th scope=\"row\">", "</th>", "td", cells)).collect(Collectors.joining())
            + "</tbody></table></div>\n";
    }

    /** For those who reach the scrolling part with the keyboard and cannot see it. */
    private String label() {
        return caption.isEmpty() ? "table" : "table: " + caption.replaceFirst("[.:] .*", "");
    }

    private static String row(String begin, String end, String tag, List<String> cells) {
        return "<tr>" + begin + Markdown.inline(cells.get(0)) + end
            + cells.subList(1, cells.size()).stream()
                .map(cell -> "<" + tag + ">" + Markdown.inline(cell) + "</" + tag + ">").collect(Collectors.joining())
            + "</tr>\n";
    }

    String markdown() {
        return caption + "\n\n" + MarkdownTable.of(heads, rows);
    }
}
