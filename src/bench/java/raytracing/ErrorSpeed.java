package raytracing;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.IntToDoubleFunction;
import raytracing.math.CounterRandom;
import raytracing.parse.RayTracerException;
import raytracing.render.ErrorLimit;
import raytracing.render.GridErrors;
import raytracing.render.PixelGrid;
import raytracing.render.Renderer;
import raytracing.render.Renderers;
import raytracing.render.TrueLight;
import raytracing.shadow.ShadowMethod;

/** Times of pictures under {@code --error E} beside those of N x N rays that are as near to the truth. */
final class ErrorSpeed {
    private static final int SIZE = 500;
    private static final List<Double> LIMITS = List.of(1.0, 0.5);
    private static final double LEAST = 0.5;
    private static final int POINTS = 1024;
    private static final int MOST_ROOT = 32;
    private static final double NANOSECONDS = 1e9;

    /** Grids whose frames are timed; the times of others follow from theirs. */
    private static final int EDGES_ROOT = 2;
    private static final int LARGER_EDGES_ROOT = 6;

    /** What takes 4 x 4 rays in every pixel, and 8 x 8. */
    private static final int GOAL_IN_THE_MEDIAN = 4;
    private static final int GOAL_IN_ANY = 8;

    /**
     * How large a grid is as near to the truth as we are.
     *
     * @param root N, between whole numbers; the largest that was tried if that is not enough
     * @param isReached whether it is enough
     */
    private record EqualGrid(double root, boolean isReached) {
        /**
         * The first N at which the error is at most ours; between it and the N before, the logarithm of the error is taken
         * as linear in that of N.
         */
        static EqualGrid of(double error, IntToDoubleFunction errorOfGrid) {
            double before = Double.NaN;
            for (int root = 1; root <= MOST_ROOT; root++) {
                double here = errorOfGrid.applyAsDouble(root);
                if (here <= error) {
                    return new EqualGrid(root == 1 || here <= 0 ? root : between(root, before, here, error), true);
                }
                before = here;
            }
            return new EqualGrid(MOST_ROOT, false);
        }

        private static double between(int root, double before, double here, double error) {
            double share = Math.log(before / error) / Math.log(before / here);
            return (root - 1) * Math.pow((double) root / (root - 1), share);
        }

        String shown() {
            return (isReached ? "" : "> ") + figure(root);
        }

        /** A ratio of times at this N, which is only a lower bound if the grid is not enough. */
        String shown(Quantiles ratio) {
            return (isReached ? "" : "> ") + spread(ratio);
        }
    }

    /** What one round of frames took, in seconds: ours for each limit, and of grids. */
    private record Round(List<Double> ours, double everywhere, int everywhereRoot, double edges, double moreEdges) {
        /** As each ray takes as long as another. */
        double everywhere(double root) {
            return everywhere * root * root / (everywhereRoot * everywhereRoot);
        }

        /** A line in N x N through the two that were timed. */
        double edges(double root) {
            double slope = (moreEdges - edges) / (LARGER_EDGES_ROOT * LARGER_EDGES_ROOT - EDGES_ROOT * EDGES_ROOT);
            return Math.max(0, edges + slope * (root * root - EDGES_ROOT * EDGES_ROOT));
        }
    }

    /** All about one scene and one limit. */
    private record Outcome(ErrorScenes.Named named, double error, double seconds, EqualGrid everywhere,
                           Quantiles everywhereRatio, EqualGrid edges, Quantiles edgesRatio, Quantiles overMedianGoal,
                           Quantiles overGoalInAny) {
        List<String> row() {
            return List.of(named.title() + (named.hasAmbientLight() ? " *" : ""), figure(error), figure(seconds),
                everywhere.shown(), everywhere.shown(everywhereRatio), edges.shown(), edges.shown(edgesRatio),
                spread(overMedianGoal), spread(overGoalInAny));
        }
    }

    private final Effort effort;
    private final int rounds;
    private final int everywhereRoot;
    private final int oneIn;

