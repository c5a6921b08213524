package raytracing.compiled;

import java.util.Optional;
import raytracing.geometry.Box;
import raytracing.geometry.Departure;
import raytracing.geometry.Hit;
import raytracing.geometry.HitPoint;
import raytracing.geometry.PointError;
import raytracing.geometry.Ray;
import raytracing.geometry.Standpoint;
import raytracing.geometry.Surface;
import raytracing.math.Surd;
import raytracing.math.Vector;

/**
 * A walk along a ray, from surface to surface. Every surface counts once along a ray, with its first crossing; a walk
 * passes each of them once, coincident ones included, those at equal distances in the order of the scene.
 *
 * <p>One thread, used for ray after ray: so rays make no garbage.
 */
public final class RayWalk {
    double ox;
    double oy;
    double oz;
    double dx;
    double dy;
    double dz;
    double originError;
    int surfaceLeft;

    private final CompiledScene scene;
    private final HierarchyWalk hierarchyWalk = new HierarchyWalk();
    private final Standpoint origin = new Standpoint();
    private final Crossings crossings = new Crossings(this);
    private final HitPoint point = new HitPoint();
    private boolean isStarted;
    private Surface surface;

    /**
     * A walk that has not started.
     *
     * @param scene the surfaces
     */
    public RayWalk(CompiledScene scene) {
        this.scene = scene;
    }

    /**
     * Begins to walk along a ray.
     *
     * @param ray any ray
     */
    public void start(Ray ray) {
        Vector o = ray.origin();
        origin.start(o.x(), o.y(), o.z(), ray.originError(), ray.surfaceLeft(), ray.departure());
        start(ray.direction().x(), ray.direction().y(), ray.direction().z());
    }

    /**
     * Begins to walk from a point that the scene names.
     *
     * @param from the point, world axes
     * @param directionX direction, x part; not all three 0
     * @param directionY y part
     * @param directionZ z part
     */
    public void start(Vector from, double directionX, double directionY, double directionZ) {
        origin.start(from.x(), from.y(), from.z(), PointError.written(from), Ray.NO_SURFACE, Departure.ELSEWHERE);
        start(directionX, directionY, directionZ);
    }

    /**
     * Begins to walk from a hit, on the side from which it was seen.
     *
     * @param from the hit's place
     * @param directionX direction, x part; not all three 0
     * @param directionY y part
     * @param directionZ z part
     */
    public void start(Standpoint from, double directionX, double directionY, double directionZ) {
        origin.take(from);
        start(directionX, directionY, directionZ);
    }

    private void start(double directionX, double directionY, double directionZ) {
        ox = origin.x();
        oy = origin.y();
        oz = origin.z();
        originError = origin.error();
        surfaceLeft = origin.surface();
        dx = directionX;
        dy = directionY;
        dz = directionZ;
        isStarted = false;
    }

    /**
     * Goes on to the next surface: the first at the first call, then after the one reached last.
     *
     * @return false if the ray meets no further one
     */
    public boolean advance() {
        boolean knowsTheRest = isStarted && crossings.keepsAll();
        if (!isStarted) {
            isStarted = true;
            crossings.findNearest();
        } else if (scene.hasHierarchy()) {
            crossings.findNearestAfterThis();
        } else if (!knowsTheRest) {
            crossings.findFurther();
        }
        if (!knowsTheRest) {
            ask();
        }
        if (crossings.keepsAll()) {
            crossings.advance();
        }
        if (crossings.isMiss()) {
            return false;
        }
        surface = scene.surface(crossings.surface());
        surface.describe(origin, crossings.surface(), dx, dy, dz, crossings.distance(), point);
        if (surface instanceof Box box && point.side() == Departure.OUTWARD) {
            chooseFace(box);
        }
        return true;
    }

    /**
     * Where boxes touch, a ray may meet the edge of one whose side is hidden by the next: what is seen there is a face
     * whose plane is that of a face of the others, too.
     */
    private void chooseFace(Box box) {
        int faces = box.facesEntered(point, dx, dy, dz);
        if (Integer.bitCount(faces) < 2) {
            return;
        }
        int shared = scene.boxes().sharedFaces(faces, point, dx, dy, dz, hierarchyWalk);
        if (!point.isOnFace(shared)) {
            box.describe(origin, crossings.surface(), dx, dy, dz, crossings.distance(),
                Integer.numberOfTrailingZeros(shared), Departure.OUTWARD, point);
        }
    }

    /**
     * Few surfaces are asked once for their first crossing of all; if the walk goes on, once more for all their crossings. Many
     * are asked for one crossing at a time, as most of them lie behind the next.
     */
    private void ask() {
        scene.offerCrossings(this, hierarchyWalk, crossings);
        if (origin.side() == Departure.INWARD) {
            crossings.offer(scene.surface(surfaceLeft).farWall(origin, dx, dy, dz), surfaceLeft);
        }
    }

    /** Whether two surfaces are the same set of points, and so are crossed at once by a ray that leaves neither. */
    boolean isSame(int number, int other) {
        return number != surfaceLeft && other != surfaceLeft && scene.surface(number).isInPlaceOf(scene.surface(other));
    }

    /** The first crossing with a surface in exact numbers, if there is one. */
    Optional<Surd> exactCrossing(int number) {
        return scene.surface(number).crossing(origin, number, new Vector(dx, dy, dz));
    }

    /**
     * The surface reached.
     *
     * @return its number, counted from 0 in the order of the scene
     */
    public int surface() {
        return crossings.surface();
    }

    /**
     * The material of the surface reached.
     *
     * @return its number, counted from 0
     */
    public int material() {
        return surface.material();
    }

    /**
     * Where the surface was reached.
     *
     * @return point and normal, overwritten by the next step
     */
    public HitPoint point() {
        return point;
    }

    /**
     * The ray's direction.
     *
     * @return x part
     */
    public double directionX() {
        return dx;
    }

    /**
     * The ray's direction.
     *
     * @return y part
     */
    public double directionY() {
        return dy;
    }

    /**
     * The ray's direction.
     *
     * @return z part
     */
    public double directionZ() {
        return dz;
    }

    /**
     * The ray, as a value that stays.
     *
     * @return what the walk was started with
     */
    public Ray ray() {
        return new Ray(new Vector(ox, oy, oz), originError, new Vector(dx, dy, dz), surfaceLeft, origin.side());
    }

    /**
     * What the walk has reached, as a value that stays.
     *
     * @return the hit
     */
    public Hit hit() {
        return point.toHit(material(), crossings.distance());
    }
}
