package raytracing.geometry;

import java.util.Optional;
import raytracing.math.Surd;
import raytracing.math.Vector;

/**
 * A surface of the scene: the readable truth behind the arrays of the compiled scene, which call the same kernels
 * and give the same bits. Immutable.
 */
public sealed interface Surface permits Sphere, Plane, Box {
    /** "No crossing": beyond every distance, so that comparing distances needs no special case. */
    double MISS = Double.POSITIVE_INFINITY;

    /** "Doubles cannot tell": no number, so that every comparison with a distance is false. */
    double UNDECIDED = Double.NaN;

    /**
     * Number of the surface's material.
     *
     * @return counted from 0 in the order of the scene
     */
    int material();

    /**
     * Where a ray first meets this surface, exactly. A ray that starts inside a body meets its wall from inside; one that
     * starts on the surface, and heads to the other side than that from which its start was seen, meets it at once.
     *
     * @param origin where the ray starts
     * @param number this surface's number in the scene
     * @param direction where the ray goes; any length but 0
     * @return smallest t of at least 0 with origin + t direction on the surface, if there is one
     */
    Optional<Surd> crossing(Standpoint origin, int number, Vector direction);

    /**
     * Whether this surface lies in the way between two points, decided exactly.
     *
     * @param start one end of the line, not on this surface by its number
     * @param number this surface's number in the scene
     * @param end the other end
     * @param endError how far each part of it may be off; within that of the surface, it lies on it
     * @return true if the open line enters or leaves the surface
     */
    boolean isCrossedBetween(Standpoint start, int number, Vector end, double endError);

    /**
     * On which side of this surface a point lies, decided exactly.
     *
     * @param point the point
     * @param number this surface's number in the scene
     * @return 1 outside a body or where a plane's normal points, -1 inside or on the plane's other side; 0 if the point
     *         is on the surface as far as it is known, and nothing tells from which side it was seen
     */
    int side(Standpoint point, int number);

    /**
     * Whether another surface is the same set of points, written with the same numbers.
     *
     * @param other any surface
     * @return false also of equal sets that are written otherwise
     */
    boolean isInPlaceOf(Surface other);

    /**
     * Where a ray meets this surface that starts on it and goes inwards.
     *
     * @param origin where it starts
     * @param dx direction, x part; not all three 0
     * @param dy y part
     * @param dz z part
     * @return crossing of the far wall, above 0, {@link #MISS}, which is what a plane has, or {@link #UNDECIDED}
     */
    double farWall(Standpoint origin, double dx, double dy, double dz);

    /**
     * Whether a straight line that starts on this surface and goes inwards leaves the body before it ends.
     *
     * @param qx the line's end, x part
     * @param qy y part
     * @param qz z part
     * @param endError how far each part of it may be off; within that of the surface, it lies on it
     * @return true if the end is strictly outside; of a plane, which has no inside, never
     */
    boolean isLeftBefore(double qx, double qy, double qz, double endError);

    /**
     * Whether a ball is certainly outside this surface's body.
     *
     * @param x middle of the ball, x part
     * @param y y part
     * @param z z part
     * @param r its radius, at least 0
     * @return false if it touches the body, or rounding leaves it open; of a plane, always
     */
    boolean isApartFrom(double x, double y, double z, double r);

    /**
     * Everything about a crossing that shading wants to know. The point is at origin + distance direction or nearer to the
     * surface than that; at distance 0 it is the origin itself.
     *
     * @param origin where the ray starts
     * @param number this surface's number in the scene
     * @param dx the ray's direction, x part
     * @param dy y part
     * @param dz z part
     * @param distance the crossing, not {@link #MISS}
     * @param found takes the point, its error, the normal towards the ray's origin, and how it was reached
     */
    void describe(Standpoint origin, int number, double dx, double dy, double dz, double distance, HitPoint found);

    /**
     * Presents this surface to a receiver that has one method for every kind.
     *
     * @param receiver who takes it
     */
    void presentTo(Receiver receiver);

    /** One method for every kind of surface: a new kind does not compile until every receiver has an answer. */
    interface Receiver {
        /**
         * Takes a sphere.
         *
         * @param sphere the surface
         */
        void sphere(Sphere sphere);

        /**
         * Takes a plane.
         *
         * @param plane the surface
         */
        void plane(Plane plane);

        /**
         * Takes a box.
         *
         * @param box the surface
         */
        void box(Box box);
    }

    /**
     * An exact crossing as a double.
     *
     * @param crossing of at least 0, if there is one
     * @return the nearest double; above 0, the nearest that is above 0 and finite; {@link #MISS} if there is none
     */
    static double distance(Optional<Surd> crossing) {
        if (crossing.isEmpty()) {
            return MISS;
        }
        Surd exact = crossing.get();
        return exact.signum() == 0 ? 0
            : Math.max(Double.MIN_VALUE, Math.min(Double.MAX_VALUE, exact.doubleValue()));
    }

    /**
     * A crossing as a value.
     *
     * @param ray the ray
     * @param distance the crossing, not {@link #MISS}
     * @param number this surface's number in the scene
     * @return point, normal towards the ray's origin, and the side
     */
    default Hit hit(Ray ray, double distance, int number) {
        Vector o = ray.origin();
        Vector d = ray.direction();
        Standpoint origin = new Standpoint();
        origin.start(o.x(), o.y(), o.z(), ray.originError(), ray.surfaceLeft(), ray.departure());
        HitPoint found = new HitPoint();
        describe(origin, number, d.x(), d.y(), d.z(), distance, found);
        return found.toHit(material(), distance);
    }
}
