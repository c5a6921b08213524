package raytracing.report;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.Locale;
import java.util.Optional;
import raytracing.ambient.AmbientLight;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.render.Region;

/** The part of the page about one scene. */
final class SceneSection {
    private static final int LEGEND_WIDTH = 200;
    private static final int LEGEND_HEIGHT = 12;

    private final SceneStudy study;
    private final String anchor;

    SceneSection(SceneStudy study, String anchor) {
        this.study = study;
        this.anchor = anchor;
    }

    String html() throws IOException {
        StringBuilder html = new StringBuilder("<section class=\"scene\" id=\"" + anchor + "\">\n");
        if (study.family(Family.SHADOWS).isEmpty()) {
            html.append(heading(": soft shadows")).append(Texts.HARD_SHADOWS);
        }
        html.append(ambience());
        for (FamilyStudy family : study.families()) {
            html.append(family(family));
        }
        return html.append("</section>\n").toString();
    }

    /** The estimate, of a scene that asks for one. */
    private String ambience() {
        AmbientLight light = study.ambientLight();
        Color mean = light.mean();
        return light.isNone() ? "" : "<p>" + Html.escaped(String.format(Locale.ROOT,
            "Ambient light of %s, estimated from the room at %d places: in the mean red %.3f, green %.3f, blue %.3f.",
            study.title(), light.recordCount(), mean.red(), mean.green(), mean.blue())) + "</p>\n";
    }

    private String heading(String rest) {
        return "<h2>" + Html.escaped(study.title() + rest) + "</h2>\n";
    }

    private String family(FamilyStudy family) throws IOException {
        String sentences = Verdict.of(family).sentences() + " " + referenceSentence(family);
        return "<article>\n" + heading(": " + family.family().title().toLowerCase(Locale.ROOT))
            + "<p class=\"answer\">" + Markdown.inline(Recommendation.of(family).sentences(study.shadowRoot()))
            + "</p>\n<p>" + Markdown.inline(sentences) + "</p>\n<div class=\"figures\">\n" + plot(family)
            + Tables.settings(family).html() + "</div>\n" + pictures(family) + "</article>\n";
    }

    private static String referenceSentence(FamilyStudy family) {
        Reference reference = family.reference();
        return "The reference's own error is about " + Shown.error(reference.ownError()) + "."
            + (reference.whole().isPresent() ? "" : " It has " + reference.pixels() + " pixels, in "
                + reference.blocks().size() + " squares spread over the picture.");
    }

    private String plot(FamilyStudy family) throws IOException {
        if (!family.hasErrors()) {
            return "";
        }
        String name = anchor + "-" + family.family().name().toLowerCase(Locale.ROOT);
        return "<div class=\"plot\">" + Plot.of(family).inPage(name, "Error against time, on logarithmic axes: "
            + "the table beside it has all points.") + "</div>\n";
    }

    private String pictures(FamilyStudy family) throws IOException {
        Optional<Film> reference = family.reference().whole();
        StringBuilder html = new StringBuilder("<div class=\"pictures\">\n");
        if (reference.isPresent()) {
            html.append(referenceFigure(reference.orElseThrow()));
        }
        for (Measurement measurement : PictureRow.of(family)) {
            String title = measurement.setting().title();
            TimedError figures = family.figures(measurement);
            html.append("<figure>")
                .append(illustration(measurement.illustration().orElseThrow(), title))
                .append("<figcaption>").append(Html.escaped(title)).append("<br>")
                .append(Html.escaped(Shown.duration(figures.milliseconds()) + ", " + Shown.error(figures.error())))
                .append("</figcaption></figure>\n");
        }
        return html.append("</div>\n").toString();
    }

    /** The picture with a frame around its worst place, its errors if they are known, and that place magnified. */
    private String illustration(Illustration illustration, String title) throws IOException {
        Closeup closeup = illustration.closeup();
        String map = illustration.errorMap().isEmpty() ? ""
            : map(illustration.errorMap().orElseThrow(), "errors of " + title);
        return "<div class=\"framed\">" + picture(illustration.picture(), title)
            + frame(closeup.place(), illustration.pictureSize()) + "</div>" + map
            + "<div class=\"closeups\">" + picture(closeup.found().toImage(), title + ", where it is worst")
            + picture(closeup.aim().toImage(), "the reference there") + "</div>";
    }

    /** Where a close-up lies in the picture below it: in shares of that, whatever its size on the page is. */
    static String frame(Region place, int pictureSize) {
        double percent = 100.0 / pictureSize;
        return String.format(Locale.ROOT, "<span style=\"left:%.2f%%;top:%.2f%%;width:%.2f%%;height:%.2f%%\"></span>",
            place.left() * percent, place.top() * percent, place.width() * percent, place.height() * percent);
    }

    private String picture(BufferedImage picture, String title) throws IOException {
        return Html.picture(picture, study.title() + ", " + title);
    }

    /** A page with a dark theme turns its brightness round. */
    private static String map(BufferedImage map, String description) throws IOException {
        return Html.picture(map, description).replace("<img ", "<img class=\"map\" ");
    }

    /** Where the others have their errors, the reference has their scale. */
    private String referenceFigure(Film reference) throws IOException {
        return "<figure>" + picture(reference.toImage(), "reference")
            + "<div class=\"legend\"><div>" + map(ColorScale.legend(LEGEND_WIDTH, LEGEND_HEIGHT),
                "colours of the error maps")
            + "<div class=\"ticks\"><span>0.0001</span><span>0.01</span><span>1</span></div>"
            + "<p>absolute error in linear light, worst channel</p></div></div>"
            + "<figcaption>reference<br>and colours of the errors</figcaption></figure>\n";
    }
}
