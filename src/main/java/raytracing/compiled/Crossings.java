package raytracing.compiled;

import java.util.Arrays;
import raytracing.geometry.Ray;
import raytracing.geometry.Surface;

/**
 * What a ray has met so far, as its query goes from surface to surface: either the nearest crossing alone, or all of them.
 * Crossings are ordered by distance, and at equal distances by the number of the surface: so coincident surfaces have
 * an order too, the one of the scene, and a walk from each crossing to the next meets every surface once. One thread, query
 * after query.
 */
final class Crossings {
    private double afterDistance;
    private int afterSurface;
    private double distance;
    private int surface;

    private boolean keepsAll;
    private double[] distances = new double[16];
    private int[] surfaces = new int[16];
    private int count;
    private int next;

    /** Begins a query for the nearest crossing of all. */
    void findNearest() {
        findAfter(0, Integer.MAX_VALUE);
        keepsAll = false;
    }

    /** Begins a query for the nearest crossing after the one found. */
    void findNearestAfterThis() {
        findAfter(distance, surface);
    }

    /** Begins a query for all crossings after the one found. */
    void findFurther() {
        findAfter(distance, surface);
        keepsAll = true;
    }

    private void findAfter(double crossing, int number) {
        afterDistance = crossing;
        afterSurface = number;
        distance = Surface.MISS;
        surface = Ray.NO_SURFACE;
        count = 0;
        next = 0;
    }

    /** Takes note of a crossing. A miss never comes before anything, so it changes nothing. */
    void offer(double crossing, int number) {
        if (comesBefore(crossing, number, distance, surface)
                && comesBefore(afterDistance, afterSurface, crossing, number)) {
            if (keepsAll) {
                keep(crossing, number);
            } else {
                distance = crossing;
                surface = number;
            }
        }
    }

    private void keep(double crossing, int number) {
        if (count == surfaces.length) {
            distances = Arrays.copyOf(distances, 2 * count);
            surfaces = Arrays.copyOf(surfaces, 2 * count);
        }
        int place = count++;
        while (place > 0 && comesBefore(crossing, number, distances[place - 1], surfaces[place - 1])) {
            distances[place] = distances[place - 1];
            surfaces[place] = surfaces[place - 1];
            place--;
        }
        distances[place] = crossing;
        surfaces[place] = number;
    }

    private static boolean comesBefore(double distance, int surface, double otherDistance, int otherSurface) {
        return distance < otherDistance || distance == otherDistance && surface < otherSurface;
    }

    boolean keepsAll() {
        return keepsAll;
    }

    /** After a query for all: goes on to the next of them, or to a miss. */
    void advance() {
        boolean isOver = next == count;
        distance = isOver ? Surface.MISS : distances[next];
        surface = isOver ? Ray.NO_SURFACE : surfaces[next];
        next++;
    }

    boolean isMiss() {
        return distance == Surface.MISS;
    }

    /** The nearest crossing so far, or the one that was advanced to; while all are asked for, there is none. */
    double distance() {
        return distance;
    }

    /** Number of the surface of that crossing. */
    int surface() {
        return surface;
    }
}
