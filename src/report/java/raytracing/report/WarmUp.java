package raytracing.report;

import java.util.List;
import java.util.stream.Stream;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.render.Renderers;
import raytracing.scene.Scene;

/** Draws for a while what nobody looks at: else the first scene would pay for the compilation of all. */
final class WarmUp {
    private static final long NANOSECONDS = 5_000_000_000L;

    private WarmUp() {
    }

    static void run(Scene scene, RenderSettings settings, Progress progress) {
        progress.say("warming up");
        List<Renderer> renderers = Stream.of(
                Setting.sampled(1), Setting.sampled(4), Setting.exact(), Setting.atEdges(2), Setting.everywhere(2),
                Setting.errorLimit(2))
            .map(setting -> Renderers.of(scene, setting.in(settings))).toList();
        long start = System.nanoTime();
        while (System.nanoTime() - start < NANOSECONDS) {
            renderers.forEach(Renderers::film);
        }
    }
}