    private ErrorSpeed(Effort effort) {
        this.effort = effort;
        boolean isFull = effort == Effort.FULL;
        rounds = isFull ? 5 : 3;
        everywhereRoot = isFull ? 4 : 2;
        oneIn = isFull ? 32 : 128;
    }

    /** Of the scenes with some names; of all if there are no names. */
    static String section(Effort effort, List<String> names) throws IOException, RayTracerException {
        return new ErrorSpeed(effort).measured(names);
    }

    private String measured(List<String> names) throws IOException, RayTracerException {
        List<List<Outcome>> outcomes = LIMITS.stream().<List<Outcome>>map(limit -> new ArrayList<>()).toList();
        for (ErrorScenes.Named named : ErrorScenes.all()) {
            if (!names.isEmpty() && !names.contains(named.title())) {
                continue;
            }
            List<Outcome> ofScene = outcomes(named);
            for (int i = 0; i < LIMITS.size(); i++) {
                outcomes.get(i).add(ofScene.get(i));
                System.out.println("E = " + LIMITS.get(i) + ": " + ofScene.get(i).row());
            }
        }
        StringBuilder text = new StringBuilder(String.format(Locale.ROOT, """
            %d x %d pixels, exact shadows, warm, without the preparation of the scene. Errors are the RMS of those pixels
            whose rays differ, among one in %d at random, against %,d points. N is that of the N x N rays with the same error,
            between whole numbers; `>` marks where even N = %d is worse, so that the ratio is a lower bound. Times: %d rounds
            of one frame each way in turn; the median of the ratios (their quartiles). Frames with rays everywhere are timed
            for N = %d and scale with N x N; with rays at edges, for N = %d and %d, with a line in N x N through both.

            """, SIZE, SIZE, oneIn, POINTS, MOST_ROOT, rounds, everywhereRoot, EDGES_ROOT, LARGER_EDGES_ROOT));
        for (int i = 0; i < LIMITS.size(); i++) {
            text.append(table(LIMITS.get(i), outcomes.get(i))).append('\n');
        }
        return text.append(verdict(outcomes)).toString();
    }

    private static String table(double limit, List<Outcome> outcomes) {
        return "E = " + limit + ":\n\n" + MarkdownTable.of(List.of("scene", "our RMS, steps", "our time, s",
            "N everywhere", "its time over ours", "N at edges (`--samples`)", "its time over ours",
            "ours over 4 x 4 everywhere", "ours over 8 x 8 everywhere"), outcomes.stream().map(Outcome::row).toList());
    }

    private List<Outcome> outcomes(ErrorScenes.Named named) {
        Renderer renderer = ErrorScenes.prepared(named.scene(), SIZE, new ShadowMethod.Exact(), LEAST);
        TrueLight truth = TrueLight.of(renderer, POINTS,
            (x, y) -> Long.remainderUnsigned(CounterRandom.bits(CounterRandom.bits(oneIn, x), y), oneIn) == 0);
        GridErrors grids = new GridErrors(renderer, truth);
        List<Double> errors = LIMITS.stream().map(limit ->
            GridErrors.rootMeanSquare(Renderers.film(Renderers.withSampling(renderer, new ErrorLimit(limit))), truth))
            .toList();
        List<Round> measured = rounds(renderer);
        List<Outcome> outcomes = new ArrayList<>();
        for (int i = 0; i < LIMITS.size(); i++) {
            outcomes.add(outcome(named, i, errors.get(i), grids, measured));
        }
        return outcomes;
    }

    private Outcome outcome(ErrorScenes.Named named, int limit, double error, GridErrors grids, List<Round> measured) {
        EqualGrid everywhere = EqualGrid.of(error,
            root -> grids.rootMeanSquare(new PixelGrid(root, PixelGrid.Where.EVERYWHERE)));
        EqualGrid edges = EqualGrid.of(error, root -> grids.rootMeanSquare(new PixelGrid(root, PixelGrid.Where.EDGES)));
        return new Outcome(named, error, of(measured, round -> round.ours().get(limit)).median(),
            everywhere, of(measured, round -> round.everywhere(everywhere.root()) / round.ours().get(limit)),
            edges, of(measured, round -> round.edges(edges.root()) / round.ours().get(limit)),
            of(measured, round -> round.ours().get(limit) / round.everywhere(GOAL_IN_THE_MEDIAN)),
            of(measured, round -> round.ours().get(limit) / round.everywhere(GOAL_IN_ANY)));
    }

