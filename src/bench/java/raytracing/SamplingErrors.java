package raytracing;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import raytracing.parse.RayTracerException;
import raytracing.render.RenderSettings;
import raytracing.scene.Scene;
import raytracing.scene.Settings;

/** The error that the time has bought: pictures against others of the same scenes with 16 times the shadow rays. */
final class SamplingErrors {
    static final int SIZE = 250;
    static final int FACTOR = 4;

    private static final long OTHER_SEED = RenderSettings.DEFAULT_SEED + 1;

    private SamplingErrors() {
    }

    /** A row for every scene with soft shadows: hard ones have nothing to sample. */
    static String table(List<TimedScene> scenes) throws IOException, RayTracerException {
        List<List<String>> rows = new ArrayList<>();
        for (TimedScene timed : scenes) {
            Scene scene = timed.scene();
            if (scene.settings().shadowRayRoot() > 1) {
                rows.add(row(timed.title(), scene));
            }
        }
        return MarkdownTable.of(
            List.of("scene", "N", "RMS, steps", "largest, steps", "pixels off by more than a step, %"), rows);
    }

    private static List<String> row(String title, Scene scene) {
        int root = scene.settings().shadowRayRoot();
        PictureDifference difference = new PictureDifference(
            picture(scene, RenderSettings.DEFAULT_SEED), picture(sampled(scene, FACTOR * root), OTHER_SEED));
        System.out.println("Error of " + title + ": " + difference);
        return List.of(title, String.valueOf(root),
            String.format(Locale.ROOT, "%.2f", difference.rootMeanSquare()), String.valueOf(difference.largest()),
            String.format(Locale.ROOT, "%.1f", 100 * difference.shareOffByMoreThan(1)));
    }

    private static BufferedImage picture(Scene scene, long seed) {
        RenderSettings settings = RenderSettings.DEFAULT.withSize(SIZE, SIZE).withSeed(seed);
        return Steps.renderScene(scene, settings).toImage();
    }

    private static Scene sampled(Scene scene, int root) {
        Settings old = scene.settings();
        Settings settings = new Settings(old.background(), root, old.maxReflections(), old.ambientScale());
        return new Scene(scene.camera(), settings, scene.materials(), scene.surfaces(), scene.lights());
    }
}
