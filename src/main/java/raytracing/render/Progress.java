package raytracing.render;

import java.util.concurrent.atomic.AtomicLong;

/**
 * How far a picture is: the share of its rays of the eye that were sent. Thread-safe. How many pixels will get N x N rays is
 * known only at the end; until then it is estimated from the pixels so far, because tiles are dealt evenly over the picture.
 */
public final class Progress {
    /** Share of pixels on edges before any is known: between those of our scenes. */
    private static final double TYPICAL_SHARE_OF_EDGES = 0.15;

    /** Further rays for each pixel under an error limit, before any is known. */
    private static final double TYPICAL_UNDER_A_LIMIT = 5;

    private final long pixels;
    private final boolean areFirstRaysFinal;
    private final boolean hasFirstRays;
    private final double typicalRays;
    private final AtomicLong firstRays = new AtomicLong();
    private final AtomicLong smoothed = new AtomicLong();
    private final AtomicLong refined = new AtomicLong();
    private final AtomicLong furtherRays = new AtomicLong();

    Progress(long pixels, PixelSampling sampling) {
        this.pixels = pixels;
        if (sampling instanceof PixelGrid grid) {
            double rays = grid.root() * grid.root();
            boolean isEverywhere = grid.where() == PixelGrid.Where.EVERYWHERE;
            areFirstRaysFinal = grid.root() == 1;
            hasFirstRays = !isEverywhere || areFirstRaysFinal;
            typicalRays = areFirstRaysFinal ? 0 : isEverywhere ? rays : TYPICAL_SHARE_OF_EDGES * rays;
        } else {
            areFirstRaysFinal = false;
            hasFirstRays = true;
            typicalRays = TYPICAL_UNDER_A_LIMIT;
        }
    }

    /** Adds pixels that had their one ray. */
    void addFirstRays(long count) {
        firstRays.addAndGet(count);
    }

    /** Adds pixels that are final, after those of them that needed more rays had theirs. */
    void addSmoothed(long count, long refinedCount, long rays) {
        smoothed.addAndGet(count);
        refined.addAndGet(refinedCount);
        furtherRays.addAndGet(rays);
    }

    /** Pixels of the bands so far whose light is final. */
    public long finished() {
        return areFirstRaysFinal ? firstRays.get() : smoothed.get();
    }

    /** Pixels of the bands so far that got more rays than their first. */
    public long refined() {
        return refined.get();
    }

    /** Share of the rays that were sent, from 0 to 1; exactly 1 at the end. */
    public double share() {
        double further = smoothed.get() == 0 ? typicalRays * pixels
            : furtherRays.get() * ((double) pixels / smoothed.get());      // in this order, exact at the end
        double expected = (hasFirstRays ? pixels : 0) + further;
        return Math.min(1, (firstRays.get() + furtherRays.get()) / expected);
    }
}
