package raytracing.compiled;

import raytracing.geometry.Ray;
import raytracing.geometry.Surface;

/**
 * The nearest crossing found so far by one query, among those that come after a given one. Crossings are ordered by
 * distance, and at equal distances by the number of the surface: so coincident surfaces have an order too, the one
 * of the scene, and a walk from each crossing to the next meets every surface once. One thread, query after query.
 */
final class Nearest {
    private double afterDistance;
    private int afterSurface;
    private double distance;
    private int surface;

    /** Begins a query for the first crossing of all. */
    void restart() {
        restartAfter(0, Integer.MAX_VALUE);
    }

    /** Begins a query for the first crossing after another. */
    void restartAfter(double crossing, int number) {
        afterDistance = crossing;
        afterSurface = number;
        distance = Surface.MISS;
        surface = Ray.NO_SURFACE;
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
