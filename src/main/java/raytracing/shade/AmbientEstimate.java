package raytracing.shade;

import java.util.ArrayList;
import java.util.List;
import raytracing.color.Color;
import raytracing.compiled.CompiledScene;
import raytracing.compiled.Workers;
import raytracing.geometry.Surface;
import raytracing.math.CounterRandom;
import raytracing.scene.Scene;

/**
 * Estimates the ambient light of a room from what the camera sees of it: src/docs/AMBIENT.md has the method, its rivals and
 * their errors. The same scene, shape of the picture and seed give the same light, whoever works on it; pictures of at most
 * 36 pixels along both edges have a light of their own, from places no denser than their pixels.
 *
 * <p>The camera looks at a grid of places. At a coarse part of them light is gathered first, then, in two steps, at those
 * of the finer ones that lie too far from all before: so places are dense where surfaces are close to each other, where
 * light changes quickly. Light that bounces further than the paths go is summed up as a geometric series, as in the
 * ambient term of progressive radiosity (Cohen, Chen, Wallace, Greenberg, A Progressive Refinement Approach to Fast
 * Radiosity Image Generation, SIGGRAPH 1988).
 */
public final class AmbientEstimate {
    /** Edge of the grid, in places, for all but the smallest pictures: a multiple of the coarsest step. */
    private static final int GRID = 40;

    /** Where no place of the grid sees a surface with an ambient colour, one of a grid that is so much finer may. */
    private static final int FINER = 4;

    /** Every n-th column and row of the grid is looked at in the first step. */
    private static final int COARSEST_STEP = 4;

    /** What one thread does in a row: enough to be worth the making of its tools. */
    private static final int ROWS_AT_ONCE = 4;
    private static final int PLACES_AT_ONCE = 16;

    /** Names the key of these random numbers; pixels have the counters from 0 on. */
    private static final long AMBIENT = -1;
    private static final long LOOKING = 0;
    private static final long GATHERING = 1;

    private final Scene scene;
    private final CompiledScene compiled;
    private final Workers workers;
    private final long key;

    private AmbientEstimate(Scene scene, CompiledScene compiled, long seed, Workers workers) {
        this.scene = scene;
        this.compiled = compiled;
        this.workers = workers;
        key = CounterRandom.bits(seed, AMBIENT);
    }

    /**
     * Estimates.
     *
     * @param scene the room
     * @param compiled its surfaces
     * @param width of the picture in pixels, at least 1
     * @param height of the picture in pixels, at least 1
     * @param seed of the random numbers
     * @param workers who does it; the result is the same
     * @return the light, or {@link AmbientLight#NONE} if no surface asks for it or none that does is seen
     */
    public static AmbientLight of(Scene scene, CompiledScene compiled, int width, int height, long seed, Workers workers) {
        return isWanted(scene) ? new AmbientEstimate(scene, compiled, seed, workers).estimate(width, height)
            : AmbientLight.NONE;
    }

    private static boolean isWanted(Scene scene) {
        if (scene.settings().ambientScale() > 0) {
            for (Surface surface : scene.surfaces()) {
                if (!scene.materials().get(surface.material()).ambient().isBlack()) {
                    return true;
                }
            }
        }
        return false;
    }

    private AmbientLight estimate(int width, int height) {
        int edge = edge(width, height);
        PlaceGrid grid = look(width, height, edge);
        if (!grid.isEmpty()) {
            return estimate(grid, COARSEST_STEP);
        }
        PlaceGrid finer = look(width, height, FINER * edge);
        return finer.isEmpty() ? AmbientLight.NONE : estimate(finer, FINER * COARSEST_STEP);
    }

    /** As many places as pixels are enough along the longer edge: more would cost more than the picture. */
    private static int edge(int width, int height) {
        int longer = Math.min(GRID, Math.max(width, height));
        return (longer + COARSEST_STEP - 1) / COARSEST_STEP * COARSEST_STEP;
    }

    private PlaceGrid look(int width, int height, int edge) {
        PlaceGrid grid = new PlaceGrid(scene, width, height, edge);
        new Looking(grid, 0, 1, grid.edge()).run();
        return grid;
    }

    private AmbientLight estimate(PlaceGrid grid, int coarsestStep) {
        List<Place> places = new ArrayList<>();
        workers.expect((long) grid.edge() * grid.edge());
        long cellsBefore = 0;
        for (int step = coarsestStep; step >= 1; step /= 2) {
            int before = places.size();
            places.addAll(grid.choose(step, places));
            long cells = (long) (grid.edge() / step) * (grid.edge() / step);
            workers.advance(cells - cellsBefore - (places.size() - before));      // nothing is gathered in these
            cellsBefore = cells;
            new Gathering(places, before, 1, places.size()).run();
        }
        Color further = furtherLight(places);
        AmbientLight light = AmbientLight.between(places, further, mean(places, further));
        return light.withMean(grid.mean(new AmbientLookup(light)));
    }

