package raytracing;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import raytracing.film.Film;
import raytracing.parse.RayTracerException;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.render.Renderers;
import raytracing.scene.Scene;
import raytracing.shadow.ShadowMethod;
import raytracing.timed.Spread;

/** Whole pictures with exact shadows beside those with sampled ones: their errors, and their times in turn. */
final class ShadowPictures {
    static final List<TimedScene> SCENES = List.of(TimedScene.SPHERES, TimedScene.POOL, TimedScene.ROOM, TimedScene.BUBBLES,
        TimedScene.BOXES, TimedScene.CAROUSEL, TimedScene.ECLIPSE, TimedScene.FISHEYE_SCENE, TimedScene.INSIDE_SPHERE,
        TimedScene.SUNFLOWER, TimedScene.THREE_LAMPS, TimedScene.NEST);

    private static final int SIZE = 150;
    private static final int PEERS_ROOT = 5;
    private static final int ROOT_OF_REFERENCE = 64;
    private static final double VISIBLE = 1 / 512.0;
    private static final ShadowMethod EXACT = new ShadowMethod.Exact();
    private static final ShadowMethod SAMPLED = ShadowMethod.Sampled.withRoot(PEERS_ROOT);

    private ShadowPictures() {
    }

    static String section(Effort effort, Path folder) throws IOException, RayTracerException {
        int runs = effort == Effort.FULL ? 8 : 2;
        List<List<String>> rows = new ArrayList<>();
        for (TimedScene scene : SCENES) {
            if (scene.isThere()) {
                rows.add(row(scene, runs, effort, folder));
            }
        }
        return String.format(Locale.ROOT,
            "%d x %d pixels, linear light cut off at 1. The reference is the mean of %d runs with "
            + "%d x %d shadow rays; its own error is\nwhat their spread shows. Times: frames of that size in a warm process, and "
            + "whole cold processes at 500 x 500, exact\nover N = %d, %d pairs in turn; median (least - most).\n\n",
            SIZE, SIZE, runs, ROOT_OF_REFERENCE, ROOT_OF_REFERENCE, PEERS_ROOT, effort.pairs())
            + MarkdownTable.of(List.of("scene", "N = " + PEERS_ROOT + ", RMS", "exact, RMS", "reference's own",
                "exact, largest",
                "exact, pixels off by more than 1/512, %", "warm time, exact / N = " + PEERS_ROOT,
                "cold time, exact / N = " + PEERS_ROOT), rows);
    }

    private static List<String> row(TimedScene timed, int runs, Effort effort, Path folder)
            throws IOException, RayTracerException {
        Scene scene = timed.scene();
        RenderSettings settings = RenderSettings.DEFAULT.withSize(SIZE, SIZE);
        Film exact = Steps.renderScene(scene, settings.withShadowMethod(EXACT));
        Film sampled = Steps.renderScene(scene, settings.withShadowMethod(SAMPLED));
        List<Film> references = new ArrayList<>();
        for (int run = 1; run <= runs; run++) {
            references.add(Steps.renderScene(scene, settings.withSeed(RenderSettings.DEFAULT_SEED + run)
                .withShadowMethod(ShadowMethod.Sampled.withRoot(ROOT_OF_REFERENCE))));
        }
        Film mean = Films.mean(references);
        System.out.println("Picture of " + timed.title());
        return List.of(timed.title(), figure(Films.rootMeanSquare(sampled, mean)),
            figure(Films.rootMeanSquare(exact, mean)), figure(errorOfMean(references, mean)),
            figure(Films.largest(exact, mean)),
            String.format(Locale.ROOT, "%.3f", 100 * Films.shareOffByMoreThan(exact, mean, VISIBLE)),
            warmRatio(scene, settings, effort).shown(2), coldRatio(timed.file(folder), effort, folder).shown(2));
    }

    private static double errorOfMean(List<Film> films, Film mean) {
        double squares = 0;
        for (Film film : films) {
            double distance = Films.rootMeanSquare(film, mean);
            squares += distance * distance;
        }
        return Math.sqrt(squares / ((double) films.size() * (films.size() - 1)));
    }

    private static Spread warmRatio(Scene scene, RenderSettings settings, Effort effort) {
        Renderer exact = Renderers.of(scene, settings.withShadowMethod(EXACT));
        Renderer sampled = Renderers.of(scene, settings.withShadowMethod(SAMPLED));
        long start = System.nanoTime();
        while (System.nanoTime() - start < effort.warmUpNanoseconds()) {
            Renderers.film(exact);
            Renderers.film(sampled);
        }
        List<Double> ratios = new ArrayList<>();
        for (int pair = 0; pair < effort.pairs(); pair++) {
            double ours = nanoseconds(exact, effort);
            ratios.add(ours / nanoseconds(sampled, effort));
        }
        return Spread.of(ratios).orElseThrow();
    }

    /** Of a row of frames: one alone may meet somebody else's work. */
    private static double nanoseconds(Renderer renderer, Effort effort) {
        long start = System.nanoTime();
        int frames = 0;
        do {
            Renderers.film(renderer);
            frames++;
        } while (System.nanoTime() - start < effort.measuredNanoseconds() / 10);
        return (double) (System.nanoTime() - start) / frames;
    }

    private static Spread coldRatio(Path scene, Effort effort, Path folder) throws IOException {
        List<Double> ratios = new ArrayList<>();
        for (int pair = 0; pair < effort.pairs(); pair++) {
            double exact = seconds(scene, folder, "--shadows", "exact");
            ratios.add(exact / seconds(scene, folder, "--shadow-rays", String.valueOf(PEERS_ROOT)));
        }
        return Spread.of(ratios).orElseThrow();
    }

    private static double seconds(Path scene, Path folder, String option, String value) throws IOException {
        return MeasuredProcess.run(MeasuredProcess.program(scene.toString(),
            folder.resolve("picture.png").toString(), option, value)).wallSeconds();
    }

    private static String figure(double value) {
        return String.format(Locale.ROOT, "%.1e", value);
    }
}
