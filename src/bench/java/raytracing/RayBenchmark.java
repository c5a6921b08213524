package raytracing;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Millions of rays a second on one thread, by how many balls or triangles there are and how much one ray resembles the next. */
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 4, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
@State(Scope.Benchmark)
public class RayBenchmark {
    private static final int SIZE = 128;
    private static final int RAYS = SIZE * SIZE;

    @Param({"FLAKE_91", "FLAKE_820", "FLAKE_7381", "FLAKE_66430", "FLAKE_597871", "KNOT_100000"})
    public TimedScene scene;

    @Param
    public Coherence coherence;

    private RayCaster caster;

    @Setup
    public void aim() throws Exception {
        caster = new PreparedRayCaster(scene.scene(), coherence, SIZE);
    }

    @Benchmark
    @OperationsPerInvocation(RAYS)
    public double nearest() {
        double sum = 0;
        for (int ray = 0; ray < RAYS; ray++) {
            sum += caster.nearest(ray);
        }
        return sum;
    }

    @Benchmark
    @OperationsPerInvocation(RAYS)
    public int occluded() {
        int count = 0;
        for (int ray = 0; ray < RAYS; ray++) {
            count += caster.occluded(ray) ? 1 : 0;
        }
        return count;
    }
}
