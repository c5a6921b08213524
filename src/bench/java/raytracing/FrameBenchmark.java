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
import raytracing.film.Film;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.render.Renderers;

/**
 * Milliseconds for a frame of 500 x 500 pixels on all processors, the scene prepared before. A scene that is not beside
 * the checkout fails in its set-up and stops no other.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 4, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
@State(Scope.Benchmark)
public class FrameBenchmark {
    @Param
    public TimedScene scene;

    private Renderer renderer;

    @Setup
    public void prepare() throws Exception {
        renderer = Renderers.of(scene.scene(), RenderSettings.DEFAULT);
    }

    @Benchmark
    public Film frame() {
        return Renderers.film(renderer);
    }
}
