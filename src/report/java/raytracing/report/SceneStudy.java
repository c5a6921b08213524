package raytracing.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import raytracing.Steps;
import raytracing.ambient.AmbientLight;
import raytracing.parse.RayTracerException;
import raytracing.render.RenderSettings;
import raytracing.render.Renderers;
import raytracing.scene.Scene;

/**
 * Everything that was found out about one scene.
 *
 * @param title its file's name without the ending
 * @param scene what was drawn
 * @param ambientLight what was estimated for it
 * @param families the questions that concern it, with their answers
 * @param sampledSpeedUps shortcuts with the scene's own N
 * @param exactSpeedUps shortcuts with exact shadows
 * @param coldRuns whole processes
 */
record SceneStudy(String title, Scene scene, AmbientLight ambientLight, List<FamilyStudy> families,
                  List<SpeedUps.Row> sampledSpeedUps, List<SpeedUps.Row> exactSpeedUps, List<ColdRuns.Row> coldRuns) {
    static SceneStudy of(Path file, Budget budget, Progress progress) throws IOException, RayTracerException {
        Scene scene = Steps.parseScene(file);
        RenderSettings settings = settings(budget);
        AmbientLight ambientLight = Renderers.of(scene, settings).ambientLight();
        List<FamilyStudy> families = new ArrayList<>();
        for (Family family : Family.values()) {
            if (family.concerns(scene)) {
                families.add(FamilyStudy.of(family, scene, ambientLight, settings, budget, progress));
            }
        }
        SceneStudy study = new SceneStudy(title(file), scene, ambientLight, families,
            SpeedUps.measured(scene, settings, budget, progress),
            SpeedUps.measured(scene, Setting.exact().in(settings), budget, progress),
            ColdRuns.measured(file, budget, progress));
        progress.end();
        return study;
    }

    /** What all its settings have in common. */
    static RenderSettings settings(Budget budget) {
        return RenderSettings.DEFAULT.withSize(budget.size(), budget.size());
    }

    /** Its file's name without the ending. */
    static String title(Path file) {
        return file.getFileName().toString().replaceFirst("\\.txt$", "");
    }

    int shadowRoot() {
        return scene.settings().shadowRayRoot();
    }

    Optional<FamilyStudy> family(Family family) {
        return families.stream().filter(study -> study.family() == family).findFirst();
    }
}
