package raytracing.render;

import java.util.concurrent.atomic.AtomicLong;

/**
 * How far a picture is, in rays of the eye: those that were sent, of those that it will take. How many pixels will be
 * refined is known only at the end; until then, the share of those that were gives the estimate, for tiles are
 * dealt evenly over the picture.
 */
final class Progress {
    /** Share of pixels on edges, before any was asked: between those of our scenes. */
    private static final double TYPICAL_SHARE_OF_EDGES = 0.15;

    private final long pixels;
    private final PixelSampling sampling;
    private final AtomicLong looked = new AtomicLong();
    private final AtomicLong judged = new AtomicLong();
    private final AtomicLong refined = new AtomicLong();

    Progress(long pixels, PixelSampling sampling) {
        this.pixels = pixels;
        this.sampling = sampling;
    }

    /** So many more pixels had their one ray. */
    void looked(long count) {
        looked.addAndGet(count);
    }

    /** Of so many more pixels it is known whether they are on an edge, and those that are got their N x N rays. */
    void refined(long judgedCount, long refinedCount) {
        judged.addAndGet(judgedCount);
        refined.addAndGet(refinedCount);
    }

    /** Pixels that are what they will be. */
    long finished() {
        return sampling.root() == 1 ? looked.get() : judged.get();
    }

    /** Pixels that got N x N rays. */
    long refined() {
        return refined.get();
    }

    /** Share of the rays that were sent, from 0 to 1. */
    double share() {
        if (sampling.root() == 1) {
            return (double) looked.get() / pixels;
        }
        double rays = sampling.root() * sampling.root();
        boolean isEverywhere = sampling.where() == PixelSampling.Where.EVERYWHERE;
        double edges = judged.get() == 0 ? TYPICAL_SHARE_OF_EDGES * pixels
            : refined.get() * ((double) pixels / judged.get());      // in this order, exact when all are judged
        double expected = isEverywhere ? rays * pixels : pixels + rays * edges;
        return Math.min(1, (looked.get() + rays * refined.get()) / expected);
    }
}
