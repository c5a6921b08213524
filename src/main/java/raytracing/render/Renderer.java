package raytracing.render;

import java.util.EnumSet;
import java.util.Set;
import raytracing.color.Color;
import raytracing.compiled.CompiledScene;
import raytracing.compiled.OrdinaryLengths;
import raytracing.compiled.PixelRays;
import raytracing.compiled.Shortcut;
import raytracing.film.Film;
import raytracing.math.CounterRandom;
import raytracing.progress.Preparation;
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
    private final long compilingNanoseconds;
    private final long ambientNanoseconds;

    /**
     * Makes a scene ready to be drawn.
     *
     * @param scene what to draw
     * @param settings how
     */
    public Renderer(Scene scene, RenderSettings settings) {
        this(scene, settings, new Preparation());
    }

    /**
     * Makes a scene ready to be drawn while another thread asks how far it is.
     *
     * @param scene what to draw
     * @param settings how
     * @param preparation is told
     */
    public Renderer(Scene scene, RenderSettings settings, Preparation preparation) {
        this(scene, settings, EnumSet.allOf(Shortcut.class), preparation);
    }

    /**
     * Makes a scene ready to be drawn with some of the shortcuts: to measure what each is worth.
     *
     * @param scene what to draw
     * @param settings how
     * @param shortcuts work to be skipped, which changes no bit of the picture
     */
    public Renderer(Scene scene, RenderSettings settings, Set<Shortcut> shortcuts) {
        this(scene, settings, shortcuts, new Preparation());
    }

    private Renderer(Scene scene, RenderSettings settings, Set<Shortcut> shortcuts, Preparation preparation) {
        preparation.begin(Preparation.Step.ARRANGING);
        long start = System.nanoTime();
        this.scene = OrdinaryLengths.of(scene);
        this.settings = settings;
        pixelRays = new PixelRays(this.scene.camera(), settings.width(), settings.height());
        ThreadWorkers workers = new ThreadWorkers(settings.threads(), preparation);
        compiled = new CompiledScene(this.scene, settings.shadowMode(), shortcuts, workers);
        long isCompiled = System.nanoTime();
        preparation.begin(Preparation.Step.AMBIENT_LIGHT);
        ambientLight =
            AmbientEstimate.of(this.scene, compiled, settings.width(), settings.height(), settings.seed(), workers);
        compilingNanoseconds = isCompiled - start;
        ambientNanoseconds = System.nanoTime() - isCompiled;
    }

    private Renderer(Renderer other, AmbientLight ambientLight) {
        settings = other.settings;
        scene = other.scene;
        pixelRays = other.pixelRays;
        compiled = other.compiled;
        compilingNanoseconds = other.compilingNanoseconds;
        ambientNanoseconds = other.ambientNanoseconds;
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
     * How long the scene took to be compiled: its arrays and hierarchies.
     *
     * @return wall time in nanoseconds
     */
    public long compilingNanoseconds() {
        return compilingNanoseconds;
    }

    /**
     * How long the ambient light took to be estimated.
     *
     * @return wall time in nanoseconds
     */
    public long ambientNanoseconds() {
        return ambientNanoseconds;
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
     * Draws the region of the settings, with as many threads as they say, while the calling one waits.
     *
     * @return the finished film, as large as the region
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
        Drawing drawing = new Drawing(this, settings, settings.region().height(), new Cancellation(),
            Cancellation.Leftovers.DISCARD, DrawingListener.NONE);
        return new Rendering(drawing.band(0), drawing.refinedPixels());
    }

    /**
     * Makes ready to draw the region of the settings in bands.
     *
     * @param cancellation ends it
     * @param leftovers what becomes of what is finished then
     * @param listener is told what the picture looks like
     * @return a drawing that has not begun
     */
    public Drawing drawing(Cancellation cancellation, Cancellation.Leftovers leftovers, DrawingListener listener) {
        return new Drawing(this, settings, Drawing.bandHeight(settings.region(), settings.tileSize()), cancellation,
            leftovers, listener);
    }

    private boolean hasOneRay() {
        return settings.sampling().root() == 1;
    }

    /** For one thread. */
    Shader shader() {
        return new Shader(scene, compiled, settings.shadowMethod(), ambientLight);
    }

    /** What stands where nothing was drawn. */
    Color background() {
        return scene.settings().background();
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
