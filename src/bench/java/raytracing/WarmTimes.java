package raytracing;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import raytracing.parse.RayTracerException;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.render.Renderers;
import raytracing.scene.Scene;
import raytracing.timed.Spread;

/** Frames of 500 x 500 pixels in a virtual machine that has drawn the same scene for a while. */
final class WarmTimes {
    static final List<TimedScene> SCENES = List.of(
        TimedScene.POOL, TimedScene.SPHERES, TimedScene.ROOM1, TimedScene.NEST,
        TimedScene.FLAKE_7381, TimedScene.FLAKE_597871, TimedScene.FLAKE_7381_SOFT, TimedScene.FLAKE_597871_SOFT,
        TimedScene.KNOT_100000, TimedScene.KNOT_100000_SOFT);

    /**
     * How many times our processor time POV-Ray should need at least: from its time and that of a renderer in C++ on
     * another day, of which ours may need twice as much.
     */
    private static final Map<TimedScene, Double> ASKED = Map.of(
        TimedScene.POOL, 30 / 2.0,
        TimedScene.FLAKE_597871, 7.5 / (2 * 0.70),
        TimedScene.FLAKE_597871_SOFT, 10 / (2 * 1.2));

    private static final double MOST_GROWTH = 4;
    private static final double NANOSECONDS_IN_MILLISECOND = 1e6;
    private static final double NANOSECONDS_IN_SECOND = 1e9;
    private static final String NONE = "-";

    private static final OperatingSystemMXBean SYSTEM =
        ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);

    private final List<Series> all = new ArrayList<>();

    private WarmTimes() {
    }

    /**
     * What one scene took. The processor time is the mean of all frames, for the clock that counts it may tick only a
     * hundred times a second; it includes what the virtual machine's own threads do meanwhile.
     */
    private record Series(TimedScene scene, Spread buildMilliseconds, Spread frameMilliseconds, double cpuSeconds) {
        List<String> cells(Optional<Double> peersSeconds) {
            return List.of(scene.title(), buildMilliseconds.shown(1), frameMilliseconds.shown(0),
                String.format(Locale.ROOT, "%.3f", cpuSeconds),
                number(peersSeconds), number(peersSeconds.map(seconds -> seconds / cpuSeconds)),
                number(Optional.ofNullable(ASKED.get(scene))));
        }
    }

    static WarmTimes measured(List<TimedScene> scenes, Effort effort) throws IOException, RayTracerException {
        WarmTimes times = new WarmTimes();
        for (TimedScene scene : scenes) {
            times.all.add(series(scene, effort));
        }
        return times;
    }

    private static Series series(TimedScene timed, Effort effort) throws IOException, RayTracerException {
        Scene scene = timed.scene();
        long start = System.nanoTime();
        Renderer renderer = Renderers.of(scene, RenderSettings.DEFAULT);
        do {
            Renderers.film(renderer);
        } while (System.nanoTime() - start < effort.warmUpNanoseconds());
        Spread builds = milliseconds(effort.frames(), 0, () -> Renderers.of(scene, RenderSettings.DEFAULT));
        long before = SYSTEM.getProcessCpuTime();
        AtomicInteger count = new AtomicInteger();
        Spread frames = milliseconds(effort.frames(), effort.measuredNanoseconds(), () -> {
            Renderers.film(renderer);
            count.incrementAndGet();
        });
        double cpuSeconds = (SYSTEM.getProcessCpuTime() - before) / NANOSECONDS_IN_SECOND / count.get();
        System.out.println("Warm " + timed.title() + ": " + frames + " ms");
        return new Series(timed, builds, frames, cpuSeconds);
    }

    /** Of each run of a task, until there are enough and enough time has passed. */
    private static Spread milliseconds(int runs, long nanoseconds, Runnable task) {
        List<Double> milliseconds = new ArrayList<>();
        long first = System.nanoTime();
        while (milliseconds.size() < runs || System.nanoTime() - first < nanoseconds) {
            long start = System.nanoTime();
            task.run();
            milliseconds.add((System.nanoTime() - start) / NANOSECONDS_IN_MILLISECOND);
        }
        return Spread.of(milliseconds).orElseThrow();
    }

    String table(ColdTimes cold) {
        return MarkdownTable.of(List.of("scene", "build, ms", "frame, ms", "frame, CPU s", "POV-Ray, CPU s",
            "POV-Ray's CPU over ours", "asked: at least"),
            all.stream().map(series -> series.cells(cold.peersProcessorSeconds(series.scene))).toList());
    }

    /** How drawing time grows with the scene, if both scenes were measured. */
    String growth(TimedScene small, TimedScene large) {
        Optional<Double> over = median(small);
        Optional<Double> growth = median(large).flatMap(time -> over.map(less -> time / less));
        return growth.isEmpty() ? "" : String.format(Locale.ROOT,
            "\nA frame of %s takes %.2f times as long as one of %s; asked: at most %.0f.\n",
            large.title(), growth.get(), small.title(), MOST_GROWTH);
    }

    private Optional<Double> median(TimedScene scene) {
        return all.stream().filter(series -> series.scene == scene).findFirst()
            .map(series -> series.frameMilliseconds.median());
    }

    private static String number(Optional<Double> number) {
        return number.map(value -> String.format(Locale.ROOT, "%.2f", value)).orElse(NONE);
    }
}
