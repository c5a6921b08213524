package raytracing.compiled;

import raytracing.geometry.Departure;
import raytracing.geometry.Hit;
import raytracing.geometry.HitPoint;
import raytracing.geometry.Ray;
import raytracing.geometry.Surface;
import raytracing.math.AxisOrder;
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

    /** The order of axes in which the ray's sums run, and origin and direction in that order. */
    AxisOrder order;
    double ou;
    double ov;
    double ow;
    double du;
    double dv;
    double dw;

    private final CompiledScene scene;
    private final HierarchyWalk hierarchyWalk = new HierarchyWalk();
    private final Crossings crossings = new Crossings();
    private final HitPoint point = new HitPoint();
    private Departure departure;
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
        start(ray.origin().x(), ray.origin().y(), ray.origin().z(), ray.originError(),
            ray.direction().x(), ray.direction().y(), ray.direction().z(), ray.surfaceLeft(), ray.departure());
    }

    /**
     * Begins to walk along a ray given by its parts, as {@link Ray} names them.
     *
     * @param originX origin, x part, world axes
     * @param originY y part
     * @param originZ z part
     * @param error how far each part of the origin may be off
     * @param directionX direction, x part; not all three 0
     * @param directionY y part
     * @param directionZ z part
     * @param left number of the surface on which the ray starts, or {@link Ray#NO_SURFACE}
     * @param towards to which side of that surface it leaves
     */
    public void start(double originX, double originY, double originZ, double error,
                      double directionX, double directionY, double directionZ, int left, Departure towards) {
        ox = originX;
        oy = originY;
        oz = originZ;
        originError = error;
        dx = directionX;
        dy = directionY;
        dz = directionZ;
        surfaceLeft = left;
        departure = towards;
        order = AxisOrder.of(dx, dy, dz);
        ou = order.first(ox, oy, oz);
        ov = order.first(oy, oz, ox);
        ow = order.first(oz, ox, oy);
        du = order.first(dx, dy, dz);
        dv = order.first(dy, dz, dx);
        dw = order.first(dz, dx, dy);
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
        surface.describe(ox, oy, oz, dx, dy, dz, crossings.distance(), point);
        return true;
    }

    /**
     * Few surfaces are asked once for their first crossing of all; if the walk goes on, once more for all their crossings. Many
     * are asked for one crossing at a time, as most of them lie behind the next.
     */
    private void ask() {
        scene.offerCrossings(this, hierarchyWalk, crossings);
        if (departure == Departure.INWARD) {
            crossings.offer(scene.surface(surfaceLeft).farWall(ox, oy, oz, dx, dy, dz), surfaceLeft);
        }
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
        return new Ray(new Vector(ox, oy, oz), originError, new Vector(dx, dy, dz), surfaceLeft, departure);
    }

    /**
     * What the walk has reached, as a value that stays.
     *
     * @return the hit
     */
    public Hit hit() {
        return point.toHit(surface(), material(), crossings.distance());
    }
}
