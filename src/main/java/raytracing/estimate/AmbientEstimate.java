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
 * The same scene, shape of the picture and seed give the same light, on any number of threads; pictures of at most 36 pixels
 * along both edges have a light of their own, from gather points no denser than their pixels.
 *
 * <p>The camera looks at a grid of points. Light is gathered first at a coarse part of them, then, in two steps, at those of
 * the finer ones that lie too far from all before: so gather points are dense where surfaces are close to each other, where
 * light changes quickly.
 */
public final class AmbientEstimate {
    /** Edge of the grid, in points, for all but the smallest pictures: a multiple of the coarsest step. */
    private static final int GRID = 40;

    /** Where no point of the grid has an ambient colour, a grid that is so much finer is tried. */
    private static final int FINER = 4;

    /** The first step gathers light in every n-th column and row of the grid. */
    private static final int COARSEST_STEP = 4;

    /** The least that a thread does in one piece: enough to be worth the construction of its objects. */
    private static final int ROWS_AT_ONCE = 4;
    private static final int POINTS_AT_ONCE = 16;

    /** Names the key of these random numbers; pixels have the counters from 0 on. */
    private static final long AMBIENT = -1;
    private static final long LOOKING = 0;
    private static final long GATHERING = 1;

    private final Scene scene;
    private final PreparedScene prepared;
    private final ForkJoin workers;
    private final long key;

    private AmbientEstimate(Scene scene, PreparedScene prepared, long seed, ForkJoin workers) {
        this.scene = scene;
        this.prepared = prepared;
        this.workers = workers;
        key = CounterRandom.bits(seed, AMBIENT);
    }

    /**
     * The ambient light of a scene, for a picture of some width and height in pixels.
     *
     * @return {@link AmbientLight#NONE} if no surface with an ambient colour is seen, or the scene's ambient scale is 0
     */
    public static AmbientLight of(Scene scene, PreparedScene prepared, int width, int height, long seed, ForkJoin workers) {
        if (scene.settings().ambientScale() > 0) {
            for (Surface surface : scene.surfaces()) {
                if (!scene.materials().get(surface.material()).ambient().isBlack()) {
                    return new AmbientEstimate(scene, prepared, seed, workers).estimate(width, height);
                }
            }
        }
        return AmbientLight.NONE;
    }

    private AmbientLight estimate(int width, int height) {
        // as many points as pixels are enough along the longer edge: more would take longer than the picture
        int longer = Math.min(GRID, Math.max(width, height));
        int edge = (longer + COARSEST_STEP - 1) / COARSEST_STEP * COARSEST_STEP;
        for (int finer = 1; finer <= FINER; finer *= FINER) {
            GatherPointGrid grid =
                new GatherPointGrid(scene, prepared, width, height, finer * edge, CounterRandom.bits(key, LOOKING));
            new SharedWork(workers, grid, 0, 1, grid.edge(), ROWS_AT_ONCE).run();
            if (!grid.isEmpty()) {
                return estimate(grid, finer * COARSEST_STEP);
            }
        }
        return AmbientLight.NONE;
    }

    private AmbientLight estimate(GatherPointGrid grid, int coarsestStep) {
        List<GatherPoint> points = new ArrayList<>();
        workers.expect((long) grid.edge() * grid.edge());
        long cellsBefore = 0;
        for (int step = coarsestStep; step >= 1; step /= 2) {
            int before = points.size();
            points.addAll(grid.choose(step, points));
            long cells = (long) (grid.edge() / step) * (grid.edge() / step);
            workers.advance(cells - cellsBefore - (points.size() - before));      // no light is gathered in these
            cellsBefore = cells;
            Gathering gathering = new Gathering(scene, prepared, workers, CounterRandom.bits(key, GATHERING), points);
            new SharedWork(workers, gathering, before, 1, points.size(), POINTS_AT_ONCE).run();
        }
        return light(points, grid);
    }

    /** The records of the points, which first take the points' mean where none counts, to find the mean over the grid. */
    private static AmbientLight light(List<GatherPoint> points, GatherPointGrid grid) {
        FurtherBounces further = new FurtherBounces();
        for (GatherPoint point : points) {
            further.add(point.further);
        }
        Color furtherLight = further.mean();
        List<IrradianceRecord> near = new ArrayList<>();
        List<IrradianceRecord> wide = new ArrayList<>();
        MutableColor meanOfPoints = new MutableColor();
        for (GatherPoint point : points) {
            Color light = point.light(furtherLight);
            near.add(point.toRecord(point.radius(), light));
            wide.add(point.toRecord(point.wideRadius(), light));
            meanOfPoints.add(1.0 / points.size(), Color.WHITE, light);
        }
        Optional<AmbientLight.Records> records =
            Optional.of(AmbientLight.Records.of(near, wide, (long) DiffusePaths.PATHS * points.size()));
        return new AmbientLight(grid.mean(new AmbientLookup(new AmbientLight(meanOfPoints.toColor(), records))), records);
    }

    /** Gathers light at points; each has random numbers of its own, by its number among all of them. */
    private record Gathering(Scene scene, PreparedScene prepared, ForkJoin workers, long key, List<GatherPoint> points)
        implements SharedWork.Work {
        @Override
        public void work(int first, int stride, int end) {
            DiffusePaths paths = new DiffusePaths(scene, prepared);
            for (int i = first; i < end; i += stride) {
                paths.gather(points.get(i), CounterRandom.bits(key, i));
                workers.advance(1);
            }
        }
    }
}
