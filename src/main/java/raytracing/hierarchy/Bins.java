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
 * <p>No constant here is a length, so bodies that are all scaled by a power of two are cut in the same place. Where numbers
 * leave the range of doubles, bodies land in the first or last bin and costs become infinite: cuts may be missed, but a cut
 * that is found is valid.
 */
final class Bins {
    private static final int MANY = 32;

    /** For small groups, where clearing and comparing bins costs more than filling them. */
    private static final int FEW = 8;

    private static final int SMALL_GROUP = 64;

    private final double[] bodies;
    private final int[] count = new int[MANY];
    private final double[] box = new double[Bounds.STRIDE * MANY];
    private final double[] costAfter = new double[MANY];
    private final double[] side = new double[Bounds.STRIDE];
    private int used;
    private int axis;
    private double first;
    private double binsPerLength;
    private int cut;

    /** Bins for bodies that are given by their boxes, as in {@link Bounds}. */
    Bins(double[] bodies) {
        this.bodies = bodies;
    }

    /**
     * Finds the best cut of the bodies at positions from (included) to (not included).
     *
     * @return the sum, over both sides, of the number of bodies times half the surface; infinite without a cut
     */
    double findCut(int from, int to) {
        used = to - from > SMALL_GROUP ? MANY : FEW;
        chooseAxis(from, to);
        fill(from, to);
        sumUpCostsAfterCuts();
        return chooseCut();
    }

    private void chooseAxis(int from, int to) {
        double lowX = Double.POSITIVE_INFINITY;
        double lowY = Double.POSITIVE_INFINITY;
        double lowZ = Double.POSITIVE_INFINITY;
        double highX = Double.NEGATIVE_INFINITY;
        double highY = Double.NEGATIVE_INFINITY;
        double highZ = Double.NEGATIVE_INFINITY;
        for (int i = from; i < to; i++) {
            int body = Bounds.STRIDE * i;
            double x = twiceCentre(body);
            double y = twiceCentre(body + 1);
            double z = twiceCentre(body + 2);
            lowX = Math.min(lowX, x);
            lowY = Math.min(lowY, y);
            lowZ = Math.min(lowZ, z);
            highX = Math.max(highX, x);
            highY = Math.max(highY, y);
            highZ = Math.max(highZ, z);
        }
        double spreadX = highX - lowX;
        double spreadY = highY - lowY;
        double spreadZ = highZ - lowZ;
        if (spreadX >= spreadY && spreadX >= spreadZ) {
            setAxis(0, lowX, spreadX);
        } else if (spreadY >= spreadZ) {
            setAxis(1, lowY, spreadY);
        } else {
            setAxis(2, lowZ, spreadZ);
        }
    }

    private double twiceCentre(int at) {
        return bodies[at] + bodies[at + Bounds.TO_HIGH];
    }

    private void setAxis(int chosen, double low, double spread) {
        axis = chosen;
        first = low;
        binsPerLength = used / spread;
    }

    private void fill(int from, int to) {
        Arrays.fill(count, 0, used, 0);
        for (int i = 0; i < used; i++) {
            Bounds.clear(box, Bounds.STRIDE * i);
        }
        for (int i = from; i < to; i++) {
            int body = Bounds.STRIDE * i;
            int bin = bin(body);
            count[bin]++;
            Bounds.include(box, Bounds.STRIDE * bin, bodies, body);
        }
    }

    private int bin(int body) {
        return Math.min(used - 1, (int) ((twiceCentre(body + axis) - first) * binsPerLength));
    }

    private void sumUpCostsAfterCuts() {
        int bodiesAfter = 0;
        Bounds.clear(side, 0);
        for (int i = used - 1; i > 0; i--) {
            bodiesAfter += count[i];
            Bounds.include(side, 0, box, Bounds.STRIDE * i);
            costAfter[i] = bodiesAfter == 0 ? Double.POSITIVE_INFINITY : bodiesAfter * Bounds.halfArea(side, 0);
        }
    }

    private double chooseCut() {
        cut = 0;
        double cost = Double.POSITIVE_INFINITY;
        int bodiesBefore = 0;
        Bounds.clear(side, 0);
        for (int i = 1; i < used; i++) {
            bodiesBefore += count[i - 1];
            Bounds.include(side, 0, box, Bounds.STRIDE * (i - 1));
            double sum = bodiesBefore * Bounds.halfArea(side, 0) + costAfter[i];
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

    /** Writes the boxes around both sides of the cut, one after the other. */
    void writeSides(double[] boxes, int at) {
        Bounds.clear(boxes, at);
        Bounds.clear(boxes, at + Bounds.STRIDE);
        for (int i = 0; i < used; i++) {
            Bounds.include(boxes, i < cut ? at : at + Bounds.STRIDE, box, Bounds.STRIDE * i);
        }
    }
}
