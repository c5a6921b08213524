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
        return "<table><caption>" + Html.escaped(caption) + "</caption><thead>"
            + row("<th scope=\"col\">", "</th>", "th", heads) + "</thead><tbody>\n"
            + rows.stream().map(cells -> row("<th scope=\"row\">", "</th>", "td", cells)).collect(Collectors.joining())
            + "</tbody></table>\n";
    }

    private static String row(String begin, String end, String tag, List<String> cells) {
        return "<tr>" + begin + Html.escaped(cells.get(0)) + end
            + cells.subList(1, cells.size()).stream()
                .map(cell -> "<" + tag + ">" + Html.escaped(cell) + "</" + tag + ">").collect(Collectors.joining())
            + "</tr>\n";
    }

    String markdown() {
        return caption + "\n\n" + MarkdownTable.of(heads, rows);
    }
}
