package raytracing;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import raytracing.compiled.CompiledScene;
import raytracing.compiled.RayWalk;
import raytracing.compiled.ShadowLine;
import raytracing.compiled.ShadowMode;
import raytracing.geometry.Hit;
import raytracing.geometry.HitPoint;
import raytracing.geometry.PointError;
import raytracing.geometry.Ray;
import raytracing.geometry.Surface;
import raytracing.math.Vector;
import raytracing.scene.Scene;

/** Casts rays into a compiled scene: the only place where the benchmarks know how it is asked. */
final class CompiledRayCaster implements RayCaster {
    /** Beyond every ball of a sphereflake. */
    private static final double AROUND = 3;

    private final RayWalk walk;
    private final ShadowLine line;
    private final HitPoint start = new HitPoint();
    private final List<Ray> rays;
    private final List<Hit> starts;
    private final List<Vector> targets;

    /** Rays of a picture of size x size pixels; where an eye's ray meets nothing, the list begins again at its end. */
    CompiledRayCaster(Scene written, Coherence coherence, int size) {
        CompiledScene scene = new CompiledScene(written, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
        walk = new RayWalk(scene);
        line = new ShadowLine(scene);
        Vector eye = written.camera().position();
        List<Ray> fromEye = Coherence.throughPixels(written.camera(), size).stream()
            .map(direction -> new Ray(eye, direction)).toList();
        List<Hit> hits = fromEye.stream().map(this::hit).flatMap(Optional::stream).toList();
        if (coherence == Coherence.COHERENT) {
            rays = repeated(fromEye, size * size);
            starts = repeated(hits, size * size);
            targets = repeated(List.of(written.lights().get(0).position()), size * size);
        } else {
            List<Vector> directions = Coherence.anywhere(size * size);
            starts = repeated(Coherence.shuffled(hits), size * size);
            rays = IntStream.range(0, size * size)
                .mapToObj(i -> towardsSeenSide(starts.get(i), directions.get(i))).toList();
            targets = directions.stream().map(direction -> direction.times(AROUND)).toList();
        }
    }

    private Optional<Hit> hit(Ray ray) {
        walk.start(ray);
        return walk.advance() ? Optional.of(walk.hit()) : Optional.empty();
    }

    private static <T> List<T> repeated(List<T> things, int count) {
        return Stream.generate(() -> things).flatMap(List::stream).limit(count).toList();
    }

    private static Ray towardsSeenSide(Hit start, Vector direction) {
        return start.leaving(start.normal().dot(direction) < 0 ? direction.negated() : direction);
    }

    @Override
    public double nearest(int ray) {
        walk.start(rays.get(ray));
        return walk.advance() ? walk.point().x() : Surface.MISS;
    }

    @Override
    public boolean occluded(int ray) {
        Vector target = targets.get(ray);
        Hit from = starts.get(ray);
        start.take(from);
        double error = PointError.written(target);
        return line.transmittance(start, target.x(), target.y(), target.z(), error) == 0;
    }
}
