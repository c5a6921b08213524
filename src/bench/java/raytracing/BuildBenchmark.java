package raytracing;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.render.Renderers;
import raytracing.scene.Scene;

/** Milliseconds from a scene in memory to a renderer that could draw its first ray. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 4, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
@State(Scope.Benchmark)
public class BuildBenchmark {
    @Param({"FLAKE_7381", "FLAKE_66430", "FLAKE_597871", "KNOT_100000", "KNOT_1000000"})
    public TimedScene scene;

    private Scene parsed;

    @Setup
    public void read() throws Exception {
        parsed = scene.scene();
    }

    @Benchmark
    public Renderer build() {
        return Renderers.of(parsed, RenderSettings.DEFAULT);
    }
}
