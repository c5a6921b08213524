package raytracing.render;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import raytracing.color.Color;
import raytracing.compiled.CompiledScene;
import raytracing.compiled.PixelRays;
import raytracing.compiled.Shortcut;
import raytracing.film.Film;
import raytracing.math.CounterRandom;
import raytracing.scene.Scene;
import raytracing.shade.AmbientEstimate;
import raytracing.shade.AmbientLight;
import raytracing.shade.LightSum;
import raytracing.shade.Shader;

/**
 * Draws a scene, whose ambient light is estimated first. Every pixel depends on its own coordinates, the scene, and those
 * settings that decide what is in the picture alone: {@link #pixel} replays any of them, and the film is the same for
 * every number of threads and every tile size.
 */
public final class Renderer {
    private final RenderSettings settings;
    private final Scene scene;
    private final PixelRays pixelRays;
    private final CompiledScene compiled;
    private final AmbientLight ambientLight;

    /**
     * Makes a scene ready to be drawn.
     *
     * @param scene what to draw
     * @param settings how
     */
    public Renderer(Scene scene, RenderSettings settings) {
        this(scene, settings, EnumSet.allOf(Shortcut.class));
    }

    /**
     * Makes a scene ready to be drawn with some of the shortcuts: to measure what each is worth.
     *
     * @param scene what to draw
     * @param settings how
     * @param shortcuts work to be skipped, which changes no bit of the picture
     */
    public Renderer(Scene scene, RenderSettings settings, Set<Shortcut> shortcuts) {
        this.scene = scene;
        this.settings = settings;
        pixelRays = new PixelRays(scene.camera(), settings.width(), settings.height());
        ThreadWorkers workers = new ThreadWorkers(settings.threads());
        compiled = new CompiledScene(scene, settings.shadowMode(), shortcuts, workers);
        ambientLight = AmbientEstimate.of(scene, compiled, settings.width(), settings.height(), settings.seed(), workers);
    }

    private Renderer(Renderer other, AmbientLight ambientLight) {
        settings = other.settings;
        scene = other.scene;
        pixelRays = other.pixelRays;
        compiled = other.compiled;
        this.ambientLight = ambientLight;
    }

    /**
     * The same with another ambient light than the one that was estimated: to measure what that is worth.
     *
     * @param other any light
     * @return a renderer that draws in it
     */
    public Renderer inAmbientLight(AmbientLight other) {
        return new Renderer(this, other);
    }

    /**
     * The ambient light in which surfaces are drawn.
     *
     * @return what was estimated for the scene; {@link AmbientLight#NONE} if it asks for none
     */
    public AmbientLight ambientLight() {
        return ambientLight;
    }

    /**
     * The light of one pixel.
     *
     * @param x column, from 0 on the left
     * @param y row, from 0 at the top
     * @return linear light; black where the lens sees nothing
     */
    public Color pixel(int x, int y) {
        return hasOneRay() ? oneRay(shader(), x, y).total() : new SmoothEdges(this, settings).pixel(x, y);
    }

    /**
     * Draws the whole picture, with as many threads as the settings say; the calling one is one of them.
     *
     * @return the finished film
     * @throws IllegalStateException if a pixel failed, which is a defect of this program; names the pixel
     */
    public Film render() {
        return draw().film();
    }

    /**
     * Draws like {@link #render} and says what it took.
     *
     * @return the finished film and how much of it got more than one ray
     * @throws IllegalStateException if a pixel failed, which is a defect of this program; names the pixel
     */
    public Rendering draw() {
        if (!hasOneRay()) {
            return new SmoothEdges(this, settings).draw();
        }
        Film film = new Film(settings.width(), settings.height());
        TileQueue tiles = tiles();
        List<TileWorker> workers = new ArrayList<>();
        for (int i = 0; i < settings.threads(); i++) {
            workers.add(new TileWorker(this, film, tiles));
        }
        TileWorker.runAll(workers);
        return new Rendering(film, 0);
    }

    private boolean hasOneRay() {
        return settings.sampling().root() == 1;
    }

    /** For one thread. */
    Shader shader() {
        return new Shader(scene, compiled, settings.shadowMethod(), ambientLight);
    }

    /** All of the picture. */
    TileQueue tiles() {
        return new TileQueue(settings.width(), settings.height(), settings.tileSize());
    }

    /** The light of the ray through a pixel's centre. */
    LightSum oneRay(Shader shader, int x, int y) {
        return ray(shader, x + 0.5, y + 0.5, key(x, y));
    }

    /** The light of the ray through a place of the picture. */
    LightSum ray(Shader shader, double x, double y, long key) {
        return shader.light(pixelRays, x, y, key);
    }

    /** Key of a pixel's random numbers. */
    long key(int x, int y) {
        return CounterRandom.bits(CounterRandom.bits(settings.seed(), x), y);
    }
}
