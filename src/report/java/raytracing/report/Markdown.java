package raytracing.report;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The little of Markdown that programs write here: headings, paragraphs, lists, tables and code in a line. */
final class Markdown {
    private static final Pattern BLANK_LINES = Pattern.compile("\\n\\s*\\n");
    private static final Pattern CODE = Pattern.compile("`([^`]*)`");
    private static final String HEADING = "### ";
    private static final String ITEM = "- ";
    private static final String CELL = "|";

    private Markdown() {
    }

    static String html(String text) {
        return BLANK_LINES.splitAsStream(text.strip()).map(block -> block(block.lines().toList()))
            .collect(Collectors.joining());
    }

    private static String block(List<String> lines) {
        String first = lines.get(0);
        if (first.startsWith(HEADING)) {
            return "<h3>" + inline(first.substring(HEADING.length())) + "</h3>\n";
        }
        if (first.startsWith(CELL)) {
            return table(lines);
        }
        return first.startsWith(ITEM) ? list(lines) : "<p>" + inline(String.join(" ", lines)) + "</p>\n";
    }

    private static String list(List<String> lines) {
        return lines.stream().map(line -> "<li>" + inline(line.substring(ITEM.length())) + "</li>\n")
            .collect(Collectors.joining("", "<ul>\n", "</ul>\n"));
    }

    /** The second line of a table only says how its columns are set. */
    private static String table(List<String> lines) {
        List<List<String>> rows = new ArrayList<>(lines.stream().map(Markdown::cells).toList());
        List<String> heads = rows.remove(0);
        rows.remove(0);
        return new Table("", heads, rows).html().replace("<caption><span></span></caption>", "");
    }

    private static List<String> cells(String line) {
        String[] cells = line.split("\\|");
        return Stream.of(cells).skip(1).map(cell -> cell.strip().replace("-/+", "±")).toList();
    }

    /** A line or a paragraph. */
    static String inline(String text) {
        return CODE.matcher(Html.escaped(text)).replaceAll("<code>$1</code>").replace("-/+", "±");
    }
}
