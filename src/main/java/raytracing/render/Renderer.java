package raytracing.render;

import java.util.EnumSet;
import java.util.Set;
import raytracing.ambient.AmbientLight;
import raytracing.estimate.AmbientEstimate;
import raytracing.parallel.ForkJoin;
import raytracing.parallel.Preparation;
import raytracing.scene.CameraRays;
import raytracing.scene.Scene;
import raytracing.trace.OrdinaryLengths;
import raytracing.trace.PreparedScene;
import raytracing.trace.Shortcut;

/**
 * A picture that has been prepared to be drawn: all that its pixels have in common. Each pixel depends only on its
 * coordinates, the scene and those settings that decide what is in the picture; so the film is the same for every number of
 * threads, tile size and region. Immutable.
 *
 * @param settings those that the picture was prepared for; sampling, region, threads and tile size may be others
 * @param scene with lengths of an ordinary size
 * @param cameraRays for the picture's size
 * @param surfaces of the scene
 * @param ambientLight that was estimated; {@link AmbientLight#NONE} if the scene has none
 * @param arrangingNanoseconds wall time of putting the surfaces in lists and hierarchies
 * @param ambientNanoseconds wall time of the estimate of ambient light
 */
public record Renderer(RenderSettings settings, Scene scene, CameraRays cameraRays, PreparedScene surfaces,
                       AmbientLight ambientLight, long arrangingNanoseconds, long ambientNanoseconds) {
    /** Prepares a picture on as many threads as the settings say; reports how far it is. */
    public static Renderer of(Scene scene, RenderSettings settings, Preparation preparation) {
        return of(scene, settings, EnumSet.allOf(Shortcut.class), preparation);
    }

    /** The same with some of the shortcuts only. */
    static Renderer of(Scene given, RenderSettings settings, Set<Shortcut> shortcuts, Preparation preparation) {
        preparation.begin(Preparation.Step.ARRANGING);
        long start = System.nanoTime();
        Scene scene = OrdinaryLengths.of(given);
        CameraRays cameraRays = new CameraRays(scene.camera(), settings.width(), settings.height());
        ForkJoin threads = new ForkJoin(settings.threads(), preparation);
        PreparedScene surfaces = new PreparedScene(scene, settings.shadowMode(), shortcuts, threads);
        long arranged = System.nanoTime();
        preparation.begin(Preparation.Step.AMBIENT_LIGHT);
        double mostError = settings.sampling() instanceof ErrorLimit limit ? limit.steps() : Double.POSITIVE_INFINITY;
        AmbientLight ambientLight =
            AmbientEstimate.of(scene, surfaces, settings.width(), settings.height(), settings.seed(), mostError, threads);
        return new Renderer(settings, scene, cameraRays, surfaces, ambientLight, arranged - start,
            System.nanoTime() - arranged);
    }
}
