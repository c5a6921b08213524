package raytracing.compiled;

import raytracing.geometry.Ray;
import raytracing.geometry.Surface;

/**
 * The nearest crossing found so far by one query, among those that come after a given one. Crossings are ordered by
 * distance, and at equal distances by the number of the surface: so coincident surfaces have an order too, the one
 * of the scene, and a walk from each crossing to the next meets every surface once.
 */
final class Nearest {
    private final double afterDistance;
    private final int afterSurface;
    private double distance = Surface.MISS;
    private int surface = Ray.NO_SURFACE;

    Nearest(double afterDistance, int afterSurface) {
        this.afterDistance = afterDistance;
        this.afterSurface = afterSurface;
    }

    /** Takes note of a crossing. A miss never comes before anything, so it changes nothing. */
    void offer(double crossing, int number) {
        if (comesBefore(crossing, number, distance, surface)
                && comesBefore(afterDistance, afterSurface, crossing, number)) {
            distance = crossing;
            surface = number;
        }
    }

    private static boolean comesBefore(double distance, int surface, double otherDistance, int otherSurface) {
        return distance < otherDistance || distance == otherDistance && surface < otherSurface;
    }

    boolean isMiss() {
        return distance == Surface.MISS;
    }

    double distance() {
        return distance;
    }

    int surface() {
        return surface;
    }
}
