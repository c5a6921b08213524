package raytracing.render;

import java.util.concurrent.atomic.AtomicLong;

/**
 * How far a picture is: the share of its rays of the eye that were sent. Thread-safe. How many pixels will get N x N rays is
 * known only at the end; until then it is estimated from the pixels so far, because tiles are dealt evenly over the picture.
 */
public final class Progress {
    /** Share of pixels on edges before any is known: between those of our scenes. */
    private static final double TYPICAL_SHARE_OF_EDGES = 0.15;

    private final long pixels;
    private final PixelSampling sampling;
    private final AtomicLong firstRays = new AtomicLong();
    private final AtomicLong smoothed = new AtomicLong();
    private final AtomicLong refined = new AtomicLong();

    Progress(long pixels, PixelSampling sampling) {
        this.pixels = pixels;
        this.sampling = sampling;
    }

    /** Adds pixels that had their one ray. */
    void addFirstRays(long count) {
        firstRays.addAndGet(count);
    }

    /** Adds pixels of which it is known whether they are on an edge; those that are got their N x N rays. */
    void addSmoothed(long count, long refinedCount) {
        smoothed.addAndGet(count);
        refined.addAndGet(refinedCount);
    }

    /** Pixels of the bands so far whose light is final. */
    public long finished() {
        return sampling.root() == 1 ? firstRays.get() : smoothed.get();
    }

    /** Pixels of the bands so far that got N x N rays, where N is above 1. */
    public long refined() {
        return refined.get();
    }

    /** Share of the rays that were sent, from 0 to 1; exactly 1 at the end. */
    public double share() {
        if (sampling.root() == 1) {
            return (double) firstRays.get() / pixels;
        }
        double rays = sampling.root() * sampling.root();
        double edges = smoothed.get() == 0 ? TYPICAL_SHARE_OF_EDGES * pixels
            : refined.get() * ((double) pixels / smoothed.get());      // in this order, exact at the end
        double expected = sampling.where() == PixelSampling.Where.EVERYWHERE ? rays * pixels : pixels + rays * edges;
        return Math.min(1, (firstRays.get() + rays * refined.get()) / expected);
    }
}
