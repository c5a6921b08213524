package raytracing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static raytracing.report.Studies.measured;

import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import raytracing.Quantiles;
import raytracing.ambient.AmbientLight;
import raytracing.film.Film;
import raytracing.parallel.ForkJoin;
import raytracing.parse.SceneParser;
import raytracing.scene.Scene;
import raytracing.timed.Spread;

class PageTest {
    private static final int SIZE = 40;
    private static final MachineLoad LOAD = new MachineLoad(OptionalDouble.of(0), OptionalDouble.of(2), 2);
    private static final Pattern TAG = Pattern.compile("<(/?)([a-z0-9]+)((?: [^<>\"]*(?:\"[^\"]*\")?)*)(/?)>");
    private static final Set<String> WITHOUT_END = Set.of("meta", "img", "br");

    private static Measurement shown(Setting setting, double milliseconds, double error, Reference reference) {
        Measurement measurement = measured(setting, milliseconds, error);
        return new Measurement(setting, 0.1, measurement.milliseconds(), measurement.error(),
            Optional.of(Illustration.of(Pictures.even(SIZE, 0.5 + error), reference, SIZE)));
    }

    private static SceneStudy study(String title) throws Exception {
        Scene scene = SceneParser.parse("made", """
            cam 0 0 -5  0 0 0  0 1 0  1 1
            set 0 0 0  4 1
            mtl 1 1 1  0 0 0  0 0 0  1 0
            sph 0 0 0  1  1
            lgt 0 9 0  1 1 1  1 1 2
            """.getBytes(StandardCharsets.UTF_8), ForkJoin.sequential()).scene();
        Film grey = Pictures.even(SIZE, 0.5);
        Reference reference = Reference.of(grey, grey, 1000);
        FamilyStudy shadows = new FamilyStudy(Family.SHADOWS, reference, List.of(
            shown(Setting.sampled(1), 10, 0.1, reference), shown(Setting.sampled(4), 40, 0.01, reference),
            shown(Setting.exact(), 40, 0.0001, reference)));
        FamilyStudy edges = new FamilyStudy(Family.EDGES, reference, List.of(shown(Setting.oneRay(), 10, 0.1, reference),
            shown(Setting.atEdges(4), 90, 0.001, reference), shown(Setting.everywhere(4), 160, 0.001, reference),
            measured(Setting.errorLimit(2), new Quantiles(5, 20, 40, 60), 0.001),
            measured(Setting.errorLimit(1), 50, 0.0005)));
        List<SpeedUps.Row> speedUps = List.of(new SpeedUps.Row("all", Studies.quiet(10), 1, 0, 0));
        return new SceneStudy(title, scene, AmbientLight.NONE, List.of(shadows, edges), speedUps, speedUps,
            List.of(new ColdRuns.Row("", Spread.of(List.of(0.3)).orElseThrow())));
    }

    private static String page(SceneStudy... studies) throws Exception {
        return new Page(Request.of(List.of("scene=scenes/room.txt")), List.of(studies), LOAD).html();
    }

    @Test
    void everyTagIsClosedInItsPlace() throws Exception {
        Deque<String> open = new ArrayDeque<>();
        Matcher tag = TAG.matcher(page(study("a < b")).replaceAll("<style>[^<]*</style>", ""));
        int tags = 0;
        while (tag.find()) {
            tags++;
            if (!tag.group(1).isEmpty()) {
                assertEquals(open.pop(), tag.group(2), "before character " + tag.start());
            } else if (tag.group(4).isEmpty() && !tag.group(3).endsWith("/") && !WITHOUT_END.contains(tag.group(2))) {
                open.push(tag.group(2));
            }
        }
        assertTrue(open.isEmpty(), open.toString());
        assertTrue(tags > 300, "only " + tags + " tags");
    }

    @Test
    void theAnswerComesFirst() throws Exception {
        String page = page(study("made"));
        assertTrue(page.indexOf("<p class=\"lead\">At this scene's own N = 4 exact shadows take as long and are 100 "
            + "times closer: <code>--shadows exact</code>.</p>") < page.indexOf("<table>"));
        assertFalse(page.substring(page.indexOf("<h1>"), page.indexOf("<h2>")).contains("extrapolated"));
    }

    @Test
    void ofManyScenesTheMedianIsTheAnswer() throws Exception {
        assertEquals("Compared with each scene's own N exact shadows take as long and are 100 times closer, in the "
            + "median of 2 scenes with soft shadows: `--shadows exact`, which is recommended for 2 of them.",
            Headline.of(List.of(study("a"), study("b"))).get(0));
    }

    @Test
    void aSingleScenesPageIsNotAboutTheCrossingFormulas() throws Exception {
        assertFalse(page(study("a")).contains("The crossing formulas"));
        assertTrue(page(study("a"), study("b")).contains("The crossing formulas"));
    }

    @Test
    void loadAndNoiseAreOnThePage() throws Exception {
        String page = page(study("a"));
        assertTrue(page.contains("Load of the machine: 0 before and 2 after"));
        assertTrue(page.contains("1 of 8 times look like noise"));
        assertTrue(page.contains("40.0 (20.0 - 60.0) †"));
    }

    @Test
    void theRecommendedSettingIsMarkedInTheTable() throws Exception {
        List<List<String>> rows = Tables.settings(study("a").families().get(0)).rows();
        assertEquals("◎", rows.get(2).get(7));
    }

    @Test
    void aWideTableScrollsAndCanBeReachedByKeyboard() throws Exception {
        String page = page(study("a"));
        assertTrue(page.contains("<div class=\"scroll\" tabindex=\"0\" role=\"region\""));
        assertTrue(page.contains(".scroll { overflow-x: auto;"));
    }

    @Test
    void everyPictureHasItsWorstPlaceMagnified() throws Exception {
        String page = page(study("a"));
        assertEquals(6, page.split("<div class=\"closeups\">", -1).length - 1);
        assertEquals(6, page.split("<span style=\"left:", -1).length - 1);
    }
}
