package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import raytracing.estimate.AmbientScenes;
import raytracing.parse.RayTracerException;
import raytracing.scene.Scene;
import raytracing.scene.Settings;
import raytracing.timed.SceneLines;
import raytracing.timed.Spread;

/** What ambient light costs whole processes, from a cold start: the same scene with a scale of 1 and of 0, in turn. */
final class AmbientTimes {
    private static final List<TimedScene> OTHERS = List.of(TimedScene.POOL, TimedScene.SPHERES, TimedScene.BUBBLES,
        TimedScene.FLAKE_7381);

    private AmbientTimes() {
    }

    static String section(Effort effort, Path folder) throws IOException, RayTracerException {
        List<List<String>> rows = new ArrayList<>();
        for (Map.Entry<String, Scene> room : AmbientRoom.scenes().entrySet()) {
            rows.add(row(room.getKey(), room.getValue(), effort, folder));
        }
        for (TimedScene timed : OTHERS) {
            if (timed.isThere()) {
                rows.add(row(timed.title() + ", all diffuse colours ambient too",
                    AmbientScenes.withAmbientColors(timed.scene()), effort, folder));
            }
        }
        return "Whole processes, 500 x 500, " + effort.pairs() + " pairs in turn; median (least - most). The estimate alone is "
            + "timed in processes\nthat draw nothing after it, and so do not profit from what it has warmed up.\n\n"
            + MarkdownTable.of(List.of("scene", "without, s", "with, s", "more, s", "with / without",
                "the estimate, s"), rows);
    }

    private static List<String> row(String title, Scene scene, Effort effort, Path folder) throws IOException {
        Path with = Files.writeString(folder.resolve("with.txt"), SceneLines.of(scaled(scene, 1)));
        Path without = Files.writeString(folder.resolve("without.txt"), SceneLines.of(scaled(scene, 0)));
        List<Double> withSeconds = new ArrayList<>();
        List<Double> withoutSeconds = new ArrayList<>();
        List<Double> differences = new ArrayList<>();
        List<Double> ratios = new ArrayList<>();
        List<Double> estimates = new ArrayList<>();
        for (int pair = 0; pair < effort.pairs(); pair++) {
            double a = seconds(with, folder);
            double b = seconds(without, folder);
            withSeconds.add(a);
            withoutSeconds.add(b);
            differences.add(a - b);
            ratios.add(a / b);
            estimates.add(ColdEstimate.seconds(with) - ColdEstimate.seconds(without));
        }
        System.out.println("Cold " + title);
        return List.of(title, shown(withoutSeconds), shown(withSeconds), shown(differences), shown(ratios),
            shown(estimates));
    }

    private static Scene scaled(Scene scene, double ambientScale) {
        Settings old = scene.settings();
        return new Scene(scene.camera(),
            new Settings(old.background(), old.shadowRayRoot(), old.maxReflections(), ambientScale), scene.materials(),
            scene.surfaces(), scene.lights());
    }

    private static double seconds(Path scene, Path folder) throws IOException {
        return MeasuredProcess.run(MeasuredProcess.program(scene.toString(),
            folder.resolve("picture.png").toString())).wallSeconds();
    }

    private static String shown(List<Double> values) {
        return Spread.of(values).orElseThrow().shown(2);
    }
}
