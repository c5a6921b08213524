package raytracing;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import raytracing.film.Film;
import raytracing.parse.RayTracerException;
import raytracing.render.Cancellation;
import raytracing.render.Drawing;
import raytracing.render.DrawingListener;
import raytracing.render.Region;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.render.Renderers;

/** How well the share of a picture that is done tells how long all of it takes. */
final class Forecasts {
    private static final double[] SHARES = {0.05, 0.1, 0.25, 0.5};

    private Forecasts() {
    }

    /** Of the scenes of this project, warm. */
    static String section(int runs) throws IOException, RayTracerException {
        List<List<String>> rows = new ArrayList<>();
        double[] farthest = new double[SHARES.length];
        for (Path scene : SceneFiles.all().toList()) {
            Renderer renderer = Renderers.of(Steps.parseScene(scene), RenderSettings.DEFAULT);
            Renderers.film(renderer);
            List<String> row = new ArrayList<>(List.of(scene.getFileName().toString().replace(".txt", "")));
            List<List<Double>> ratios = new ArrayList<>();
            for (int i = 0; i < SHARES.length; i++) {
                ratios.add(new ArrayList<>());
            }
            for (int run = 0; run < runs; run++) {
                addRatios(renderer, ratios);
            }
            for (int i = 0; i < SHARES.length; i++) {
                double median = Quantiles.of(ratios.get(i)).median();
                farthest[i] = Math.max(farthest[i], Math.abs(median - 1));
                row.add(String.format(Locale.ROOT, "%.2f", median));
            }
            rows.add(row);
        }
        List<String> last = new ArrayList<>(List.of("farthest from 1"));
        for (double distance : farthest) {
            last.add(String.format(Locale.ROOT, "%.2f", distance));
        }
        rows.add(last);
        return MarkdownTable.of(List.of("foreseen at", "5 %", "10 %", "25 %", "50 %"), rows)
            + "\n500 x 500 pixels, warm, medians of " + runs + " frames.\n";
    }

    private static void addRatios(Renderer renderer, List<List<Double>> ratios) {
        Clock clock = new Clock();
        Drawing drawing = new Drawing(renderer, new Cancellation(), Cancellation.Leftovers.DISCARD, clock);
        clock.start(drawing);
        drawing.band(0);
        double all = clock.seconds();
        for (int i = 0; i < SHARES.length; i++) {
            ratios.get(i).add(clock.foreseen.get(i) / all);
        }
    }

    /** Foresees the whole time when each share is reached. */
    private static final class Clock implements DrawingListener {
        private final List<Double> foreseen = Collections.synchronizedList(new ArrayList<>());
        private long start;
        private Drawing drawing;

        void start(Drawing picture) {
            drawing = picture;
            start = System.nanoTime();
        }

        double seconds() {
            return (System.nanoTime() - start) / 1e9;
        }

        @Override
        public synchronized void showTile(Region tile, Film film, Region filmed) {
            while (foreseen.size() < SHARES.length && drawing.progress().share() >= SHARES[foreseen.size()]) {
                foreseen.add(seconds() / drawing.progress().share());
            }
        }
    }
}
