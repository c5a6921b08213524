package raytracing.render;

import raytracing.color.MutableColor;
import raytracing.film.Film;
import raytracing.math.CounterRandom;
import raytracing.shade.RayCounts;
import raytracing.shade.Shader;

/** The light of single pixels: a function of the pixel alone. Not thread-safe: each thread has its own. */
final class PixelLight {
    private final Shader shader;
    private final Renderer renderer;
    private long refinedPixels;

    PixelLight(Renderer renderer) {
        this.renderer = renderer;
        shader = new Shader(renderer.scene(), renderer.surfaces(), renderer.settings().shadowMethod(),
            renderer.ambientLight());
    }

    /** Forgets the pixels before, so that the counts of a tile do not depend on what this thread drew before it. */
    void beginTile() {
        shader.forgetPast();
        refinedPixels = 0;
    }

    /** The light of the one ray through a pixel's centre; overwritten by the next. */
    MutableColor ofOneRay(int x, int y) {
        return shader.light(renderer.cameraRays(), x + 0.5, y + 0.5, key(x, y));
    }

    /** A hash of the surfaces that the last ray met, in mirrors and behind glass too. */
    long fingerprint() {
        return shader.fingerprint();
    }

    /**
     * Exposes a pixel of a film with the mean of a pixel's N x N rays, each with its own random numbers. The light of each ray
     * is cut off at 1 before the mean: otherwise the edge of what is much brighter than 1 would be as jagged as with one ray.
     */
    void exposeRefined(int x, int y, Film film, int column, int row) {
        PixelSampling sampling = renderer.settings().sampling();
        int root = sampling.root();
        long key = key(x, y);
        double red = 0;
        double green = 0;
        double blue = 0;
        for (int j = 0; j < root; j++) {
            for (int i = 0; i < root; i++) {
                MutableColor light = shader.light(renderer.cameraRays(), x + sampling.placeX(i, j),
                    y + sampling.placeY(i, j), CounterRandom.bits(key, j * root + i));
                red += Film.shown(light.red());
                green += Film.shown(light.green());
                blue += Film.shown(light.blue());
            }
        }
        double rays = root * root;
        film.set(column, row, red / rays, green / rays, blue / rays);
        refinedPixels++;
    }

    /** The key of a pixel's random numbers. */
    private long key(int x, int y) {
        return CounterRandom.bits(CounterRandom.bits(renderer.settings().seed(), x), y);
    }

    /** How many pixels of this tile got N x N rays. */
    long refinedPixels() {
        return refinedPixels;
    }

    /** What all rays so far took. */
    RayCounts counts() {
        return shader.counts();
    }
}
