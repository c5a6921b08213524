package raytracing.nasty;

import java.util.Optional;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.render.RenderSettings;
import raytracing.render.Renderers;
import raytracing.scene.Scene;

/** Draws small pictures of nasty scenes and finds what is wrong with them. */
final class NastyDrawing {
    /** Edge of the picture in pixels. */
    static final int SIZE = 16;

    private NastyDrawing() {
    }

    /** The defect of a picture, if there is one: an exception, or a pixel that is no finite light of at least 0. */
    static Optional<String> defect(NastyScene scene) {
        return defect(scene.scene(), scene.settings());
    }

    /** The same of any scene. */
    static Optional<String> defect(Scene scene, RenderSettings settings) {
        try {
            return defect(Renderers.film(scene, settings));
        } catch (RuntimeException | StackOverflowError thrown) {
            return Optional.of(thrown.toString());
        }
    }

    private static Optional<String> defect(Film film) {
        for (int y = 0; y < film.height(); y++) {
            for (int x = 0; x < film.width(); x++) {
                Color color = film.get(x, y);
                if (!isLight(color.red()) || !isLight(color.green()) || !isLight(color.blue())) {
                    return Optional.of("pixel " + x + ", " + y + " is " + color);
                }
            }
        }
        return Optional.empty();
    }

    private static boolean isLight(double channel) {
        return channel >= 0 && channel < Double.POSITIVE_INFINITY;
    }
}
