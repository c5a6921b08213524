package raytracing.trace;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import raytracing.math.Surd;
import raytracing.surface.Ray;
import raytracing.surface.RayOrigin;
import raytracing.surface.Surface;

/**
 * The crossings that a query of a ray has found: either the nearest alone, or the next few, or all of them.
 * Crossings are ordered as the real numbers that they stand for, and equal ones by the number of the surface. So coincident
 * surfaces have an order too, that of the scene, and a query that goes from each crossing to the next meets every surface once.
 * Where distances in doubles are too close to be ordered, exact ones are compared. Not thread-safe.
 */
final class Crossings {
    /**
     * Distances further apart than this, relative to either, are in the order of the exact ones: 32 times the error of
     * two crossings, each at most 16 units in the last place.
     */
    private static final double CLOSE = 0x1p-43;
    private static final double NEARER = 1 - CLOSE;

    private final Surface[] surfaces;
    private final Ray ray;
    private double afterDistance;
    private int afterSurface;
    private double distance;
    private int surface;

    /** A crossing beyond the first number comes after the one found so far; one below the second comes before it. */
    private double clearlyAfterFound;
    private double clearlyBeforeFound;

    /** A crossing beyond this comes after the one from which the query started. */
    private double clearlyAfterStart;

    /** The exact crossings of the few surfaces whose distances are too close, by number. */
    private final Map<Integer, Surd> exactCrossings = new HashMap<>();

    /** Whether the query keeps more than the nearest crossing, and how many at most. */
    private boolean keepsMany;
    private int most;
    private double[] keptDistances = new double[16];
    private int[] keptNumbers = new int[16];
    private int count;
    private int next;

    Crossings(Surface[] surfaces, Ray ray) {
        this.surfaces = surfaces;
        this.ray = ray;
    }

    /** Begins a query for the nearest crossing of all, those at the ray's origin included. */
    void findNearest() {
        beginAfter(0, RayOrigin.NO_SURFACE);
        exactCrossings.clear();
        keepsMany = false;
    }

    /** Begins a query for the next crossings after the one found, at least one and at most so many. */
    void findNext(int atMost) {
        beginAfter(distance, surface);
        keepsMany = atMost > 1;
        most = atMost;
    }

    private void beginAfter(double crossing, int number) {
        afterDistance = crossing;
        afterSurface = number;
        clearlyAfterStart = crossing * (1 + CLOSE);
        count = 0;
        next = 0;
        setFound(Surface.MISS, RayOrigin.NO_SURFACE);
    }

    private void setFound(double crossing, int number) {
        distance = crossing;
        surface = number;
        clearlyAfterFound = crossing * (1 + CLOSE);
        clearlyBeforeFound = NEARER * crossing;
    }

    /** Keeps a crossing if it comes after the start of the query and before those found. Two comparisons decide for most. */
    void offer(double crossing, int number) {
        if (crossing > clearlyAfterFound || crossing == Surface.MISS) {
            return;
        }
        boolean isClearlyAfterStart = crossing > clearlyAfterStart;
        if (isClearlyAfterStart && keepsMany) {
            keep(crossing, number);
        } else if (isClearlyAfterStart && crossing < clearlyBeforeFound) {
            setFound(crossing, number);
        } else {
            offerClose(crossing, number);
        }
    }

    private void offerClose(double quickCrossing, int number) {
        double crossing = Double.isNaN(quickCrossing) ? exactDistance(number) : quickCrossing;
        if (crossing == Surface.MISS || number == afterSurface
                || !comesBefore(afterDistance, afterSurface, crossing, number)) {
            return;
        }
        if (keepsMany) {
            keep(crossing, number);
        } else if (comesBefore(crossing, number, distance, surface)) {
            setFound(crossing, number);
        }
    }

    /** Keeps a crossing at its place in the order; where that makes one too many, the last is forgotten. */
    private void keep(double crossing, int number) {
        int place = place(crossing, number);
        if (place == most) {
            return;
        }
        if (count == keptNumbers.length) {
            keptDistances = Arrays.copyOf(keptDistances, 2 * count);
            keptNumbers = Arrays.copyOf(keptNumbers, 2 * count);
        }
        count = Math.min(count + 1, most);
        System.arraycopy(keptDistances, place, keptDistances, place + 1, count - 1 - place);
        System.arraycopy(keptNumbers, place, keptNumbers, place + 1, count - 1 - place);
        keptDistances[place] = crossing;
        keptNumbers[place] = number;
        if (count == most) {
            setFound(keptDistances[count - 1], keptNumbers[count - 1]);
        }
    }

    /** How many of the kept crossings come before another one. */
    private int place(double crossing, int number) {
        int low = 0;
        int high = count;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (comesBefore(crossing, number, keptDistances[middle], keptNumbers[middle])) {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        return low;
    }

    private boolean comesBefore(double crossing, int number, double otherCrossing, int otherNumber) {
        if (crossing < NEARER * otherCrossing || otherCrossing < NEARER * crossing) {
            return crossing < otherCrossing;
        }
        int order = order(crossing, number, otherCrossing, otherNumber);
        return order < 0 || order == 0 && number < otherNumber;
    }

    private double exactDistance(int number) {
        Optional<Surd> crossing = surfaces[number].exactCrossing(ray, number);
        if (crossing.isPresent()) {
            exactCrossings.put(number, crossing.get());
        }
        return Surface.distance(crossing);
    }

    /** The exact crossing with a surface that the ray meets, found once. */
    private Surd exact(int number) {
        if (!exactCrossings.containsKey(number)) {
            exactCrossings.put(number, surfaces[number].exactCrossing(ray, number).orElseThrow());
        }
        return exactCrossings.get(number);
    }

    /** Compares two close crossings exactly; the ray's origin, and a miss, count as a crossing of no surface. */
    private int order(double crossing, int number, double otherCrossing, int otherNumber) {
        if (number == RayOrigin.NO_SURFACE || otherNumber == RayOrigin.NO_SURFACE) {
            return Double.compare(crossing, otherCrossing);
        }
        return areSame(number, otherNumber) ? 0 : exact(number).compareTo(exact(otherNumber));
    }

    /** Whether two surfaces are the same set of points, and so are crossed at once by a ray that starts on neither. */
    private boolean areSame(int number, int other) {
        int start = ray.origin().surface();
        return number != start && other != start && surfaces[number].isInPlaceOf(surfaces[other]);
    }

    boolean keepsMany() {
        return keepsMany;
    }

    /** Whether the next crossing is among those kept, or it is known that there is none. */
    boolean knowsNext() {
        return keepsMany && (next < count || count < most);
    }

    /** After a query for many: goes on to the next of them, or to a miss. */
    void advance() {
        boolean isOver = next == count;
        distance = isOver ? Surface.MISS : keptDistances[next];
        surface = isOver ? RayOrigin.NO_SURFACE : keptNumbers[next];
        next++;
    }

    boolean isMiss() {
        return distance == Surface.MISS;
    }

    /**
     * The nearest crossing so far, or the one that was advanced to; while a query collects many, the last of those that it
     * keeps at most, and none before it has as many.
     */
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
