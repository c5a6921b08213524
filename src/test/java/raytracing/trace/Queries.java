package raytracing.trace;

import java.util.EnumSet;
import raytracing.parallel.ForkJoin;
import raytracing.scene.Scene;
import raytracing.surface.HitRecord;
import raytracing.surface.RayRecord;

/** Queries by values that stay. */
public final class Queries {
    private Queries() {
    }

    /** A scene prepared with all shortcuts by the calling thread. */
    public static PreparedScene prepared(Scene scene, ShadowMode shadowMode) {
        return new PreparedScene(scene, shadowMode, EnumSet.allOf(Shortcut.class), ForkJoin.sequential());
    }

    /** Begins a query along a ray. */
    public static void start(RayQuery query, RayRecord ray) {
        ray.writeTo(query.ray());
        query.begin();
    }

    /** What a query has reached. */
    public static HitRecord hit(RayQuery query) {
        return HitRecord.of(query.hit(), query.material());
    }
}
