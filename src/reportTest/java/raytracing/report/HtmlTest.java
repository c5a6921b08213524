package raytracing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class HtmlTest {
    @Test
    void textMeansItself() {
        assertEquals("a &lt;b&gt; &amp;amp; &quot;c&quot;", Html.escaped("a <b> &amp; \"c\""));
    }

    @Test
    void aTableKeepsItsOrderAndEscapesItsCells() {
        String html = new Table("x < y", List.of("name", "figure"), List.of(List.of("a", "> 1"))).html();
        assertTrue(html.contains("<caption><span>x &lt; y</span></caption>"), html);
        assertTrue(html.contains("<th scope=\"row\">a</th><td>&gt; 1</td>"), html);
    }

    @Test
    void codeInATableLooksLikeCode() {
        assertTrue(new Table("", List.of("asked"), List.of(List.of("`--error 1`"))).html()
            .contains("<th scope=\"row\"><code>--error 1</code></th>"));
    }

    @Test
    void aTableIsAlsoMarkdown() {
        assertEquals("of\n\n| name | figure |\n|---|---:|\n| a | 1 |\n",
            new Table("of", List.of("name", "figure"), List.of(List.of("a", "1"))).markdown());
    }

    @Test
    void theMarkdownOfProgramsBecomesHtml() {
        assertEquals("<h3>Ball</h3>\n<p>One <code>a &lt; b</code> two</p>\n"
            + "<ul>\n<li>first</li>\n<li>2 ± 1</li>\n</ul>\n",
            Markdown.html("### Ball\n\nOne `a < b`\ntwo\n\n- first\n- 2 -/+ 1\n"));
    }

    @Test
    void aTableOfMarkdownKeepsItsEmptyHead() {
        String html = Markdown.html("|  | ours |\n|---|---:|\n| far away | 4.1 -/+ 0.1 |\n");
        assertTrue(html.contains("<th scope=\"col\"></th><th>ours</th>"), html);
        assertTrue(html.contains("<th scope=\"row\">far away</th><td>4.1 ± 0.1</td>"), html);
    }

    @Test
    void aGraphicInAPageTakesItsColoursFromThere() {
        Svg svg = new Svg("<?xml version=\"1.0\"?>\n<svg width=\"9px\" viewBox=\"0 0 9 9\">\n"
            + "<g clip-path=\"url(#clip12)\"/> <path style=\"fill:rgb(0,114,178)\" d=\"M1.2345,-2.04\"/></svg>");
        assertEquals("<svg role=\"img\" aria-label=\"a &lt; b\" viewBox=\"0 0 9 9\"><g clip-path=\"url(#plot)\"/>"
            + "<path style=\"fill:var(--blue)\" d=\"M1.2,-2\"/></svg>", svg.inPage("plot", "a < b").strip());
    }
}
