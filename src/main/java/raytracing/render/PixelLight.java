package raytracing.render;

import java.util.Optional;
import raytracing.color.MutableColor;
import raytracing.film.Film;
import raytracing.math.CounterRandom;
import raytracing.shade.RayCounts;
import raytracing.shade.Shader;

/** The light of single pixels: a function of the pixel alone. Not thread-safe: each thread has its own. */
final class PixelLight {
    /** An odd number whose bits are well mixed. */
    private static final long DETAIL_FACTOR = 0x9e3779b97f4a7c15L;

    private final Shader shader;
    private final Renderer renderer;
    private Optional<AdaptivePixel> adaptive = Optional.empty();
    private int x;
    private int y;
    private long key;
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
        if (adaptive.isPresent()) {
            adaptive.get().tally().clear();
        }
    }

    /** The light of the one ray through a pixel's centre; overwritten by the next. */
    MutableColor ofOneRay(int column, int row) {
        beginPixel(column, row);
        return shader.light(renderer.cameraRays(), x + 0.5, y + 0.5, key);
    }

    /** Begins with the rays of another pixel. */
    void beginPixel(int column, int row) {
        x = column;
        y = row;
        key = CounterRandom.bits(CounterRandom.bits(renderer.settings().seed(), x), y);
    }

    /** The key of the random numbers of this pixel. */
    long key() {
        return key;
    }

    /**
     * The light of one of many rays through this pixel; overwritten by the next.
     *
     * @param right distance from the pixel's left edge, in pixels
     * @param down distance from its upper edge, in pixels
     * @param number of the ray among those of the pixel, which gives it random numbers of its own
     */
    MutableColor ofRay(double right, double down, int number) {
        return shader.light(renderer.cameraRays(), x + right, y + down, CounterRandom.bits(key, number));
    }

    /** A hash of the surfaces that the last ray met, in mirrors and behind glass too. */
    long fingerprint() {
        return shader.fingerprint();
    }

    /** A hash of the surfaces that the last ray met before any mirror. */
    long directFingerprint() {
        return shader.directFingerprint();
    }

    /** A hash of all surfaces that the last ray met, and of the lights that reached them. */
    long detailFingerprint() {
        return DETAIL_FACTOR * shader.fingerprint() + shader.shadowFingerprint();
    }

    /** Whether the last ray led to mirrored rays. */
    boolean isMirrorSeen() {
        return shader.isMirrorSeen();
    }

    /** How far the last ray was from the edge of a sharp highlight: see {@link Shader#highlightMargin}. */
    double highlightMargin() {
        return shader.highlightMargin();
    }

    /** What gives pixels their rays under an error limit. */
    AdaptivePixel adaptive() {
        if (adaptive.isEmpty()) {
            adaptive = Optional.of(new AdaptivePixel(this, renderer, (ErrorLimit) renderer.settings().sampling()));
        }
        return adaptive.get();
    }

    /**
     * Exposes a pixel of a film with the mean of a pixel's N x N rays, each with its own random numbers. The light of each ray
     * is cut off at 1 before the mean: otherwise the edge of what is much brighter than 1 would be as jagged as with one ray.
     */
    void exposeRefined(PixelGrid grid, int pixelX, int pixelY, Film film, int column, int row) {
        int root = grid.root();
        beginPixel(pixelX, pixelY);
        double red = 0;
        double green = 0;
        double blue = 0;
        for (int j = 0; j < root; j++) {
            for (int i = 0; i < root; i++) {
                MutableColor light = ofRay(grid.placeX(i, j), grid.placeY(i, j), j * root + i);
                red += Film.shown(light.red());
                green += Film.shown(light.green());
                blue += Film.shown(light.blue());
            }
        }
        double rays = root * root;
        film.set(column, row, red / rays, green / rays, blue / rays);
        refinedPixels++;
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
