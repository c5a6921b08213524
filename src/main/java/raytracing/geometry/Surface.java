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
     * @param origin start of the ray
     * @param direction of the ray, not zero, any length
     * @param departure how the origin lies to this surface
     * @return smallest t above 0 with origin + t direction on the surface, or {@link #MISS}; never NaN
     */
    double firstCrossing(Vector origin, Vector direction, Departure departure);

    /**
     * The normal where a ray meets this surface.
     *
     * @param origin start of the ray
     * @param direction of the ray
     * @param distance what {@link #firstCrossing} returned for this ray, not {@link #MISS}
     * @return unit normal, out of the body; of a plane, to the side its scene line names
     */
    Vector outwardNormal(Vector origin, Vector direction, double distance);

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
        Vector outward = outwardNormal(ray.origin(), ray.direction(), distance);
        Vector point = ray.origin().plus(distance, ray.direction());
        boolean fromInside = outward.dot(ray.direction()) > 0;
        return fromInside
            ? new Hit(number, material(), distance, point, outward.negated(), Departure.INWARD)
            : new Hit(number, material(), distance, point, outward, Departure.OUTWARD);
    }
}
