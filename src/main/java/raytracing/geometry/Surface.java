package raytracing.geometry;

import raytracing.math.Vector;

/**
 * A surface of the scene: the readable truth behind the arrays of the compiled scene, which call the same kernels
 * and give the same bits. Immutable.
 */
public sealed interface Surface permits Sphere, Plane, Box {
    /** "No crossing": beyond every distance, so that comparing distances needs no special case. */
    double MISS = Double.POSITIVE_INFINITY;

    /**
     * Number of the surface's material.
     *
     * @return counted from 0 in the order of the scene
     */
    int material();

    /**
     * Where a ray first meets this surface. A ray that starts inside a body meets its wall from inside.
     *
     * @param ray the ray, its direction of any length but 0
     * @param departure how the ray's origin lies to this surface
     * @return smallest t above 0 with origin + t direction on the surface, or {@link #MISS}; never NaN
     */
    double firstCrossing(Ray ray, Departure departure);

    /**
     * Whether this surface lies in the way between two points.
     *
     * @param segment the open line between them
     * @param departure how the line's start lies to this surface
     * @return true if the line enters or leaves the surface strictly between its ends; the same from either end
     */
    boolean crosses(Segment segment, Departure departure);

    /**
     * Where a ray meets this surface that starts on it and goes inwards.
     *
     * @param ox origin, x part
     * @param oy y part
     * @param oz z part
     * @param dx direction, x part; not all three 0
     * @param dy y part
     * @param dz z part
     * @return crossing of the far wall, above 0, or {@link #MISS}; a plane has none
     */
    double farWall(double ox, double oy, double oz, double dx, double dy, double dz);

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
     * surface than that.
     *
     * @param ox the ray's origin, x part
     * @param oy y part
     * @param oz z part
     * @param dx its direction, x part
     * @param dy y part
     * @param dz z part
     * @param distance what {@link #firstCrossing} returned for it, not {@link #MISS}
     * @param found takes the point, its error, the normal towards the ray's origin, and the side
     */
    void describe(double ox, double oy, double oz, double dx, double dy, double dz, double distance, HitPoint found);

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
     * A crossing as a value.
     *
     * @param ray the ray
     * @param distance what {@link #firstCrossing} returned for it, not {@link #MISS}
     * @param number this surface's number in the scene
     * @return point, normal towards the ray's origin, and the side
     */
    default Hit hit(Ray ray, double distance, int number) {
        Vector o = ray.origin();
        Vector d = ray.direction();
        HitPoint found = new HitPoint();
        describe(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), distance, found);
        return found.toHit(number, material(), distance);
    }
}
