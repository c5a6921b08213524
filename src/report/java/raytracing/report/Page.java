package raytracing.report;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import raytracing.Machine;
import raytracing.MeasuredPart;
import raytracing.render.RenderSettings;

/** The report as one file that needs no other. */
final class Page {
    private static final Path NUMERICS = Path.of("src", "docs", "NUMERICS.md");

    private final Request request;
    private final List<SceneStudy> studies;
    private final MachineLoad load;

    Page(Request request, List<SceneStudy> studies, MachineLoad load) {
        this.load = load;
        this.request = request;
        this.studies = studies;
    }

    String html() throws IOException {
        return """
            <!DOCTYPE html>
            <html lang="en">
            <head>
            <meta charset="utf-8">
            <meta name="viewport" content="width=device-width, initial-scale=1">
            <meta name="color-scheme" content="light dark">
            <title>Speed against error</title>
            <style>
            """ + style() + "</style>\n</head>\n<body>\n<main>\n" + heading() + overview() + scenes() + speedUps()
            + (studies.size() > 1 ? crossings() : "") + definitions() + "</main>\n</body>\n</html>\n";
    }

    private static String style() throws IOException {
        try (InputStream style = Page.class.getResourceAsStream("page.css")) {
            return new String(style.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    private String heading() throws IOException {
        return "<header>\n<h1>Speed against error</h1>\n"
            + Headline.of(studies).stream().map(sentence -> "<p class=\"lead\">" + Markdown.inline(sentence) + "</p>\n")
                .collect(Collectors.joining())
            + "<dl class=\"facts\">\n" + fact("Command", "<code>" + Html.escaped(request.command()) + "</code>")
            + fact("Machine and program", Html.escaped(Machine.facts()) + " Date of the commit: "
                + Machine.commitDate() + ".")
            + fact("How busy it was", load.sentences() + " " + noise())
            + fact("Pictures", request.budget().size() + " x " + request.budget().size() + " pixels, seed "
                + RenderSettings.DEFAULT_SEED + ", " + RenderSettings.DEFAULT.threads() + " threads")
            + fact("Scenes", studies.stream().map(study -> "<a href=\"#" + anchor(study) + "\">"
                + Html.escaped(study.title()) + "</a>").collect(Collectors.joining(", ")))
            + "</dl>\n</header>\n";
    }

    private String noise() {
        int all = studies.stream().flatMap(study -> study.families().stream())
            .mapToInt(family -> family.measurements().size()).sum();
        int noisy = studies.stream().flatMap(study -> study.families().stream())
            .mapToInt(family -> family.noisy().size()).sum();
        return noisy + " of " + all + " times look like noise, after a second try, and are marked †.";
    }

    private static String fact(String name, String html) {
        return "<div><dt>" + name + "</dt><dd>" + html + "</dd></div>\n";
    }

    private static String anchor(SceneStudy study) {
        return Html.escaped("scene-" + study.title());
    }

    private String overview() {
        String shadows = studies.stream().anyMatch(study -> study.family(Family.SHADOWS).isPresent())
            ? Tables.shadows(studies).html() : "";
        return "<section class=\"overview\">\n<h2>Time at equal error</h2>\n" + Texts.TIME_AT_EQUAL_ERROR + shadows
            + Tables.edges(studies).html() + "</section>\n";
    }

    private String scenes() throws IOException {
        StringBuilder html = new StringBuilder();
        for (SceneStudy study : studies) {
            html.append(new SceneSection(study, anchor(study)).html());
        }
        return html.toString();
    }

    private String speedUps() {
        return "<section class=\"tables\">\n<h2>Speed-ups, with and without</h2>\n" + Texts.SPEED_UPS
            + Tables.sampledSpeedUps(studies).html() + Tables.exactSpeedUps(studies).html()
            + "<h2>Cold starts</h2>\n" + Texts.COLD + Tables.cold(studies).html() + "</section>\n";
    }

    private static String crossings() throws IOException {
        return "<section class=\"tables crossings\">\n<h2>The crossing formulas</h2>\n" + Texts.CROSSINGS
            + Markdown.html(MeasuredPart.of(NUMERICS)) + "</section>\n";
    }

    private static String definitions() {
        return "<section class=\"definitions\">\n<h2>What the figures are</h2>\n" + Texts.DEFINITIONS + "</section>\n";
    }
}
