package raytracing.trace;

import raytracing.hierarchy.RayTraversal;
import raytracing.surface.Body;
import raytracing.surface.Box;
import raytracing.surface.Departure;
import raytracing.surface.Hit;
import raytracing.surface.Ray;
import raytracing.surface.RayOrigin;
import raytracing.surface.Surface;

/**
 * Finds what a ray meets, from surface to surface. Every surface counts once along a ray, with its first crossing; coincident
 * surfaces are met one after the other, those at equal distances in the order of the scene. Used for ray after ray, so that
 * rays allocate nothing. Not thread-safe.
 */
public final class RayQuery {
    private static final int PASSED_ONE_BY_ONE = 3;

    private final PreparedScene scene;
    private final Ray ray = new Ray();
    private final Crossings crossings;
    private final RayTraversal traversal = new RayTraversal();
    private final Hit hit = new Hit();
    private boolean isStarted;
    private int passed;
    private Surface surface;

    public RayQuery(PreparedScene scene) {
        this.scene = scene;
        crossings = new Crossings(scene.surfaces(), ray);
    }

    /** Begins with {@link #ray} as it is now. */
    public void begin() {
        isStarted = false;
    }

    /** Begins with a ray that leaves a hit on the side from which that was seen. */
    public void start(RayOrigin from, double dx, double dy, double dz) {
        ray.leave(from, dx, dy, dz);
        begin();
    }

    /**
     * Goes on to the next surface: the first at the first call, then the one after that. Few surfaces are tested once for
     * their first crossing; if the query goes on, once more for all their crossings. With many, a step searches the
     * hierarchies for one crossing, as most surfaces lie behind the next; from the fourth step on for as many as were passed,
     * as a ray that has passed some is likely to be among glass in glass. Long on purpose: the virtual machine does not compile
     * a method of more than 325 bytes into its callers again (DECISIONS).
     *
     * @return false if the ray meets no further surface
     */
    public boolean advance() {
        boolean knowsNext = isStarted && crossings.knowsNext();
        if (!isStarted) {
            isStarted = true;
            passed = 0;
            crossings.findNearest();
        } else if (!knowsNext) {
            crossings.findNext(!scene.hasHierarchy() ? Integer.MAX_VALUE : passed <= PASSED_ONE_BY_ONE ? 1 : passed);
        }
        if (!knowsNext) {
            for (SurfaceList list : scene.lists()) {
                list.offerCrossings(ray, traversal, crossings);
            }
            RayOrigin origin = ray.origin();
            if (origin.side() == Departure.INWARD && scene.surface(origin.surface()) instanceof Body body) {
                crossings.offer(body.farWall(ray), origin.surface());
            }
        }
        if (crossings.keepsMany()) {
            crossings.advance();
        }
        passed++;
        if (crossings.isMiss()) {
            return false;
        }
        int number = crossings.surface();
        surface = scene.surface(number);
        surface.describe(ray, number, crossings.distance(), hit);
        if (surface instanceof Box box && hit.side() == Departure.OUTWARD) {
            // where boxes touch, a ray may meet the edge of one whose side is hidden by the next: what is seen there is a face
            // whose plane is that of a face of the others, too
            int faces = box.facesEntered(hit.origin(), ray);
            if (Integer.bitCount(faces) > 1) {
                int shared = scene.boxes().sharedFaces(faces, hit.origin(), ray, traversal);
                box.describeOnFaces(shared, ray, number, crossings.distance(), hit);
            }
        }
        return true;
    }

    /** The ray, to be set before {@link #begin}. */
    public Ray ray() {
        return ray;
    }

    /** Number of the surface reached, counted from 0 in the order of the scene. */
    public int surface() {
        return crossings.surface();
    }

    /** Number of the material of the surface reached, counted from 0. */
    public int material() {
        return surface.material();
    }

    /** Where the surface was reached; overwritten by the next step. */
    public Hit hit() {
        return hit;
    }
}
