package raytracing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static raytracing.report.Studies.quiet;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import raytracing.Quantiles;
import raytracing.parallel.ForkJoin;
import raytracing.parse.SceneParser;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.render.Renderers;

class NoiseTest {
    private static final Budget SHORT = new Budget(11, 2, 2, 1e9, 0, 3, List.of(1), 2, List.of(2), List.of(2),
        List.of(1.0), 2, 1, 1, 11);

    @Test
    void wideQuartilesAreNoise() {
        assertEquals(Set.of(1), Noise.wide(List.of(new Quantiles(5, 91, 100, 109), new Quantiles(5, 89, 100, 111))));
    }

    @Test
    void moreRaysInLessTimeAreNoiseBoth() {
        assertEquals(Set.of(1, 2), Noise.among(List.of(Setting.sampled(1), Setting.sampled(2), Setting.sampled(3)),
            List.of(quiet(10), quiet(30), quiet(20))));
    }

    @Test
    void timesAboutTheSameAreInNoOrder() {
        assertEquals(Set.of(), Noise.among(List.of(Setting.sampled(2), Setting.sampled(3)),
            List.of(quiet(102), quiet(100))));
    }

    @Test
    void aSmallerErrorIsMoreWork() {
        List<Setting> settings = List.of(Setting.errorLimit(8), Setting.errorLimit(2));
        assertEquals(Set.of(), Noise.among(settings, List.of(quiet(10), quiet(20))));
        assertEquals(Set.of(0, 1), Noise.among(settings, List.of(quiet(20), quiet(10))));
    }

    @Test
    void differentWaysAreInNoOrder() {
        assertEquals(Set.of(), Noise.among(List.of(Setting.atEdges(2), Setting.everywhere(4)),
            List.of(quiet(20), quiet(10))));
    }

    @Test
    void noiseIsMeasuredAgainWhileItLooksLikeNoise() throws Exception {
        Renderer renderer = Renderers.of(SceneParser.parse("made", """
            cam 0 0 -5  0 0 0  0 1 0  1 1
            set 0 0 0  1 1
            mtl 1 1 1  0 0 0  0 0 0  1 0
            sph 0 0 0  1  1
            """.getBytes(StandardCharsets.UTF_8), ForkJoin.sequential()).scene(), RenderSettings.DEFAULT.withSize(11, 11));
        List<Rounds.Drawn> drawn = Rounds.of(List.of(renderer, renderer),
            times -> times.get(1).count() < 4 ? Set.of(1) : Set.of(), SHORT, Progress.of(1, 1, "test"));
        assertEquals(2, drawn.get(0).milliseconds().count());
        assertEquals(4, drawn.get(1).milliseconds().count());
    }
}
