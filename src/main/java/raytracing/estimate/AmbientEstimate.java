package raytracing.estimate;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import raytracing.ambient.AmbientLight;
import raytracing.ambient.AmbientLookup;
import raytracing.ambient.IrradianceRecord;
import raytracing.color.Color;
import raytracing.color.MutableColor;
import raytracing.math.CounterRandom;
import raytracing.parallel.ForkJoin;
import raytracing.scene.Scene;
import raytracing.surface.Surface;
import raytracing.trace.PreparedScene;

/**
 * Estimates the ambient light of a room from what the camera sees of it: src/docs/AMBIENT.md has the method and its errors.
 * The same scene, shape of the picture and seed give the same light, on any number of threads; pictures of at most 76 pixels
 * along both edges have a light of their own, from gather points no denser than their pixels.
 *
 * <p>The camera looks at a grid of points. Light is gathered first at a coarse part of them, then, in three steps, at those of
 * the finer ones that lie too far from all before: so gather points are dense where surfaces are close to each other, where
 * light changes quickly. If an error is asked for that the picture does not have yet, more paths and more points follow.
 */
public final class AmbientEstimate {
    /** Edge of the grid, in points, for all but the smallest pictures: a multiple of the coarsest step. */
    private static final int GRID = 80;

    /** The edge of the grid of a small picture is a multiple of this. */
    private static final int ROUNDING = 4;

    /** Where an error is asked for, the grid is so many times finer. */
    private static final int FINER = 2;

    /** Where no point of the grid has an ambient colour, one that is so many times finer is tried, up to so many points. */
    private static final int FINER_IF_EMPTY = 4;
    private static final int FINEST = 160;

    /** The first step gathers light in every n-th column and row of the grid. */
    private static final int COARSEST_STEP = 8;

    /** The least that a thread does in one piece: enough to be worth the construction of its objects. */
    private static final int ROWS_AT_ONCE = 4;
    private static final int POINTS_AT_ONCE = 16;

    /** Names the key of these random numbers; pixels have the counters from 0 on. */
    private static final long AMBIENT = -1;
    private static final long LOOKING = 0;
    private static final long GATHERING = 1;
    private static final long GATHERING_MORE = 2;

    /** Refinement ends with at most so many paths a point, and with radii half as large: about four times the points. */
    private static final int MOST_PATHS = 4096;
    private static final double LEAST_DETAIL = 0.5;

    /** It ends sooner if twice the paths leave more of the error than this. */
    private static final double LEAST_GAIN = 0.85;

    private final Scene scene;
    private final PreparedScene prepared;
    private final ForkJoin workers;
    private final long key;
    private final double mostError;

    private AmbientEstimate(Scene scene, PreparedScene prepared, long seed, double mostError, ForkJoin workers) {
        this.scene = scene;
        this.prepared = prepared;
        this.mostError = mostError;
        this.workers = workers;
        key = CounterRandom.bits(seed, AMBIENT);
    }

    /**
     * The ambient light of a scene, for a picture of some width and height in pixels.
     *
     * @param mostError more light is gathered until about this is left of the picture's error, in steps of 1/255 as
     *        {@link AmbientLight#error}, or a limit is reached; infinite for the usual light
     * @return {@link AmbientLight#NONE} if no surface with an ambient colour is seen, or the scene's ambient scale is 0
     */
    public static AmbientLight of(Scene scene, PreparedScene prepared, int width, int height, long seed, double mostError,
                                  ForkJoin workers) {
        if (scene.settings().ambientScale() > 0) {
            for (Surface surface : scene.surfaces()) {
                if (!scene.materials().get(surface.material()).ambient().isBlack()) {
                    return new AmbientEstimate(scene, prepared, seed, mostError, workers).estimate(width, height);
                }
            }
        }
        return AmbientLight.NONE;
    }

    private boolean isRefined() {
        return mostError < Double.POSITIVE_INFINITY;
    }

    private AmbientLight estimate(int width, int height) {
        // as many points as pixels are enough along the longer edge: more would take longer than the picture
        int longer = Math.min(GRID, Math.max(width, height));
        int edge = (longer + ROUNDING - 1) / ROUNDING * ROUNDING;
        int first = isRefined() ? FINER * edge : edge;
        GatherPointGrid grid = grid(width, height, first, edge);
        if (grid.isEmpty()) {
            grid = grid(width, height, Math.max(first, Math.min(FINEST, FINER_IF_EMPTY * edge)), edge);
        }
        return grid.isEmpty() ? AmbientLight.NONE : estimate(grid, COARSEST_STEP * grid.edge() / edge);
    }

    private GatherPointGrid grid(int width, int height, int edge, int usualEdge) {
        GatherPointGrid grid =
            new GatherPointGrid(scene, prepared, width, height, edge, usualEdge, CounterRandom.bits(key, LOOKING));
        new SharedWork(workers, grid, 0, 1, grid.edge(), ROWS_AT_ONCE).run();
        return grid;
    }

