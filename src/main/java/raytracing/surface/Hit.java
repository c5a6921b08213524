package raytracing.surface;

import raytracing.math.UnitVector;
import raytracing.math.Vector;

/**
 * Where a ray met a surface: the point, as the origin of rays that leave it, and the unit normal, turned towards the ray's
 * origin. World axes. Mutable, so that following millions of rays allocates nothing: the shapes write it, all others read
 * it. Not thread-safe.
 */
public final class Hit {
    /** Far above the rounding of a unit normal and of a dot product with it. */
    private static final double ROUNDING = 0x1p-44;

    private final RayOrigin origin = new RayOrigin();

    /** Points out of the body until {@link #reach} turns it. */
    final UnitVector normal = new UnitVector();

    /** How far the point is from the ray's origin, as the largest of its three coordinates. */
    private double way;

    /** Nothing met yet. */
    public Hit() {
    }

    /** Becomes a copy of another hit. */
    public void set(Hit other) {
        origin.set(other.origin);
        normal.set(other.normal);
        way = other.way;
    }

    /** Places the point at the end of a path of this length along a ray, off by a crossing's error. */
    void placeAlong(Ray ray, double pathLength, double x, double y, double z) {
        RayOrigin from = ray.origin;
        way = pathLength;
        origin.place(x, y, z, PointError.ofCrossing(Vector.largestPart(from.x, from.y, from.z) + way));
    }

    /** Places the point at a ray's own origin, if the ray meets the surface there. */
    void placeAtOrigin(Ray ray) {
        way = 0;
        origin.place(ray.origin.x, ray.origin.y, ray.origin.z, ray.origin.error);
    }

    /** Whether the component of a ray's direction along a unit normal has a sign beyond rounding. */
    static boolean isClear(double along, Ray ray) {
        return Math.abs(along) > ROUNDING * Vector.largestPart(ray.dx, ray.dy, ray.dz);
    }

    /** Turns the normal towards the ray's origin, and records how the point was reached. */
    void reach(Ray ray, int surface, Departure side) {
        if (side == Departure.INWARD) {
            normal.negate();
        }
        origin.reach(surface, side, ray.origin, way);
    }

    /** Scales back what was described at a fraction of the ray's world. */
    void enlarge(double factor, Ray ray) {
        origin.place(factor * origin.x, factor * origin.y, factor * origin.z, factor * origin.error);
        origin.reach(origin.surface, origin.side, ray.origin, factor * way);
    }

    /** Where rays and segments from here start; overwritten by the next hit. */
    public RayOrigin origin() {
        return origin;
    }

    public double x() {
        return origin.x;
    }

    public double y() {
        return origin.y;
    }

    public double z() {
        return origin.z;
    }

    /** How far each coordinate of the point may be off, in scene units. */
    public double error() {
        return origin.error;
    }

    /** Number of the surface, counted from 0 in the order of the scene. */
    public int surface() {
        return origin.surface;
    }

    /** {@link Departure#OUTWARD} if the surface was seen from outside its body, else {@link Departure#INWARD}. */
    public Departure side() {
        return origin.side;
    }

    public double normalX() {
        return normal.x();
    }

    public double normalY() {
        return normal.y();
    }

    public double normalZ() {
        return normal.z();
    }

    /** The dot product of the normal with any vector. */
    public double alongNormal(double vx, double vy, double vz) {
        return normal.dot(vx, vy, vz);
    }

    /** How a straight line of any direction but 0 leaves the surface from here: into the body,
        or out of it or along its wall. */
    public Departure departureTowards(double dx, double dy, double dz) {
        return Departure.towards(origin.side, alongNormal(dx, dy, dz));
    }
}
