package raytracing.render;

import raytracing.color.MutableColor;
import raytracing.film.Film;
import raytracing.math.ScrambledNet;
import raytracing.outline.OutlineQuery;

/**
 * Gives a pixel as many rays as its error needs: a function of the pixel, of the first rays through it and the eight around
 * it, and of the surfaces in its beam. Not thread-safe: each thread has its own.
 */
final class AdaptivePixel {
    /** Where all rays meet the same surfaces, light changes smoothly, and the error is about so much of that at an edge. */
    private static final double SMOOTH = 0.5;

    /** Rays of a pixel lie so densely that what none of them hits fills at most this over their number of it. */
    private static final double MISSED_BY_RAYS = 1.0 / 3;

    /** The largest contrast between two things that a pixel may show, in steps. */
    private static final double ANY_CONTRAST = 192;

    /** Where light bends by more than this share of the limit from pixel to pixel, one ray may not be enough. */
    private static final double MOST_BEND = 1.5;

    /** From the middle of a pixel to its corner, over the largest distance of a neighbour in units of the change to it. */
    private static final double WITHIN_A_PIXEL = 0.75;

    /** Over how many pixels' second differences the mean over a pixel's square differs from its middle, in both directions. */
    private static final double OF_BEND = 1.0 / 12;

    /** Rays that differ by less than this, in steps, show the same. */
    private static final double SAME = 0.5;

    private final PixelLight light;
    private final double limit;
    private final OutlineQuery outlines;
    private final ScrambledNet net = new ScrambledNet();
    private final PixelMean mean = new PixelMean();
    private final Neighbourhood seen = new Neighbourhood();
    private final Differences differences = new Differences();
    private final ErrorTally tally = new ErrorTally();
    private int blockX = -1;
    private int blockY = -1;

    AdaptivePixel(PixelLight light, Renderer renderer, ErrorLimit errorLimit) {
        this.light = light;
        limit = errorLimit.steps();
        outlines = new OutlineQuery(renderer.surfaces(), renderer.scene(), renderer.cameraRays(), limit / 2);
    }

    /** The rays and errors of the pixels since it was cleared. */
    ErrorTally tally() {
        return tally;
    }

    /** What the first rays tell about the next pixel; to be set before it is refined. */
    Neighbourhood neighbourhood() {
        return seen;
    }

    /** Replaces the light of a pixel's first ray in a film, if that ray is not enough. */
    void refine(int x, int y, Film film, int column, int row) {
        int raysForOutlines = raysForOutlines(x, y);
        int rays = fewestRays(raysForOutlines);
        if (rays == 1) {
            tally.add(1, OF_BEND * seen.bend, seen.slope > SAME);
            return;
        }
        addRays(x, y, rays, raysForOutlines > 1 ? raysToFind(ANY_CONTRAST) : 0);
        film.set(column, row, mean.red(), mean.green(), mean.blue());
        double error = mean.error();
        tally.add(mean.rays(), differences.ofSurfaces ? error : SMOOTH * error, mean.deviation() > SAME / 4);
        if (error > limit) {
            tally.addUnfinished(error);
        }
    }

    /** How many rays notice every outline in a pixel, seen directly or through glass; 1 if there is none. */
    private int raysForOutlines(int x, int y) {
        int newBlockX = x / OutlineQuery.BLOCK;
        int newBlockY = y / OutlineQuery.BLOCK;
        if (newBlockX != blockX || newBlockY != blockY) {
            blockX = newBlockX;
            blockY = newBlockY;
            outlines.aim(blockX, blockY);
        }
        return outlines.raysNeeded(x, y);
    }

    /** How many rays a pixel gets before its error is asked for: 1 if its first ray is enough. */
    private int fewestRays(int raysForOutlines) {
        if (raysForOutlines > 1) {
            return Math.max(raysForOutlines, raysToFind(Math.max(ANY_CONTRAST / 2, seen.contrast)));
        }
        int rays = seen.isMirror || seen.isAtOutline || seen.highlightMargin < 0 ? PixelMean.FEWEST_RAYS : 1;
        if (seen.bend > MOST_BEND * limit || seen.hasDetail) {
            rays = raysToFind(seen.slope);
        }
        if (Math.abs(seen.highlightMargin) < WITHIN_A_PIXEL * seen.highlightChange) {
            rays = Math.max(rays, raysToFind(ANY_CONTRAST));
        }
        return rays;
    }

    /** So many rays that what none of them hits changes the pixel by less than the limit, if it differs by so many steps. */
    private int raysToFind(double contrast) {
        int rays = PixelMean.FEWEST_RAYS;
        while (rays < PixelMean.MOST_RAYS && rays * limit < MISSED_BY_RAYS * contrast) {
            rays *= 2;
        }
        return rays;
    }

    /**
     * Adds rays, and as many again and again, until their mean is probably within the limit, or they run out. Before that it
     * is not enough that four rays agree while they see different things, or that a known outline still hides between them.
     */
    private void addRays(int x, int y, int fewest, int fewestToFindOutlines) {
        light.beginPixel(x, y);
        net.begin(light.key());
        mean.clear();
        differences.clear();
        for (int count = fewest;; count *= 2) {
            mean.plan(count);
            for (int i = mean.rays(); i < count; i++) {
                net.moveTo(i);
                MutableColor shown = light.ofRay(net.x(), net.y(), i);
                mean.add(Film.shown(shown.red()), Film.shown(shown.green()), Film.shown(shown.blue()));
                differences.add(light, i == 0);
            }
            boolean isTooEarly = differences.ofDetail && count == PixelMean.FEWEST_RAYS
                || !differences.ofOutline && count < fewestToFindOutlines;
            if (count == PixelMean.MOST_RAYS || !isTooEarly && mean.error() <= limit) {
                return;
            }
        }
    }

    /** Whether the rays of a pixel saw different things. Not thread-safe. */
    private static final class Differences {
        /** In the surfaces that the rays themselves met. */
        private boolean ofOutline;

        /** In all surfaces, in mirrors too. */
        private boolean ofSurfaces;

        /** In all surfaces, or in the lights that reached them. */
        private boolean ofDetail;
        private long direct;
        private long surfaces;
        private long detail;

        void clear() {
            ofOutline = false;
            ofSurfaces = false;
            ofDetail = false;
        }

        /** Adds what the last ray saw; the first of a pixel differs from none. */
        void add(PixelLight light, boolean isFirst) {
            ofOutline |= !isFirst && light.directFingerprint() != direct;
            ofSurfaces |= !isFirst && light.fingerprint() != surfaces;
            ofDetail |= !isFirst && light.detailFingerprint() != detail;
            direct = light.directFingerprint();
            surfaces = light.fingerprint();
            detail = light.detailFingerprint();
        }
    }
}
