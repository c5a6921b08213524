package raytracing;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.openjdk.jmh.results.BenchmarkResult;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.Options;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.VerboseMode;
import raytracing.numerics.Algorithm;
import raytracing.numerics.Family;
import raytracing.numerics.Shape;

/**
 * Times of all contenders, in rounds: in each, the contenders for a family run one after another. Ordinary rays, which
 * scenes are made of, take part in every round, hard ones in every third.
 */
final class CrossingTimes {
    static final String CAPTION = "Nanoseconds for a ray and a surface, median -/+ half the way between the quartiles:";

    private static final int ROUNDS_TO_A_HARD_ONE = 3;

    private final List<Map<Contest, Quantiles>> rounds = new ArrayList<>();
    private final Map<Contest, List<Double>> all = new HashMap<>();

    private CrossingTimes() {
    }

    /** A contender, by name, and a family. */
    private record Contest(String algorithm, Family family) {
    }

    static CrossingTimes measured(int rounds) throws RunnerException {
        CrossingTimes times = new CrossingTimes();
        for (int round = 0; round < rounds; round++) {
            times.addRound(familiesOfRound(round));
        }
        return times;
    }

    private static List<Family> familiesOfRound(int round) {
        long ofEachShape = round % ROUNDS_TO_A_HARD_ONE == 0 ? Long.MAX_VALUE : 1;
        return Stream.of(Shape.values()).flatMap(shape -> shape.families().stream().limit(ofEachShape)).toList();
    }

    private void addRound(List<Family> families) throws RunnerException {
        Map<Contest, Quantiles> round = new HashMap<>();
        for (Family family : families) {
            System.out.println("Round " + (rounds.size() + 1) + ": " + family.shape() + ", " + family.title());
            for (RunResult result : run(family)) {
                List<Double> nanoseconds = iterations(result);
                Contest contest = new Contest(result.getParams().getParam("algorithm"), family);
                round.put(contest, Quantiles.of(nanoseconds));
                all.computeIfAbsent(contest, unused -> new ArrayList<>()).addAll(nanoseconds);
            }
        }
        rounds.add(round);
    }

    private static Collection<RunResult> run(Family family) throws RunnerException {
        Options options = new OptionsBuilder()
            .include(CrossingBenchmark.class.getName() + "." + family.shape().name().toLowerCase(Locale.ROOT) + "$")
            .param("family", family.name()).verbosity(VerboseMode.SILENT).shouldFailOnError(true).build();
        return new Runner(options).run();
    }

    private static List<Double> iterations(RunResult result) {
        return result.getBenchmarkResults().stream().map(BenchmarkResult::getIterationResults)
            .flatMap(Collection::stream).map(iteration -> iteration.getPrimaryResult().getScore()).toList();
    }

    String how() {
        long hard = IntStream.range(0, rounds.size()).filter(round -> round % ROUNDS_TO_A_HARD_ONE == 0).count();
        int iterations = rounds.get(0).values().iterator().next().count();
        return "Times: a virtual machine of its own for each contender and family in each round, " + iterations
            + " iterations each.\n" + rounds.size() + " rounds with ordinary rays, " + hard
            + " with hard ones; in a round the contenders for a family run one after another.\n"
            + "A hard ray meets a single surface, so its branches come as news to the processor:\n"
            + "rows compare contenders, not families.";
    }

    String cell(Algorithm algorithm, Family family) {
        Quantiles quantiles = Quantiles.of(all.get(new Contest(algorithm.name(), family)));
        return String.format(Locale.ROOT, "%.1f -/+ %.1f", quantiles.median(), quantiles.spread());
    }

    /** Each round compares two times of the same minute: what slows the machine slows both. */
    String ratio(Shape shape) {
        Family ordinary = shape.families().get(0);
        Contest ours = new Contest("OURS", ordinary);
        Contest textbook = new Contest("TEXTBOOK", ordinary);
        List<Double> ratios = rounds.stream().map(round -> round.get(ours).median() / round.get(textbook).median())
            .sorted().toList();
        return String.format(Locale.ROOT,
            "Ordinary rays: ours takes %.2f times as long as the textbook (by rounds: %s).",
            Quantiles.of(ratios).median(), listed(ratios));
    }

    private static String listed(List<Double> ratios) {
        return String.join(", ", ratios.stream().map(ratio -> String.format(Locale.ROOT, "%.2f", ratio)).toList());
    }
}
