package raytracing.outline;

import raytracing.scene.CameraRays;
import raytracing.scene.Scene;
import raytracing.surface.Box;
import raytracing.trace.PreparedScene;
import raytracing.trace.RayQuery;

/** What single rays see, found ray by ray: the oracle of the tests. */
final class SeenList {
    private static final long BLACK = 0;
    private static final long LIT = 1;
    private static final long FACTOR = 0xd1342543de82ef95L;

    private final Scene scene;
    private final PreparedScene prepared;
    private final CameraRays rays;
    private final RayQuery query;

    SeenList(Scene scene, PreparedScene prepared, CameraRays rays) {
        this.scene = scene;
        this.prepared = prepared;
        this.rays = rays;
        query = new RayQuery(prepared);
    }

    /**
     * A number that stands for the surfaces along the ray through a point of the picture, directly and behind glass, and the
     * faces of boxes among them; two lists have the same one with a chance of about 1 in 2^64.
     */
    long at(double x, double y) {
        if (!rays.start(x, y, query.ray())) {
            return BLACK;
        }
        query.begin();
        long list = LIT;
        while (query.advance()) {
            list = FACTOR * list + query.surface() + 2;
            if (prepared.surface(query.surface()) instanceof Box) {
                list = FACTOR * list + face();
            }
            if (scene.materials().get(query.material()).transparency() == 0) {
                return list;
            }
        }
        return list;
    }

    private int face() {
        return (int) (Math.rint(query.hit().normalX()) + 3 * Math.rint(query.hit().normalY())
            + 9 * Math.rint(query.hit().normalZ()));
    }
}
