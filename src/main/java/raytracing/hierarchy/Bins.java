package raytracing.hierarchy;

import java.util.Arrays;

/**
 * Where to cut a group of bodies in two. The bodies go into bins of equal width by their centres, along the axis on
 * which these spread furthest. Of the cuts between bins the best is the one with the least sum, over both sides, of the
 * number of bodies times the surface around them: a ray that meets a box meets a convex part of it with a chance
 * proportional to the part's surface (MacDonald, Booth, Heuristics for Ray Tracing Using Space Subdivision, The Visual
 * Computer 6, 1990; with bins: Wald, On Fast Construction of SAH-based Bounding Volume Hierarchies, IEEE Symposium on
 * Interactive Ray Tracing, 2007). Not thread-safe.
 *
 * <p>Each bin knows the box around its bodies and the one around their centres, so one pass over a group gives both boxes of
 * both parts, and no part is read again to find how its centres spread.
 *
 * <p>No constant here is a length, so bodies that are all scaled by a power of two are cut in the same place. Where numbers
 * leave the range of floats, bodies land in the first or last bin and costs become infinite: cuts may be missed, but a cut
 * that is found is valid.
 */
final class Bins {
    private static final int MANY = 32;

    /** For small groups, where clearing and comparing bins costs more than filling them. */
    private static final int FEW = 8;

    private static final int SMALL_GROUP = 64;

    private final float[] bodies;
    private final int[] count = new int[MANY];
    private final float[] box = new float[Bounds.STRIDE * MANY];

    /** Twice the centres, as halving them changes nothing. */
    private final float[] centres = new float[Bounds.STRIDE * MANY];
    private final float[] costAfter = new float[MANY];
    private final float[] side = new float[Bounds.STRIDE];
    private int used;
    private int axis;
    private float first;
    private float binsPerLength;
    private int cut;

    /** Bins for bodies that are given by their boxes, as in {@link Bounds}. */
    Bins(float[] bodies) {
        this.bodies = bodies;
    }

    /**
     * Empties the bins for another group.
     *
     * @param size how many bodies it has
     * @param spread has the box around twice their centres
     * @param at where this box begins
     */
    void begin(int size, float[] spread, int at) {
        used = size > SMALL_GROUP ? MANY : FEW;
        float x = spread[at + 3] - spread[at];
        float y = spread[at + 4] - spread[at + 1];
        float z = spread[at + 5] - spread[at + 2];
        if (x >= y && x >= z) {
            setAxis(0, spread[at], x);
        } else if (y >= z) {
            setAxis(1, spread[at + 1], y);
        } else {
            setAxis(2, spread[at + 2], z);
        }
        Arrays.fill(count, 0, used, 0);
        for (int i = 0; i < used; i++) {
            Bounds.clear(box, Bounds.STRIDE * i);
            Bounds.clear(centres, Bounds.STRIDE * i);
        }
    }

    private void setAxis(int chosen, float low, float length) {
        axis = chosen;
        first = low;
        binsPerLength = used / length;
    }

    /** Adds the bodies at positions from (included) to (not included). */
    void fill(int from, int to) {
        for (int i = from; i < to; i++) {
            int body = Bounds.STRIDE * i;
            int bin = bin(body);
            count[bin]++;
            Bounds.include(box, Bounds.STRIDE * bin, bodies, body);
            includeCentre(centres, Bounds.STRIDE * bin, bodies, body);
        }
    }

    /** Grows a box until it holds twice the centre of another box. */
    static void includeCentre(float[] boxes, int at, float[] others, int other) {
        float x = others[other] + others[other + 3];
        float y = others[other + 1] + others[other + 4];
        float z = others[other + 2] + others[other + 5];
        boxes[at] = Math.min(boxes[at], x);
        boxes[at + 1] = Math.min(boxes[at + 1], y);
        boxes[at + 2] = Math.min(boxes[at + 2], z);
        boxes[at + 3] = Math.max(boxes[at + 3], x);
        boxes[at + 4] = Math.max(boxes[at + 4], y);
        boxes[at + 5] = Math.max(boxes[at + 5], z);
    }

    /** Adds what other bins, begun for the same group, hold of it. */
    void add(Bins others) {
        for (int i = 0; i < used; i++) {
            count[i] += others.count[i];
            Bounds.include(box, Bounds.STRIDE * i, others.box, Bounds.STRIDE * i);
            Bounds.include(centres, Bounds.STRIDE * i, others.centres, Bounds.STRIDE * i);
        }
    }

    private int bin(int body) {
        float twiceCentre = bodies[body + axis] + bodies[body + axis + Bounds.TO_HIGH];
        return Math.min(used - 1, (int) ((twiceCentre - first) * binsPerLength));
    }

    /**
     * Finds the best cut.
     *
     * @return the sum, over both sides, of the number of bodies times half the surface; infinite without a cut
     */
    float findCut() {
        int bodiesAfter = 0;
        Bounds.clear(side, 0);
        for (int i = used - 1; i > 0; i--) {
            bodiesAfter += count[i];
            Bounds.include(side, 0, box, Bounds.STRIDE * i);
            costAfter[i] = bodiesAfter == 0 ? Float.POSITIVE_INFINITY : bodiesAfter * Bounds.halfArea(side, 0);
        }
        return chooseCut();
    }

    private float chooseCut() {
        cut = 0;
        float cost = Float.POSITIVE_INFINITY;
        int bodiesBefore = 0;
        Bounds.clear(side, 0);
        for (int i = 1; i < used; i++) {
            bodiesBefore += count[i - 1];
            Bounds.include(side, 0, box, Bounds.STRIDE * (i - 1));
            float sum = bodiesBefore * Bounds.halfArea(side, 0) + costAfter[i];
            if (bodiesBefore > 0 && sum < cost) {
                cut = i;
                cost = sum;
            }
        }
        return cost;
    }

    /** Whether a body comes before the cut; it is given by the index at which its box begins. */
    boolean isBeforeCut(int body) {
        return bin(body) < cut;
    }

    /** Writes the boxes around the bodies on both sides of the cut, one after the other. */
    void writeSides(float[] boxes, int at) {
        writeSides(box, boxes, at);
    }

    /** Writes the boxes around twice the centres on both sides of the cut, one after the other. */
    void writeSpreads(float[] spreads, int at) {
        writeSides(centres, spreads, at);
    }

    private void writeSides(float[] ofBins, float[] boxes, int at) {
        Bounds.clear(boxes, at);
        Bounds.clear(boxes, at + Bounds.STRIDE);
        for (int i = 0; i < used; i++) {
            Bounds.include(boxes, i < cut ? at : at + Bounds.STRIDE, ofBins, Bounds.STRIDE * i);
        }
    }
}
