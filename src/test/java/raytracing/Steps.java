package raytracing;

import java.io.IOException;
import java.nio.file.Path;
import raytracing.film.Film;
import raytracing.parallel.ForkJoin;
import raytracing.parallel.Preparation;
import raytracing.parse.RayTracerException;
import raytracing.parse.SceneParser;
import raytracing.render.Cancellation;
import raytracing.render.Drawing;
import raytracing.render.DrawingListener;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.scene.Scene;

/** The first two steps of the program without messages, and the picture as one film. */
public final class Steps {
    private Steps() {
    }

    public static Scene parseScene(Path file) throws RayTracerException, IOException {
        return SceneParser.parseFile(file, ForkJoin.sequential()).scene();
    }

    /** The finished picture, which must be small enough for one band. */
    public static Film renderScene(Scene scene, RenderSettings settings) {
        Drawing drawing = new Drawing(Renderer.of(scene, settings, new Preparation()), new Cancellation(),
            Cancellation.Leftovers.DISCARD, DrawingListener.NONE);
        if (drawing.count() != 1) {
            throw new IllegalArgumentException("a picture of " + drawing.count() + " bands is too large for one film");
        }
        return drawing.band(0);
    }
}
