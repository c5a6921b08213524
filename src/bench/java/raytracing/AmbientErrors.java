package raytracing;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import raytracing.ambient.AmbientLight;
import raytracing.color.Color;
import raytracing.estimate.AmbientEstimate;
import raytracing.estimate.AmbientPart;
import raytracing.estimate.AmbientScenes;
import raytracing.parallel.ForkJoin;
import raytracing.parallel.Preparation;
import raytracing.parse.RayTracerException;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.render.Renderers;
import raytracing.scene.Scene;

/** Estimates of ambient light held to brute force. */
final class AmbientErrors {
    /** No pixel looks along an edge of a room, where the truth has two values. */
    private static final RenderSettings SMALL = RenderSettings.DEFAULT.withSize(47, 40);

    /** The light is that of a picture of this size, drawn small: small pictures have less light of their own. */
    private static final RenderSettings LARGE = RenderSettings.DEFAULT.withSize(470, 400);
    private static final double[] MOST_ERRORS = {Double.POSITIVE_INFINITY, 4, 2, 1};
    private static final int ALL_BOUNCES = 1000;
    private static final double STEPS = 255;
    private static final double NANOSECONDS_IN_MILLISECOND = 1e6;

    private AmbientErrors() {
    }

    private static int rootForPictures(Effort effort) {
        return effort == Effort.FULL ? 32 : 12;
    }

    /** A mean has the rays of nearly two thousand pixels. */
    private static int rootForMeans(Effort effort) {
        return effort == Effort.FULL ? 16 : 8;
    }

    private static int seeds(Effort effort) {
        return effort == Effort.FULL ? 10 : 3;
    }

    /** What a picture gains: none, one colour, light that varies. */
    static String pictures(Effort effort) throws IOException, RayTracerException {
        List<List<String>> rows = new ArrayList<>();
        for (Map.Entry<String, Scene> room : AmbientRoom.scenes().entrySet()) {
            rows.add(pictureRow(room.getKey(), room.getValue(), effort));
        }
        return """
            Root mean square errors of the picture in steps of 1/255 against brute force,
                which follows thousands of paths for each pixel,
            and times of warm frames at 500 x 500,
                median (quartiles). *One colour* is what the estimate is worth without its places: the
            same rays, and nearly the same time.

            """ + MarkdownTable.of(List.of("scene", "no ambient light: RMSE", "one colour: RMSE", "light that varies: RMSE",
            "frame without, ms", "the estimate, ms", "frame in one colour, ms", "in light that varies, ms"), rows);
    }

