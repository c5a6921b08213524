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
import raytracing.numerics.Algorithm;
import raytracing.numerics.BoxAlgorithm;
import raytracing.numerics.BoxFamily;
import raytracing.numerics.Family;
import raytracing.numerics.Formula;
import raytracing.numerics.PlaneAlgorithm;
import raytracing.numerics.PlaneFamily;
import raytracing.numerics.Queries;
import raytracing.numerics.SphereAlgorithm;
import raytracing.numerics.SphereFamily;

/**
 * Nanoseconds for one ray and one surface, for every contender on every family. Each pair of them has a virtual machine
 * of its own, for two formulas behind one interface would slow each other.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 4, time = 200, timeUnit = TimeUnit.MILLISECONDS)
@Measurement(iterations = 4, time = 60, timeUnit = TimeUnit.MILLISECONDS)
@Fork(1)
public class CrossingBenchmark {
    /** So many that a processor cannot learn their outcomes by heart, so few that they stay in its caches. */
    private static final int QUERIES = 1 << 14;
    private static final long SEED = 17;

    /** Queries and the formula that answers them. */
    private record Round(Formula formula, Queries queries) {
        static Round of(Algorithm algorithm, Family family) {
            return new Round(algorithm.formula(), family.queries(SEED, QUERIES));
        }

        double walk() {
            return queries.sumOfCrossings(formula);
        }
    }

    /** Who meets which spheres. */
    @State(Scope.Benchmark)
    public static class Spheres {
        @Param
        public SphereAlgorithm algorithm;

        @Param
        public SphereFamily family;

        private Round round;

        @Setup
        public void draw() {
            round = Round.of(algorithm, family);
        }
    }

    /** Who meets which planes. */
    @State(Scope.Benchmark)
    public static class Planes {
        @Param
        public PlaneAlgorithm algorithm;

        @Param
        public PlaneFamily family;

        private Round round;

        @Setup
        public void draw() {
            round = Round.of(algorithm, family);
        }
    }

    /** Who meets which boxes. */
    @State(Scope.Benchmark)
    public static class Boxes {
        @Param
        public BoxAlgorithm algorithm;

        @Param
        public BoxFamily family;

        private Round round;

        @Setup
        public void draw() {
            round = Round.of(algorithm, family);
        }
    }

    @Benchmark
    @OperationsPerInvocation(QUERIES)
    public double sphere(Spheres spheres) {
        return spheres.round.walk();
    }

    @Benchmark
    @OperationsPerInvocation(QUERIES)
    public double plane(Planes planes) {
        return planes.round.walk();
    }

    @Benchmark
    @OperationsPerInvocation(QUERIES)
    public double box(Boxes boxes) {
        return boxes.round.walk();
    }
}
