package raytracing.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.IntStream;
import raytracing.Quantiles;
import raytracing.render.Renderer;
import raytracing.render.Rendering;

/**
 * Draws warm frames, each contender in turn, so that a disturbed machine disturbs all of them alike. Contenders whose times
 * look like noise are then drawn some more.
 */
final class Rounds {
    private static final double NANOSECONDS_IN_MILLISECOND = 1e6;
    private static final double NANOSECONDS_IN_SECOND = 1e9;

    /** Of a slow contender. */
    private static final int SLOW_FRAMES = 2;

    private final List<Renderer> contenders;
    private final Progress progress;
    private final List<Rendering> renderings = new ArrayList<>();
    private final List<List<Double>> times = new ArrayList<>();

    private Rounds(List<Renderer> contenders, Progress progress) {
        this.contenders = contenders;
        this.progress = progress;
        contenders.forEach(contender -> times.add(new ArrayList<>()));
    }

    /**
     * What came of a contender.
     *
     * @param rendering the first of its frames
     * @param milliseconds that its frames took
     */
    record Drawn(Rendering rendering, Quantiles milliseconds) {
    }

    /**
     * Of each contender in its order.
     *
     * @param noisy the places of the contenders whose times look like noise, from the times of all
     */
    static List<Drawn> of(List<Renderer> contenders, Function<List<Quantiles>, Set<Integer>> noisy, Budget budget,
                          Progress progress) {
        Rounds rounds = new Rounds(contenders, progress);
        long start = System.nanoTime();
        for (int round = 0; round < budget.mostRounds(); round++) {
            if (round >= budget.leastRounds() && seconds(start) > budget.secondsOfRounds()) {
                break;
            }
            rounds.draw(rounds.unfinished(budget), "round " + (round + 1));
        }
        for (int round = 0; round < budget.roundsAgain(); round++) {
            Set<Integer> again = noisy.apply(rounds.milliseconds());
            rounds.draw(again.stream().sorted().toList(), "noise, again");
        }
        return rounds.drawn();
    }

    /** The places of the contenders that are still to be drawn: a slow one needs fewer frames than a fast one. */
    private List<Integer> unfinished(Budget budget) {
        return IntStream.range(0, contenders.size()).filter(place -> times.get(place).size() < SLOW_FRAMES
            || sum(times.get(place)) < budget.millisecondsOfSlow()).boxed().toList();
    }

    private static double sum(List<Double> values) {
        return values.stream().mapToDouble(Double::doubleValue).sum();
    }

    private static double seconds(long start) {
        return (System.nanoTime() - start) / NANOSECONDS_IN_SECOND;
    }

    private void draw(List<Integer> places, String round) {
        for (int place : places) {
            progress.say(round + ", setting " + (place + 1) + " of " + contenders.size());
            long start = System.nanoTime();
            Rendering rendering = Rendering.of(contenders.get(place));
            times.get(place).add((System.nanoTime() - start) / NANOSECONDS_IN_MILLISECOND);
            if (renderings.size() == place) {
                renderings.add(rendering);
            }
        }
    }

    private List<Quantiles> milliseconds() {
        return times.stream().map(Quantiles::of).toList();
    }

    private List<Drawn> drawn() {
        List<Quantiles> milliseconds = milliseconds();
        return IntStream.range(0, contenders.size())
            .mapToObj(i -> new Drawn(renderings.get(i), milliseconds.get(i))).toList();
    }
}