    private AmbientLight estimate(GatherPointGrid grid, int coarsestStep) {
        List<GatherPoint> points = new ArrayList<>();
        workers.expect((long) grid.edge() * grid.edge());
        long cellsBefore = 0;
        for (int step = coarsestStep; step >= 1; step /= 2) {
            int before = points.size();
            points.addAll(grid.choose(step, points, 1));
            long edge = (grid.edge() + step - 1) / step;
            long cells = edge * edge;
            workers.advance(cells - cellsBefore - (points.size() - before));      // no light is gathered in these
            cellsBefore = cells;
            Gathering gathering =
                new Gathering(scene, prepared, workers, CounterRandom.bits(key, GATHERING), points, isRefined());
            new SharedWork(workers, gathering, before, 1, points.size(), POINTS_AT_ONCE).run();
        }
        List<PathSegments> segments = new ArrayList<>();
        for (GatherPoint point : points) {
            segments.add(point.further());
        }
        FurtherLight further = new FurtherLight(segments);
        for (GatherPoint point : points) {
            point.settle(further);
        }
        return refine(grid, points, further);
    }

    /**
     * Twice as many paths each time, and about as many points at first, until the error is small enough, or more paths change
     * it little: then it is of what lies between the points.
     */
    private AmbientLight refine(GatherPointGrid grid, List<GatherPoint> points, FurtherLight further) {
        double detail = 1;
        AmbientLight light = light(points, grid, detail);
        double errorBefore = Double.POSITIVE_INFINITY;
        for (int paths = 2 * DiffusePaths.PATHS; paths <= MOST_PATHS && light.error() > mostError
            && (detail > LEAST_DETAIL || light.error() < LEAST_GAIN * errorBefore); paths *= 2) {
            detail = Math.max(LEAST_DETAIL, detail * Math.sqrt(0.5));
            for (int step = COARSEST_STEP; step >= 1; step /= 2) {
                int before = points.size();
                points.addAll(grid.choose(step, points, detail));
                gatherMore(points, before, further, DiffusePaths.PATHS);
            }
            gatherMore(points, 0, further, paths);
            errorBefore = light.error();
            light = light(points, grid, detail);
        }
        return light;
    }

    private void gatherMore(List<GatherPoint> points, int first, FurtherLight further, int most) {
        GatheringMore gathering =
            new GatheringMore(scene, prepared, CounterRandom.bits(key, GATHERING_MORE), points, further, most);
        new SharedWork(workers, gathering, first, 1, points.size(), POINTS_AT_ONCE).run();
    }

    /** The records of the points, which first take the points' mean where none counts, to find the mean over the grid. */
    private static AmbientLight light(List<GatherPoint> points, GatherPointGrid grid, double detail) {
        List<IrradianceRecord> near = new ArrayList<>();
        List<IrradianceRecord> wide = new ArrayList<>();
        MutableColor meanOfPoints = new MutableColor();
        long paths = 0;
        for (GatherPoint point : points) {
            Color light = point.light();
            near.add(point.toRecord(point.radius(detail), light));
            wide.add(point.toRecord(point.wideRadius(detail), light));
            meanOfPoints.add(1.0 / points.size(), Color.WHITE, light);
            paths += point.paths();
        }
        AmbientLight.Records records = AmbientLight.Records.of(near, wide, paths);
        double error = RemainingError.steps(points, records.near(), detail, grid.filled());
        AmbientLight first = new AmbientLight(meanOfPoints.toColor(), Optional.of(records), error);
        return new AmbientLight(grid.mean(new AmbientLookup(first)), Optional.of(records), error);
    }

    /** Gathers light at points; each has random numbers of its own, by its number among all of them. */
    private record Gathering(Scene scene, PreparedScene prepared, ForkJoin workers, long key, List<GatherPoint> points,
                             boolean everyPathIsLong) implements SharedWork.Work {
        @Override
        public void work(int first, int stride, int end) {
            DiffusePaths paths = new DiffusePaths(scene, prepared);
            for (int i = first; i < end; i += stride) {
                paths.gather(points.get(i), everyPathIsLong, CounterRandom.bits(key, i));
                workers.advance(1);
            }
        }
    }

    /** Gathers more light, until each point has so many paths. */
    private record GatheringMore(Scene scene, PreparedScene prepared, long key, List<GatherPoint> points,
                                 FurtherLight further, int most) implements SharedWork.Work {
        @Override
        public void work(int first, int stride, int end) {
            DiffusePaths paths = new DiffusePaths(scene, prepared);
            for (int i = first; i < end; i += stride) {
                GatherPoint point = points.get(i);
                long pointKey = CounterRandom.bits(key, i);
                while (point.paths() < most) {
                    paths.gatherMore(point, further, CounterRandom.bits(pointKey, point.paths()));
                }
            }
        }
    }
}