    private static List<String> pictureRow(String title, Scene scene, Effort effort) {
        AmbientPart truth = truth(scene, 1, ALL_BOUNCES, rootForPictures(effort));
        AmbientPart sameTruth = truth(scene, 2, ALL_BOUNCES, rootForPictures(effort));
        Renderer renderer = Renderers.inAmbientLight(Renderers.of(scene, SMALL), Renderers.of(scene, LARGE).ambientLight());
        AmbientLight even = AmbientLight.even(renderer.ambientLight().mean());
        System.out.println("Ambient light of " + title);
        Renderer large = Renderers.of(scene, RenderSettings.DEFAULT);
        Renderer largeEven = Renderers.inAmbientLight(large, even);
        Renderer largeWithout = Renderers.inAmbientLight(large, AmbientLight.NONE);
        long start = System.nanoTime();
        while (System.nanoTime() - start < effort.warmUpNanoseconds()) {
            Renderers.film(large);
            Renderers.film(largeEven);
            Renderers.film(largeWithout);
            Renderers.of(scene, RenderSettings.DEFAULT);
        }
        List<List<Double>> times = List.of(new ArrayList<>(), new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
        for (int round = 0; round < 3 * effort.frames(); round++) {
            times.get(0).add(milliseconds(() -> Renderers.film(largeWithout)));
            times.get(1).add(milliseconds(() -> Renderers.of(scene, RenderSettings.DEFAULT)));
            times.get(2).add(milliseconds(() -> Renderers.film(largeEven)));
            times.get(3).add(milliseconds(() -> Renderers.film(large)));
        }
        List<String> cells = new ArrayList<>(List.of(title,
            steps(AmbientPart.drawn(renderer, AmbientLight.even(Color.BLACK)).errorAgainst(truth, sameTruth)),
            steps(AmbientPart.drawn(renderer, even).errorAgainst(truth, sameTruth)),
            steps(AmbientPart.drawn(renderer, renderer.ambientLight()).errorAgainst(truth, sameTruth))));
        for (List<Double> series : times) {
            Quantiles quantiles = Quantiles.of(series);
            cells.add(String.format(Locale.ROOT, "%.0f (%.0f - %.0f)", quantiles.median(), quantiles.lower(),
                quantiles.upper()));
        }
        return cells;
    }

    /** What is left of the error for each that is asked for, and what the estimate says of it. */
    static String refinement(Effort effort) throws IOException, RayTracerException {
        List<List<String>> rows = new ArrayList<>();
        for (Map.Entry<String, Scene> room : AmbientRoom.scenes().entrySet()) {
            Scene scene = room.getValue();
            AmbientPart truth = truth(scene, 1, ALL_BOUNCES, rootForPictures(effort));
            AmbientPart sameTruth = truth(scene, 2, ALL_BOUNCES, rootForPictures(effort));
            Renderer renderer = Renderers.of(scene, SMALL);
            AmbientPart without = AmbientPart.drawnWithout(renderer);
            for (double mostError : MOST_ERRORS) {
                AmbientLight light = light(scene, renderer, mostError, 1);
                AmbientPart part = AmbientPart.drawn(renderer, light);
                AmbientPart again = AmbientPart.drawn(renderer, light(scene, renderer, mostError, 2));
                double error = part.shownOver(without).errorAgainst(truth.shownOver(without), sameTruth.shownOver(without));
                rows.add(List.of(room.getKey(), mostError == MOST_ERRORS[0] ? "none" : String.valueOf((int) mostError),
                    steps(part.errorAgainst(truth, sameTruth)), steps(error),
                    String.format(Locale.ROOT, "%.1f", light.error()), steps(part.errorAgainst(again, again)),
                    String.valueOf(light.recordCount()), String.valueOf(light.pathCount())));
            }
            System.out.println("Refined " + room.getKey());
        }
        return """
            Root mean square errors in steps of 1/255. *Shown* is cut to what 8-bit channels show; *estimated* is what the
            program says of it. The next is the difference between the pictures of two seeds.

            """ + MarkdownTable.of(List.of("scene", "error asked for", "error", "error, shown", "estimated", "seed to seed",
            "places", "paths"), rows);
    }

    private static AmbientLight light(Scene scene, Renderer renderer, double mostError, long seed) {
        return AmbientEstimate.of(scene, renderer.surfaces(), LARGE.width(), LARGE.height(), seed, mostError,
            new ForkJoin(LARGE.threads(), new Preparation()));
    }

    private static double milliseconds(Runnable work) {
        long start = System.nanoTime();
        work.run();
        return (System.nanoTime() - start) / NANOSECONDS_IN_MILLISECOND;
    }

    private static AmbientPart truth(Scene scene, int seed, int bounces, int root) {
        return AmbientPart.byBruteForce(scene, SMALL.withSeed(seed), bounces, root);
    }

    /** The one colour beside the mean of the truth, over some seeds. */
    static String section(Effort effort) throws IOException, RayTracerException {
        List<List<String>> rows = new ArrayList<>();
        for (Map.Entry<String, Scene> room : AmbientRoom.scenes().entrySet()) {
            rows.add(meanRow(room.getKey(), AmbientScenes.withWhiteAmbient(room.getValue()), effort));
        }
        return String.format(Locale.ROOT,
            "The one colour of the whole room beside the mean of the truth: %d x %d pixels with %d x %d rays "
            + "and all bounces.\nErrors are of the worst channel; median and largest of the seeds 1 to %d.\n\n",
            SMALL.width(), SMALL.height(), rootForMeans(effort), rootForMeans(effort), seeds(effort))
            + MarkdownTable.of(List.of("scene", "truth, red green blue", "of it by one bounce", "estimate, seed 1",
                "places", "error, median, %", "error, largest, %"), rows);
    }

    private static List<String> meanRow(String title, Scene white, Effort effort) {
        double[] truth = truth(white, 1, ALL_BOUNCES, rootForMeans(effort)).mean();
        double[] once = truth(white, 1, 1, rootForMeans(effort)).mean();
        List<Double> errors = new ArrayList<>();
        for (int seed = 1; seed <= seeds(effort); seed++) {
            Renderer renderer = Renderers.of(white, SMALL.withSeed(seed));
            double[] mean = AmbientPart.drawn(renderer, AmbientLight.even(renderer.ambientLight().mean())).mean();
            double worst = 0;
            for (int channel = 0; channel < mean.length; channel++) {
                worst = Math.max(worst, Math.abs(mean[channel] / truth[channel] - 1));
            }
            errors.add(100 * worst);
        }
        AmbientLight light = Renderers.of(white, SMALL).ambientLight();
        Color mean = light.mean();
        System.out.println("Mean of " + title);
        return List.of(title, String.format(Locale.ROOT, "%.3f %.3f %.3f", truth[0], truth[1], truth[2]),
            String.format(Locale.ROOT, "%.0f %%", 100 * (once[0] + once[1] + once[2]) / (truth[0] + truth[1] + truth[2])),
            String.format(Locale.ROOT, "%.3f %.3f %.3f", mean.red(), mean.green(), mean.blue()),
            String.valueOf(light.recordCount()),
            String.format(Locale.ROOT, "%.1f", Quantiles.of(errors).median()),
            String.format(Locale.ROOT, "%.1f", errors.stream().max(Double::compare).orElseThrow()));
    }

    private static String steps(double error) {
        return String.format(Locale.ROOT, "%.1f", STEPS * error);
    }
}
