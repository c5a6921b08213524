package raytracing.compiled;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import raytracing.geometry.Ray;
import raytracing.geometry.Surface;
import raytracing.math.Surd;

/**
 * What a ray has met so far, as its query goes from surface to surface: either the nearest crossing alone, or all of them.
 * Crossings are ordered as the real numbers are that they stand for, and equal ones by the number of the surface: so coincident
 * surfaces have an order too, the one of the scene, and a walk from each crossing to the next meets every surface once. Where
 * distances in doubles are too close for that, exact ones are compared. One thread, query after query.
 */
final class Crossings {
    /**
     * Distances further apart than this, relative to either, are in the order of the exact ones: 32 times the error of
     * two crossings, each at most 16 units in the last place.
     */
    private static final double CLOSE = 0x1p-43;
    private static final double NEARER = 1 - CLOSE;

    private final RayWalk ray;
    private double afterDistance;
    private int afterSurface;
    private double distance;
    private int surface;

    /** Beyond this, a crossing comes after the one found so far; before the other, it comes before it. */
    private double clearlyAfterFound;
    private double clearlyBeforeFound;

    /** Beyond this, a crossing comes after the one from which the query started. */
    private double clearlyAfterStart;

    /** Of the few surfaces of a ray whose distances are too close, by number. */
    private final Map<Integer, Surd> exactCrossings = new HashMap<>();

    private boolean keepsAll;
    private double[] distances = new double[16];
    private int[] surfaces = new int[16];
    private int count;
    private int next;

    Crossings(RayWalk ray) {
        this.ray = ray;
    }

    /** Begins a query for the nearest crossing of all, those at the ray's origin included. */
    void findNearest() {
        findAfter(0, Ray.NO_SURFACE);
        exactCrossings.clear();
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
        clearlyAfterStart = crossing * (1 + CLOSE);
        count = 0;
        next = 0;
        find(Surface.MISS, Ray.NO_SURFACE);
    }

    private void find(double crossing, int number) {
        distance = crossing;
        surface = number;
        clearlyAfterFound = crossing * (1 + CLOSE);
        clearlyBeforeFound = NEARER * crossing;
    }

    /**
     * Takes note of a crossing, if it comes after the start of the query, and no nearer one is known. Most are decided by
     * two comparisons.
     */
    void offer(double crossing, int number) {
        if (crossing > clearlyAfterFound || crossing == Surface.MISS) {
            return;
        }
        boolean isClearlyAfterStart = crossing > clearlyAfterStart;
        if (isClearlyAfterStart && keepsAll) {
            keep(crossing, number);
        } else if (isClearlyAfterStart && crossing < clearlyBeforeFound) {
            find(crossing, number);
        } else {
            offerClose(crossing, number);
        }
    }

    private void offerClose(double quickCrossing, int number) {
        double crossing = Double.isNaN(quickCrossing) ? exactDistance(number) : quickCrossing;
        if (crossing == Surface.MISS || number == afterSurface || !comesBefore(afterDistance, afterSurface, crossing, number)) {
            return;
        }
        if (keepsAll) {
            keep(crossing, number);
        } else if (comesBefore(crossing, number, distance, surface)) {
            find(crossing, number);
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

    private boolean comesBefore(double crossing, int number, double otherCrossing, int otherNumber) {
        if (crossing < NEARER * otherCrossing || otherCrossing < NEARER * crossing) {
            return crossing < otherCrossing;
        }
        int order = order(crossing, number, otherCrossing, otherNumber);
        return order < 0 || order == 0 && number < otherNumber;
    }

    private double exactDistance(int number) {
        Optional<Surd> crossing = ray.exactCrossing(number);
        if (crossing.isPresent()) {
            exactCrossings.put(number, crossing.get());
        }
        return Surface.distance(crossing);
    }

    /** The exact crossing with a surface that the ray meets, found once. */
    private Surd exact(int number) {
        if (!exactCrossings.containsKey(number)) {
            exactCrossings.put(number, ray.exactCrossing(number).orElseThrow());
        }
        return exactCrossings.get(number);
    }

    /** Compares two close crossings exactly; the ray's origin, and a miss, count as a crossing of no surface. */
    private int order(double crossing, int number, double otherCrossing, int otherNumber) {
        if (number == Ray.NO_SURFACE || otherNumber == Ray.NO_SURFACE) {
            return Double.compare(crossing, otherCrossing);
        }
        return ray.isSame(number, otherNumber) ? 0 : exact(number).compareTo(exact(otherNumber));
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

    /** The last distance at which a crossing may come before that one. */
    double latest() {
        return clearlyAfterFound;
    }

    /** Number of the surface of that crossing. */
    int surface() {
        return surface;
    }
}
