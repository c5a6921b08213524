package raytracing.render;

import raytracing.shadow.ShadowMethod;
import raytracing.trace.ShadowMode;

/**
 * What the command line, not the scene, decides about a picture. The first six decide what is in it, and the region which part
 * of it is drawn.
 *
 * @param width of the picture in pixels, at least 1
 * @param height of the picture in pixels, at least 1
 * @param seed of all random numbers
 * @param shadowMode what transparent surfaces do to light that falls through them
 * @param shadowMethod how soft shadows are found
 * @param sampling how many rays of the eye a pixel gets
 * @param threads how many work at once, at least 1
 * @param tileSize edge of the squares that threads take in turn, in pixels, at least 1
 */
public record RenderSettings(int width, int height, long seed, ShadowMode shadowMode, ShadowMethod shadowMethod,
                             PixelSampling sampling, Region region, int threads, int tileSize) {
    /** Small enough that the last tiles end together, large enough that taking one costs next to nothing. */
    public static final int DEFAULT_TILE_SIZE = 16;

    /** Width and height unless the user says otherwise. */
    private static final int DEFAULT_SIZE = 500;

    /** Seed unless the user says otherwise. */
    public static final long DEFAULT_SEED = 1;

    /** What is drawn when the user names a scene and nothing else. */
    public static final RenderSettings DEFAULT = new RenderSettings(DEFAULT_SIZE, DEFAULT_SIZE, DEFAULT_SEED,
        ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT, ShadowMethod.OF_THE_SCENE, PixelGrid.ONE_RAY,
        Region.whole(DEFAULT_SIZE, DEFAULT_SIZE), Runtime.getRuntime().availableProcessors(), DEFAULT_TILE_SIZE);

    /** The same for another size, all of the picture. */
    public RenderSettings withSize(int newWidth, int newHeight) {
        return new RenderSettings(newWidth, newHeight, seed, shadowMode, shadowMethod, sampling,
            Region.whole(newWidth, newHeight), threads, tileSize);
    }

    public RenderSettings withSeed(long newSeed) {
        return new RenderSettings(width, height, newSeed, shadowMode, shadowMethod, sampling, region, threads, tileSize);
    }

    public RenderSettings withShadowMode(ShadowMode newShadowMode) {
        return new RenderSettings(width, height, seed, newShadowMode, shadowMethod, sampling, region, threads, tileSize);
    }

    public RenderSettings withShadowMethod(ShadowMethod newShadowMethod) {
        return new RenderSettings(width, height, seed, shadowMode, newShadowMethod, sampling, region, threads, tileSize);
    }

    public RenderSettings withSampling(PixelSampling newSampling) {
        return new RenderSettings(width, height, seed, shadowMode, shadowMethod, newSampling, region, threads, tileSize);
    }

    /** The same work shared differently. */
    public RenderSettings withWorkers(int newThreads, int newTileSize) {
        return new RenderSettings(width, height, seed, shadowMode, shadowMethod, sampling, region, newThreads, newTileSize);
    }

    public RenderSettings withRegion(Region newRegion) {
        return new RenderSettings(width, height, seed, shadowMode, shadowMethod, sampling, newRegion, threads, tileSize);
    }
}
