package raytracing.shade;

import java.util.Arrays;
import raytracing.compiled.RayWalk;
import raytracing.geometry.Standpoint;

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
    /** Numbers of one ray: direction, weight. */
    private static final int STRIDE = 6;

    private static final int FIRST_SIZE = 8;

    private Standpoint[] origins = origins(FIRST_SIZE);
    private double[] numbers = new double[FIRST_SIZE * STRIDE];
    private int[] reflections = new int[FIRST_SIZE];
    private long[] key = new long[FIRST_SIZE];
    private double[] heaviest = new double[FIRST_SIZE];
    private int[] heap = new int[FIRST_SIZE];
    private int waiting;
    private int added;
    private int taken;

    private static Standpoint[] origins(int count) {
        Standpoint[] origins = new Standpoint[count];
        for (int i = 0; i < count; i++) {
            origins[i] = new Standpoint();
        }
        return origins;
    }

    /** For a new pixel. */
    void clear() {
        waiting = 0;
        added = 0;
    }

    /**
     * Adds a ray that leaves a hit on the side from which it was seen.
     *
     * @param from the hit's place
     * @param dx the ray's unit direction, x part
     * @param dy y part
     * @param dz z part
     * @param weight factor on whatever it sees, in the pixel
     * @param reflectionCount how often light was mirrored between this ray and the eye
     * @param rayKey of its random numbers
     */
    void add(Standpoint from, double dx, double dy, double dz, Weight weight, int reflectionCount, long rayKey) {
        if (added == heap.length) {
            grow();
        }
        origins[added].take(from);
        int i = added * STRIDE;
        numbers[i] = dx;
        numbers[i + 1] = dy;
        numbers[i + 2] = dz;
        numbers[i + 3] = weight.red();
        numbers[i + 4] = weight.green();
        numbers[i + 5] = weight.blue();
        reflections[added] = reflectionCount;
        key[added] = rayKey;
        heaviest[added] = weight.max();
        rise(waiting++, added++);
    }

    private void grow() {
        numbers = Arrays.copyOf(numbers, 2 * numbers.length);
        Standpoint[] more = origins(2 * added);
        System.arraycopy(origins, 0, more, 0, added);
        origins = more;
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
        walk.start(origins[taken], numbers[i], numbers[i + 1], numbers[i + 2]);
    }

    /** Weight of the ray taken. */
    void weigh(Weight weight) {
        int i = taken * STRIDE;
        weight.set(numbers[i + 3], numbers[i + 4], numbers[i + 5]);
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
