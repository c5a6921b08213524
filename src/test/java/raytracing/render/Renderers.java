package raytracing.render;

import java.util.Set;
import raytracing.ambient.AmbientLight;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.parallel.Preparation;
import raytracing.scene.Scene;
import raytracing.trace.Shortcut;

/** Short ways to films, and to pictures that the program does not draw. */
public final class Renderers {
    private Renderers() {
    }

    /** Without a reader of how far the preparation is. */
    public static Renderer of(Scene scene, RenderSettings settings) {
        return Renderer.of(scene, settings, new Preparation());
    }

    /** With some of the shortcuts only. */
    public static Renderer withShortcuts(Scene scene, RenderSettings settings, Set<Shortcut> shortcuts) {
        return Renderer.of(scene, settings, shortcuts, new Preparation());
    }

    /** The same with another ambient light than the one that was estimated. */
    public static Renderer inAmbientLight(Renderer renderer, AmbientLight light) {
        return with(renderer, renderer.settings(), light);
    }

    /** The same prepared scene in the same ambient light, for another way to draw it. */
    public static Renderer withSampling(Renderer renderer, PixelSampling sampling) {
        return with(renderer, renderer.settings().withSampling(sampling), renderer.ambientLight());
    }

    static Renderer with(Renderer renderer, RenderSettings settings, AmbientLight light) {
        return new Renderer(settings, renderer.scene(), renderer.cameraRays(), renderer.surfaces(), light,
            renderer.arrangingNanoseconds(), renderer.ambientNanoseconds());
    }

    /** The same for a part of the picture, without preparing the scene again. */
    public static Renderer inRegion(Renderer renderer, Region region) {
        return with(renderer, renderer.settings().withRegion(region), renderer.ambientLight());
    }

    /** All of the region on one film. */
    public static Film film(Renderer renderer) {
        return Rendering.of(renderer).film();
    }

    /** The whole picture on one film. */
    public static Film film(Scene scene, RenderSettings settings) {
        return film(of(scene, settings));
    }

    /** One pixel, drawn alone. */
    public static Color pixel(Renderer renderer, int x, int y) {
        RenderSettings settings = renderer.settings().withWorkers(1, 1).withRegion(new Region(x, y, x + 1, y + 1));
        return film(with(renderer, settings, renderer.ambientLight())).get(0, 0);
    }
}
