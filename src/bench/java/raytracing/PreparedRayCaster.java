package raytracing;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.scene.Scene;
import raytracing.surface.Hit;
import raytracing.surface.HitRecord;
import raytracing.surface.PointError;
import raytracing.surface.RayRecord;
import raytracing.surface.Surface;
import raytracing.trace.PreparedScene;
import raytracing.trace.Queries;
import raytracing.trace.RayQuery;
import raytracing.trace.SegmentQuery;
import raytracing.trace.ShadowMode;

/** Casts rays into a prepared scene: the only place in the benchmarks that calls its queries. */
final class PreparedRayCaster implements RayCaster {
    /** Beyond every ball of a sphereflake. */
    private static final double AROUND = 3;

    private final RayQuery walk;
    private final SegmentQuery line;
    private final List<RayRecord> rays;
    private final List<Hit> starts;
    private final List<Vector> targets;

    /** Rays of a picture of size x size pixels; where an eye's ray meets nothing, the list begins again at its end. */
    PreparedRayCaster(Scene written, Coherence coherence, int size) {
        PreparedScene scene = Queries.prepared(written, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
        walk = new RayQuery(scene);
        line = new SegmentQuery(scene, 1);
        Vector eye = written.camera().position();
        List<RayRecord> fromEye = Coherence.throughPixels(written.camera(), size).stream()
            .map(direction -> new RayRecord(eye, direction)).toList();
        List<HitRecord> hits = fromEye.stream().map(this::hit).flatMap(Optional::stream).toList();
        if (coherence == Coherence.COHERENT) {
            rays = repeated(fromEye, size * size);
            starts = repeated(hits.stream().map(HitRecord::toHit).toList(), size * size);
            targets = repeated(List.of(written.lights().get(0).position()), size * size);
        } else {
            List<Vector> directions = Coherence.anywhere(size * size);
            List<HitRecord> shuffled = repeated(Coherence.shuffled(hits), size * size);
            starts = shuffled.stream().map(HitRecord::toHit).toList();
            rays = IntStream.range(0, size * size)
                .mapToObj(i -> towardsSeenSide(shuffled.get(i), directions.get(i))).toList();
            targets = directions.stream().map(direction -> direction.times(AROUND)).toList();
        }
    }

    private Optional<HitRecord> hit(RayRecord ray) {
        Queries.start(walk, ray);
        return walk.advance() ? Optional.of(Queries.hit(walk)) : Optional.empty();
    }

    private static <T> List<T> repeated(List<T> things, int count) {
        return Stream.generate(() -> things).flatMap(List::stream).limit(count).toList();
    }

    private static RayRecord towardsSeenSide(HitRecord start, Vector direction) {
        return start.leaving(start.normal().dot(direction) < 0 ? Vectors.negated(direction) : direction);
    }

    @Override
    public double nearest(int ray) {
        Queries.start(walk, rays.get(ray));
        return walk.advance() ? walk.hit().x() : Surface.MISS;
    }

    @Override
    public boolean occluded(int ray) {
        Vector target = targets.get(ray);
        Hit start = starts.get(ray);
        double error = PointError.written(target);
        return line.transmittance(start, 0, target.x(), target.y(), target.z(), error) == 0;
    }
}
