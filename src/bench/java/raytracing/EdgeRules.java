package raytracing;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import raytracing.ambient.AmbientLight;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.parse.RayTracerException;
import raytracing.render.PixelGrid;
import raytracing.render.RenderSettings;
import raytracing.scene.CameraRays;
import raytracing.scene.Scene;
import raytracing.shade.Shader;
import raytracing.shadow.ShadowMethod;
import raytracing.trace.PreparedScene;
import raytracing.trace.Queries;
import raytracing.trace.ShadowMode;

/**
 * What other rules for edges would find and leave. A refined pixel has the light of the picture with N x N rays
 * everywhere, any other that of one ray; so all rules can be tried on two pictures.
 */
final class EdgeRules {
    private static final List<TimedScene> SCENES = List.of(TimedScene.ROOM, TimedScene.BUBBLES, TimedScene.BOXES,
        TimedScene.CAROUSEL, TimedScene.ECLIPSE, TimedScene.FISHEYE_SCENE, TimedScene.INSIDE_SPHERE, TimedScene.MIRRORS,
        TimedScene.SUNFLOWER, TimedScene.THREE_LAMPS);
    private static final int SIZE = 200;
    private static final int ROOT = 4;
    private static final int ROOT_OF_REFERENCE = 16;
    private static final double STEP = 1 / 255.0;
    private static final List<Double> CONTRASTS = List.of(2.0, 4.0, 8.0, 16.0, 32.0, Double.POSITIVE_INFINITY);

    private EdgeRules() {
    }

    private enum Looks { AT_COLOURS, AT_COLOURS_AND_SURFACES }

    /** Sums over the scenes. */
    private static final class Outcome {
        private double refined;
        private double toEverywhere;
        private double toReference;
    }

    static String section(Effort effort) throws IOException, RayTracerException {
        List<TimedScene> scenes = effort == Effort.FULL ? SCENES : SCENES.subList(0, 2);
        Outcome[][] outcomes = new Outcome[CONTRASTS.size()][Looks.values().length];
        for (Outcome[] row : outcomes) {
            for (int i = 0; i < row.length; i++) {
                row[i] = new Outcome();
            }
        }
        for (TimedScene scene : scenes) {
            measure(scene.scene(), outcomes);
            System.out.println("Edges of " + scene.title());
        }
        List<List<String>> rows = new ArrayList<>();
        for (int i = 0; i < CONTRASTS.size(); i++) {
            for (Looks looks : Looks.values()) {
                rows.add(cells(CONTRASTS.get(i), looks, outcomes[i][looks.ordinal()], scenes.size()));
            }
        }
        return String.format(Locale.ROOT,
            "Means over %d of our scenes, %d x %d pixels, exact shadows, N = %d. RMS in steps of "
            + "1/255 of linear light cut off at 1,\nagainst N x N rays in all pixels and against %d x %d of them.\n\n",
            scenes.size(), SIZE, SIZE, ROOT, ROOT_OF_REFERENCE, ROOT_OF_REFERENCE)
            + MarkdownTable.of(List.of("neighbours differ by more than", "refined, %", "RMS to everywhere",
                "RMS to " + ROOT_OF_REFERENCE + " x " + ROOT_OF_REFERENCE), rows);
    }

    private static List<String> cells(double contrast, Looks looks, Outcome outcome, int scenes) {
        String rule = Double.isInfinite(contrast) ? "" : String.format(Locale.ROOT, "%.0f/255", contrast);
        String surfaces = looks == Looks.AT_COLOURS ? "" : rule.isEmpty() ? "the surfaces seen" : " or in the surfaces seen";
        return List.of(rule.isEmpty() && surfaces.isEmpty() ? "one ray in each pixel" : rule + surfaces,
            String.format(Locale.ROOT, "%.1f", 100 * outcome.refined / scenes),
            String.format(Locale.ROOT, "%.2f", outcome.toEverywhere / scenes),
            String.format(Locale.ROOT, "%.2f", outcome.toReference / scenes));
    }

    private static void measure(Scene scene, Outcome[][] outcomes) {
        RenderSettings settings = RenderSettings.DEFAULT.withSize(SIZE, SIZE).withShadowMethod(new ShadowMethod.Exact());
        Film one = Steps.renderScene(scene, settings);
        Film everywhere = everywhere(scene, settings, ROOT);
        Film reference = everywhere(scene, settings, ROOT_OF_REFERENCE);
        long[] fingerprints = fingerprints(scene);
        for (int i = 0; i < CONTRASTS.size(); i++) {
            for (Looks looks : Looks.values()) {
                add(outcomes[i][looks.ordinal()], one, everywhere, reference,
                    edges(one, fingerprints, CONTRASTS.get(i) * STEP, looks));
            }
        }
    }

    private static Film everywhere(Scene scene, RenderSettings settings, int root) {
        return Steps.renderScene(scene,
            settings.withSampling(new PixelGrid(root, PixelGrid.Where.EVERYWHERE)));
    }

    private static long[] fingerprints(Scene scene) {
        PreparedScene prepared = Queries.prepared(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
        Shader shader = new Shader(scene, prepared, new ShadowMethod.Exact(), AmbientLight.NONE);
        CameraRays rays = new CameraRays(scene.camera(), SIZE, SIZE);
        long[] fingerprints = new long[SIZE * SIZE];
        for (int i = 0; i < fingerprints.length; i++) {
            shader.light(rays, i % SIZE + 0.5, i / SIZE + 0.5, 1);
            fingerprints[i] = shader.fingerprint();
        }
        return fingerprints;
    }

    private static boolean[] edges(Film one, long[] fingerprints, double contrast, Looks looks) {
        boolean[] isEdge = new boolean[SIZE * SIZE];
        for (int i = 0; i < isEdge.length; i++) {
            int x = i % SIZE;
            int y = i / SIZE;
            for (int v = Math.max(y - 1, 0); v < Math.min(y + 2, SIZE); v++) {
                for (int u = Math.max(x - 1, 0); u < Math.min(x + 2, SIZE); u++) {
                    isEdge[i] |= one.contrast(x, y, u, v) > contrast
                        || looks == Looks.AT_COLOURS_AND_SURFACES && fingerprints[i] != fingerprints[v * SIZE + u];
                }
            }
        }
        return isEdge;
    }

    private static void add(Outcome outcome, Film one, Film everywhere, Film reference, boolean[] isEdge) {
        Film refined = one.part(0, 0, one.width(), one.height());
        int count = 0;
        for (int i = 0; i < isEdge.length; i++) {
            if (isEdge[i]) {
                Color light = everywhere.get(i % SIZE, i / SIZE);
                refined.set(i % SIZE, i / SIZE, light.red(), light.green(), light.blue());
                count++;
            }
        }
        outcome.refined += (double) count / isEdge.length;
        outcome.toEverywhere += Films.rootMeanSquare(refined, everywhere) / STEP;
        outcome.toReference += Films.rootMeanSquare(refined, reference) / STEP;
    }
}
