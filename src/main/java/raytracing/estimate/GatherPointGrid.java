package raytracing.estimate;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import raytracing.ambient.AmbientLookup;
import raytracing.ambient.IrradianceCache;
import raytracing.ambient.IrradianceRecord;
import raytracing.color.Color;
import raytracing.color.MutableColor;
import raytracing.hierarchy.PointTraversal;
import raytracing.math.CounterRandom;
import raytracing.math.Vector;
import raytracing.scene.Camera;
import raytracing.scene.CameraRays;
import raytracing.scene.Scene;
import raytracing.shade.Shader;
import raytracing.shade.VertexReservoir;
import raytracing.surface.Hit;
import raytracing.trace.PreparedScene;

/**
 * Points that the camera sees: one random point in each cell of a square grid over the picture where a ray meets a surface
 * with an ambient colour, also in mirrors and behind glass.
 */
final class GatherPointGrid implements SharedWork.Work {
    /** A gather point is needed where records have less weight; each has 1 at its own point (measured: DECISIONS). */
    private static final double COVERED = 0.5;

    private final Scene scene;
    private final PreparedScene prepared;
    private final long key;
    private final int edge;
    private final int width;
    private final int height;
    private final CameraRays rays;
    private final double spacingAtDistance1;
    private final List<Optional<GatherPoint>> points;
    private final PointTraversal traversal = new PointTraversal();
    private final MutableColor unused = new MutableColor();

    /**
     * A grid of edge x edge cells over a picture, still without points.
     *
     * @param usualEdge edge of the grid by which the records' radii are measured
     */
    GatherPointGrid(Scene scene, PreparedScene prepared, int width, int height, int edge, int usualEdge, long key) {
        this.scene = scene;
        this.prepared = prepared;
        this.key = key;
        this.edge = edge;
        this.width = width;
        this.height = height;
        Camera camera = scene.camera();
        rays = new CameraRays(camera, width, height);
        spacingAtDistance1 = camera.screenWidth() / camera.screenDistance() * Math.max(1, (double) height / width)
            / usualEdge;
        points = new ArrayList<>(Collections.nCopies(edge * edge, Optional.empty()));
    }

    int edge() {
        return edge;
    }

    /** Finds the points of every n-th row. */
    @Override
    public void work(int firstRow, int stride, int endRow) {
        VertexReservoir vertex = new VertexReservoir(VertexReservoir.Scattering.AMBIENT);
        Shader shader = Shader.forEstimates(scene, prepared, vertex);
        for (int row = firstRow; row < endRow; row += stride) {
            for (int column = 0; column < edge; column++) {
                int cell = edge * row + column;
                long bits = CounterRandom.bits(key, cell);
                double x = (column + CounterRandom.upperFraction(bits)) / edge * width;
                double y = (row + CounterRandom.lowerFraction(bits)) / edge * height;
                vertex.clear();              // where the lens shows black, no ray does it
                MutableColor shown = shader.light(rays, x, y, bits);
                if (vertex.isFound()) {
                    GatherPoint point = gatherPoint(vertex.hit());
                    point.shownWithout.set(shown);
                    vertex.addShare(scene.settings().ambientScale(), point.shownOfAmbient);
                    points.set(cell, Optional.of(point));
                }
            }
        }
    }

    private GatherPoint gatherPoint(Hit hit) {
        Vector eye = scene.camera().position();
        double x = eye.x() - hit.x();
        double y = eye.y() - hit.y();
        double z = eye.z() - hit.z();
        double distance = Vector.length(x, y, z);
        return new GatherPoint(hit, spacingAtDistance1 * distance, Math.abs(hit.alongNormal(x, y, z)) / distance);
    }

    boolean isEmpty() {
        return filled() == 0;
    }

    /** The share of its cells that have a point. */
    double filled() {
        return 1 - (double) Collections.frequency(points, Optional.empty()) / points.size();
    }

    /** Chooses those points of every n-th row and column that the records of the ones chosen before do not cover. */
    List<GatherPoint> choose(int step, List<GatherPoint> before, double detail) {
        List<GatherPoint> chosen = new ArrayList<>();
        List<IrradianceRecord> records = new ArrayList<>();
        for (GatherPoint point : before) {
            records.add(point.toRecord(point.radius(detail), Color.BLACK));
        }
        Optional<IrradianceCache> cache = records.isEmpty() ? Optional.empty() : Optional.of(new IrradianceCache(records));
        for (int row = 0; row < edge; row += step) {
            for (int column = 0; column < edge; column += step) {
                Optional<GatherPoint> found = points.get(edge * row + column);
                if (found.isPresent() && !found.get().isChosen && !isCovered(found.get(), cache)) {
                    found.get().isChosen = true;
                    chosen.add(found.get());
                }
            }
        }
        return chosen;
    }

    private boolean isCovered(GatherPoint point, Optional<IrradianceCache> cache) {
        return cache.isPresent() && !(cache.get().addTo(unused, point.hit, traversal) < COVERED);
    }

    /** Mean of the light at all points, also where none is gathered. */
    Color mean(AmbientLookup light) {
        MutableColor sum = new MutableColor();
        int count = 0;
        for (Optional<GatherPoint> point : points) {
            if (point.isPresent()) {
                sum.add(1, Color.WHITE, light.at(point.get().hit));
                count++;
            }
        }
        sum.scale(1.0 / count);
        return sum.toColor();
    }
}