    /** A figure of a round. */
    private interface Figure {
        double of(Round round);
    }

    private static Quantiles of(List<Round> measured, Figure figure) {
        return Quantiles.of(measured.stream().map(figure::of).toList());
    }

    private List<Round> rounds(Renderer renderer) {
        List<Renderer> ours =
            LIMITS.stream().map(limit -> Renderers.withSampling(renderer, new ErrorLimit(limit))).toList();
        Renderer everywhere = Renderers.withSampling(renderer, new PixelGrid(everywhereRoot, PixelGrid.Where.EVERYWHERE));
        Renderer edges = Renderers.withSampling(renderer, new PixelGrid(EDGES_ROOT, PixelGrid.Where.EDGES));
        Renderer moreEdges = Renderers.withSampling(renderer, new PixelGrid(LARGER_EDGES_ROOT, PixelGrid.Where.EDGES));
        long start = System.nanoTime();
        do {
            Renderers.film(ours.get(0));
            Renderers.film(edges);
        } while (System.nanoTime() - start < effort.warmUpNanoseconds());
        List<Round> measured = new ArrayList<>();
        for (int round = 0; round < rounds; round++) {
            measured.add(new Round(ours.stream().map(ErrorSpeed::seconds).toList(), seconds(everywhere), everywhereRoot,
                seconds(edges), seconds(moreEdges)));
        }
        return measured;
    }

    private static double seconds(Renderer renderer) {
        long start = System.nanoTime();
        Renderers.film(renderer);
        return (System.nanoTime() - start) / NANOSECONDS;
    }

    /** The goals with what came out. */
    private static String verdict(List<List<Outcome>> outcomes) {
        List<List<String>> rows = new ArrayList<>();
        for (int i = 0; i < LIMITS.size(); i++) {
            String limit = "E = " + LIMITS.get(i) + ", ";
            List<Double> everywhere = outcomes.get(i).stream().map(outcome -> outcome.everywhereRatio().median()).toList();
            List<Double> edges = outcomes.get(i).stream().map(outcome -> outcome.edgesRatio().median()).toList();
            rows.add(atLeast(limit + "N x N everywhere over ours, median", 4, Quantiles.of(everywhere).median()));
            rows.add(atLeast(limit + "the same, smallest", 1, everywhere.stream().min(Double::compare).orElseThrow()));
            rows.add(atLeast(limit + "`--samples` over ours, median", 1.5, Quantiles.of(edges).median()));
        }
        List<Outcome> withoutAmbient =
            outcomes.get(0).stream().filter(outcome -> !outcome.named().hasAmbientLight()).toList();
        rows.add(atMost("E = 1.0, ours over 4 x 4 everywhere, median",
            Quantiles.of(withoutAmbient.stream().map(outcome -> outcome.overMedianGoal().median()).toList()).median()));
        rows.add(atMost("E = 1.0, ours over 8 x 8 everywhere, largest",
            withoutAmbient.stream().map(outcome -> outcome.overGoalInAny().median()).max(Double::compare).orElseThrow()));
        return "Over the scenes; a lower bound counts as it stands. Scenes with ambient light (*) do not count in the last "
            + "two rows.\n\n" + MarkdownTable.of(List.of("", "measured", "goal", "reached"), rows);
    }

    private static List<String> atLeast(String title, double goal, double measured) {
        return List.of(title, figure(measured), "at least " + goal, measured >= goal ? "yes" : "no");
    }

    private static List<String> atMost(String title, double measured) {
        return List.of(title, figure(measured), "at most 1", measured <= 1 ? "yes" : "no");
    }

    private static String spread(Quantiles ratio) {
        return figure(ratio.median()) + " (" + figure(ratio.lower()) + " - " + figure(ratio.upper()) + ")";
    }

    private static String figure(double value) {
        return String.format(Locale.ROOT, "%.2f", value);
    }
}
