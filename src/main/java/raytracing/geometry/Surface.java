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
     * The normal where a ray meets this surface.
     *
     * @param ray the ray
     * @param distance what {@link #firstCrossing} returned for it, not {@link #MISS}
     * @return unit normal, out of the body; of a plane, to the side its scene line names
     */
    Vector outwardNormal(Ray ray, double distance);

    /**
     * The point where a ray meets this surface, at origin + distance direction or nearer to the surface than that.
     *
     * @param ray the ray
     * @param distance what {@link #firstCrossing} returned for it, not {@link #MISS}
     * @param outwardNormal what {@link #outwardNormal} returned for it
     * @return the point, rounded
     */
    Vector point(Ray ray, double distance, Vector outwardNormal);

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
     * Everything about a crossing that shading wants to know.
     *
     * @param ray the ray
     * @param distance what {@link #firstCrossing} returned for it, not {@link #MISS}
     * @param number this surface's number in the scene
     * @return point, normal towards the ray's origin, and the side
     */
    default Hit hit(Ray ray, double distance, int number) {
        Vector outward = outwardNormal(ray, distance);
        Vector point = point(ray, distance, outward);
        double pointError = PointError.ofCrossing(ray.origin(), ray.direction(), distance);
        boolean fromInside = outward.dot(ray.direction()) > 0;
        return fromInside
            ? new Hit(number, material(), distance, point, pointError, outward.negated(), Departure.INWARD)
            : new Hit(number, material(), distance, point, pointError, outward, Departure.OUTWARD);
    }
}
