package raytracing.shade;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import raytracing.color.Color;
import raytracing.compiled.BallWalk;
import raytracing.compiled.CompiledScene;
import raytracing.compiled.PixelRays;
import raytracing.geometry.HitPoint;
import raytracing.math.CounterRandom;
import raytracing.math.Vector;
import raytracing.scene.Camera;
import raytracing.scene.Scene;

/**
 * Places that the camera sees: one random point in each cell of a square grid over the picture, where a ray meets,
 * mirrors and glass included, a surface with an ambient colour.
 */
final class PlaceGrid {
    /**
     * A place is needed where those before have less weight than this, of 1 each at its own place (measured: DECISIONS).
     */
    private static final double COVERED = 0.5;

    private final int edge;
    private final int width;
    private final int height;
    private final PixelRays rays;
    private final Vector eye;
    private final double spacingAtDistance1;
    private final List<Optional<Place>> places = new ArrayList<>();
    private final BallWalk walk = new BallWalk();
    private final LightSum forgotten = new LightSum();

    /** A grid of edge x edge cells over a picture, where nothing was seen yet. */
    PlaceGrid(Scene scene, int width, int height, int edge) {
        this.edge = edge;
        this.width = width;
        this.height = height;
        Camera camera = scene.camera();
        rays = new PixelRays(camera, width, height);
        eye = camera.position();
        spacingAtDistance1 = camera.screenWidth() / camera.screenDistance() * Math.max(1, (double) height / width) / edge;
        for (int i = 0; i < edge * edge; i++) {
            places.add(Optional.empty());
        }
    }

    int edge() {
        return edge;
    }

    /** Looks at the cells of every n-th row from one on; different threads may look at different rows. */
    void look(Scene scene, CompiledScene compiled, long key, int firstRow, int stride) {
        PathVertex vertex = new PathVertex(PathVertex.Scattering.AMBIENT);
        Scene unlit = new Scene(scene.camera(), scene.settings(), scene.materials(), scene.surfaces(), List.of());
        Shader shader = Shader.forEstimates(unlit, compiled, vertex);
        for (int row = firstRow; row < edge; row += stride) {
            for (int column = 0; column < edge; column++) {
                int cell = edge * row + column;
                long bits = CounterRandom.bits(key, cell);
                double x = (column + CounterRandom.upperFraction(bits)) / edge * width;
                double y = (row + CounterRandom.lowerFraction(bits)) / edge * height;
                vertex.clear();              // where the lens shows black, no ray does it
                shader.light(rays, x, y, bits);
                if (vertex.isFound()) {
                    places.set(cell, Optional.of(place(vertex.point())));
                }
            }
        }
    }

    private Place place(HitPoint point) {
        double x = eye.x() - point.x();
        double y = eye.y() - point.y();
        double z = eye.z() - point.z();
        double distance = Vector.length(x, y, z);
        return new Place(point, spacingAtDistance1 * distance, Math.abs(point.alongNormal(x, y, z)) / distance);
    }

    boolean isEmpty() {
        for (Optional<Place> place : places) {
            if (place.isPresent()) {
                return false;
            }
        }
        return true;
    }

    /** Chooses those places of every n-th row and column that the ones chosen before do not cover. */
    List<Place> choose(int step, List<Place> before) {
        List<Place> chosen = new ArrayList<>();
        Optional<IrradianceCache> covered = before.isEmpty() ? Optional.empty()
            : Optional.of(IrradianceCache.of(before, IrradianceCache.Reach.NEAR, Color.BLACK));
        for (int row = 0; row < edge; row += step) {
            for (int column = 0; column < edge; column += step) {
                Optional<Place> place = places.get(edge * row + column);
                if (place.isPresent() && !place.get().isChosen() && weight(covered, place.get()) < COVERED) {
                    place.get().choose();
                    chosen.add(place.get());
                }
            }
        }
        return chosen;
    }

    private double weight(Optional<IrradianceCache> cache, Place place) {
        return cache.isEmpty() ? 0 : cache.get().addTo(forgotten, place.point(), walk);
    }

    /** Mean of the light at all places. */
    Color mean(AmbientLookup light) {
        LightSum sum = new LightSum();
        int count = 0;
        for (Optional<Place> place : places) {
            if (place.isPresent()) {
                sum.add(1, Color.WHITE, light.at(place.get().point()));
                count++;
            }
        }
        sum.scale(1.0 / count);
        return sum.total();
    }
}
