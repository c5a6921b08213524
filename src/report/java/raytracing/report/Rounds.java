package raytracing.report;

import java.util.ArrayList;
import java.util.List;
import raytracing.Quantiles;
import raytracing.render.Renderer;
import raytracing.render.Rendering;

/** Draws warm frames, each contender in turn, so that a disturbed machine disturbs all of them alike. */
final class Rounds {
    private static final double NANOSECONDS_IN_MILLISECOND = 1e6;
    private static final double NANOSECONDS_IN_SECOND = 1e9;

    private Rounds() {
    }

    /**
     * What came of a contender.
     *
     * @param rendering the first of its frames
     * @param milliseconds that its frames took
     */
    record Drawn(Rendering rendering, Quantiles milliseconds) {
    }

    /** Of each contender in its order. */
    static List<Drawn> of(List<Renderer> contenders, Budget budget, Progress progress) {
        List<List<Double>> times = new ArrayList<>();
        List<Rendering> renderings = new ArrayList<>();
        contenders.forEach(contender -> times.add(new ArrayList<>()));
        long first = System.nanoTime();
        for (int round = 0; round < budget.mostRounds(); round++) {
            if (round >= budget.leastRounds() && seconds(first) > budget.secondsOfRounds()) {
                break;
            }
            for (int i = 0; i < contenders.size(); i++) {
                progress.say("round " + (round + 1) + ", setting " + (i + 1) + " of " + contenders.size());
                long start = System.nanoTime();
                Rendering rendering = Rendering.of(contenders.get(i));
                times.get(i).add((System.nanoTime() - start) / NANOSECONDS_IN_MILLISECOND);
                if (round == 0) {
                    renderings.add(rendering);
                }
            }
        }
        List<Drawn> drawn = new ArrayList<>();
        for (int i = 0; i < contenders.size(); i++) {
            drawn.add(new Drawn(renderings.get(i), Quantiles.of(times.get(i))));
        }
        return drawn;
    }

    private static double seconds(long start) {
        return (System.nanoTime() - start) / NANOSECONDS_IN_SECOND;
    }
}