    /** Mean of the light at the places where it was gathered: more of them lie in corners than the camera sees of these. */
    private static Color mean(List<Place> places, Color further) {
        LightSum sum = new LightSum();
        for (Place place : places) {
            sum.add(1.0 / places.size(), Color.WHITE, place.allLight(further));
        }
        return sum.total();
    }

    /**
     * What arrives, by further bounces, where the paths of the places' own light end: in the mean over all of them, what
     * the bounces that were followed brought and what those beyond would bring, each by its weight.
     */
    private static Color furtherLight(List<Place> places) {
        LightSum onward = new LightSum();
        LightSum deep = new LightSum();
        LightSum last = new LightSum();
        LightSum arriving = new LightSum();
        LightSum beyond = new LightSum();
        for (Place place : places) {
            onward.add(1, Color.WHITE, place.onward);
            deep.add(1, Color.WHITE, place.deepLight);
            last.add(1, Color.WHITE, place.lastLight);
            arriving.add(1, Color.WHITE, place.arriving);
            beyond.add(1, Color.WHITE, place.beyond);
        }
        return new Color(
            ratio(deep.red() + beyond.red() * series(last.red(), arriving.red(), beyond.red()), onward.red()),
            ratio(deep.green() + beyond.green() * series(last.green(), arriving.green(), beyond.green()), onward.green()),
            ratio(deep.blue() + beyond.blue() * series(last.blue(), arriving.blue(), beyond.blue()), onward.blue()));
    }

    /** Finite, so that 0 times it is 0. */
    private static double ratio(double sum, double weight) {
        return weight > 0 ? Math.min(sum / weight, Double.MAX_VALUE) : 0;
    }

    /**
     * Light by endless bounces, from one of them: if rays find light b and send on a share r of what arrives where they
     * end, and so do all further ones, together they find b + r b + r r b + ... = b / (1 - r).
     *
     * @param light what rays of all weights together found
     * @param arriving sum of these weights
     * @param beyond sum of the weights of what they send on
     */
    static double series(double light, double arriving, double beyond) {
        return ratio(light, Math.max(arriving - beyond, (1 - PathVertex.MOST_REFLECTANCE) * arriving));
    }

    /** Work on a row of things, shared out in halves: every other one of them, for neighbours take about as long. */
    private abstract class SharedWork implements Runnable {
        private final int first;
        private final int stride;
        private final int end;
        private final int least;

        SharedWork(int first, int stride, int end, int least) {
            this.first = first;
            this.stride = stride;
            this.end = end;
            this.least = least;
        }

        @Override
        public final void run() {
            if (end - first <= stride * least) {
                work(first, stride, end);
            } else {
                workers.doBoth(part(first, 2 * stride, end), part(first + stride, 2 * stride, end));
            }
        }

        abstract SharedWork part(int partFirst, int partStride, int partEnd);

        abstract void work(int partFirst, int partStride, int partEnd);
    }

    /** Looks at rows of a grid. */
    private final class Looking extends SharedWork {
        private final PlaceGrid grid;

        Looking(PlaceGrid grid, int first, int stride, int end) {
            super(first, stride, end, ROWS_AT_ONCE);
            this.grid = grid;
        }

        @Override
        SharedWork part(int partFirst, int partStride, int partEnd) {
            return new Looking(grid, partFirst, partStride, partEnd);
        }

        @Override
        void work(int partFirst, int partStride, int partEnd) {
            grid.look(scene, compiled, CounterRandom.bits(key, LOOKING), partFirst, partStride);
        }
    }

    /** Gathers light at places; each has random numbers of its own, by its number among all of them. */
    private final class Gathering extends SharedWork {
        private final List<Place> places;

        Gathering(List<Place> places, int first, int stride, int end) {
            super(first, stride, end, PLACES_AT_ONCE);
            this.places = places;
        }

        @Override
        SharedWork part(int partFirst, int partStride, int partEnd) {
            return new Gathering(places, partFirst, partStride, partEnd);
        }

        @Override
        void work(int partFirst, int partStride, int partEnd) {
            DiffusePaths paths = new DiffusePaths(scene, compiled);
            for (int i = partFirst; i < partEnd; i += partStride) {
                paths.gather(places.get(i), CounterRandom.bits(CounterRandom.bits(key, GATHERING), i));
                workers.advance(1);
            }
        }
    }
}
