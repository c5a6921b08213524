package raytracing.shade;

import java.util.Arrays;
import raytracing.compiled.RayWalk;
import raytracing.geometry.Departure;
import raytracing.geometry.HitPoint;

/**
 * The mirrored rays of one pixel that still have to be followed, the one with the greatest weight first. One thread, pixel
 * after pixel: the rays lie in flat arrays, and a binary heap holds their places (Williams, Algorithm 232, Heapsort, CACM
 * 7:6, 1964).
 *
 * <p>In a hall of transparent mirrors every ray splits at every wall, and following all of them would take time that
 * grows exponentially with the recursion limit. So the work for a pixel is limited; as the heaviest rays go first,
 * what is left out is what weighs least.
 */
final class Branches {
    /** Numbers of one ray: origin, its error, direction, weight. */
    private static final int STRIDE = 10;

    private double[] numbers = new double[8 * STRIDE];
    private int[] surface = new int[8];
    private Departure[] side = new Departure[8];
    private int[] reflections = new int[8];
    private long[] key = new long[8];
    private double[] heaviest = new double[8];
    private int[] heap = new int[8];
    private int waiting;
    private int added;
    private int taken;

    /** For a new pixel. */
    void clear() {
        waiting = 0;
        added = 0;
    }

    /**
     * Adds a ray that leaves a hit on the side from which it was seen.
     *
     * @param from the hit
     * @param surfaceLeft number of the surface that was hit
     * @param dx the ray's unit direction, x part
     * @param dy y part
     * @param dz z part
     * @param weight factor on whatever it sees, in the pixel
     * @param reflectionCount how often light was mirrored between this ray and the eye
     * @param rayKey of its random numbers
     */
    void add(HitPoint from, int surfaceLeft, double dx, double dy, double dz, Weight weight, int reflectionCount,
             long rayKey) {
        if (added == heap.length) {
            grow();
        }
        int i = added * STRIDE;
        numbers[i] = from.x();
        numbers[i + 1] = from.y();
        numbers[i + 2] = from.z();
        numbers[i + 3] = from.error();
        numbers[i + 4] = dx;
        numbers[i + 5] = dy;
        numbers[i + 6] = dz;
        numbers[i + 7] = weight.red();
        numbers[i + 8] = weight.green();
        numbers[i + 9] = weight.blue();
        surface[added] = surfaceLeft;
        side[added] = from.side();
        reflections[added] = reflectionCount;
        key[added] = rayKey;
        heaviest[added] = weight.max();
        rise(waiting++, added++);
    }

    private void grow() {
        numbers = Arrays.copyOf(numbers, 2 * numbers.length);
        surface = Arrays.copyOf(surface, 2 * added);
        side = Arrays.copyOf(side, 2 * added);
        reflections = Arrays.copyOf(reflections, 2 * added);
        key = Arrays.copyOf(key, 2 * added);
        heaviest = Arrays.copyOf(heaviest, 2 * added);
        heap = Arrays.copyOf(heap, 2 * added);
    }

    /** Takes the heaviest ray; false if none is left. */
    boolean next() {
        if (waiting == 0) {
            return false;
        }
        taken = heap[0];
        int last = heap[--waiting];
        sink(last);
        return true;
    }

    /** Of equal weights the older ray goes first, so that the picture depends on no chance. */
    private boolean goesBefore(int ray, int other) {
        return heaviest[ray] > heaviest[other] || heaviest[ray] == heaviest[other] && ray < other;
    }

    private void rise(int from, int ray) {
        int place = from;
        while (place > 0 && goesBefore(ray, heap[(place - 1) / 2])) {
            heap[place] = heap[(place - 1) / 2];
            place = (place - 1) / 2;
        }
        heap[place] = ray;
    }

    private void sink(int ray) {
        int place = 0;
        while (2 * place + 1 < waiting) {
            int child = 2 * place + 1;
            if (child + 1 < waiting && goesBefore(heap[child + 1], heap[child])) {
                child++;
            }
            if (goesBefore(ray, heap[child])) {
                break;
            }
            heap[place] = heap[child];
            place = child;
        }
        heap[place] = ray;
    }

    /** Starts a walk along the ray taken. */
    void start(RayWalk walk) {
        int i = taken * STRIDE;
        walk.start(numbers[i], numbers[i + 1], numbers[i + 2], numbers[i + 3], numbers[i + 4], numbers[i + 5],
            numbers[i + 6], surface[taken], side[taken]);
    }

    /** Weight of the ray taken. */
    void weigh(Weight weight) {
        int i = taken * STRIDE;
        weight.set(numbers[i + 7], numbers[i + 8], numbers[i + 9]);
    }

    /** Reflections between the ray taken and the eye. */
    int reflections() {
        return reflections[taken];
    }

    /** Key of the random numbers of the ray taken. */
    long key() {
        return key[taken];
    }
}
