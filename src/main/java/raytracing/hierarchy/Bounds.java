package raytracing.hierarchy;

/**
 * Boxes along the axes in one array: each is six numbers in a row, its low x, y and z and then its high ones. Doubles, as
 * the range of floats is too narrow for scenes of any scale.
 */
public final class Bounds {
    /** How many numbers make a box. */
    static final int STRIDE = 6;

    /** From the index of a low number to that of the high one of the same axis. */
    static final int TO_HIGH = 3;

    private final double[] numbers;

    /** Room for so many boxes. */
    public Bounds(int size) {
        numbers = new double[Math.multiplyExact(STRIDE, size)];
    }

    public int size() {
        return numbers.length / STRIDE;
    }

    /** Sets box i to the one around a ball or a cube, given its centre and half its width; rounded outwards. */
    public void setAround(int i, double x, double y, double z, double half) {
        set(i, Math.nextDown(x - half), Math.nextDown(y - half), Math.nextDown(z - half),
            Math.nextUp(x + half), Math.nextUp(y + half), Math.nextUp(z + half));
    }

    void set(int i, double lowX, double lowY, double lowZ, double highX, double highY, double highZ) {
        int at = STRIDE * i;
        numbers[at] = lowX;
        numbers[at + 1] = lowY;
        numbers[at + 2] = lowZ;
        numbers[at + 3] = highX;
        numbers[at + 4] = highY;
        numbers[at + 5] = highZ;
    }

    /** The numbers themselves, box after box. */
    double[] numbers() {
        return numbers;
    }

    /** Makes a box empty, so that the first one that it is to {@link #include} replaces it. */
    static void clear(double[] boxes, int at) {
        boxes[at] = Double.POSITIVE_INFINITY;
        boxes[at + 1] = Double.POSITIVE_INFINITY;
        boxes[at + 2] = Double.POSITIVE_INFINITY;
        boxes[at + 3] = Double.NEGATIVE_INFINITY;
        boxes[at + 4] = Double.NEGATIVE_INFINITY;
        boxes[at + 5] = Double.NEGATIVE_INFINITY;
    }

    /** Grows a box until it holds another. Minima have no branches, which would be hard to predict here. */
    static void include(double[] boxes, int at, double[] others, int other) {
        boxes[at] = Math.min(boxes[at], others[other]);
        boxes[at + 1] = Math.min(boxes[at + 1], others[other + 1]);
        boxes[at + 2] = Math.min(boxes[at + 2], others[other + 2]);
        boxes[at + 3] = Math.max(boxes[at + 3], others[other + 3]);
        boxes[at + 4] = Math.max(boxes[at + 4], others[other + 4]);
        boxes[at + 5] = Math.max(boxes[at + 5], others[other + 5]);
    }

    /** Half the surface of a box; at the ends of the range of doubles it may be 0, infinite or NaN. */
    static double halfArea(double[] boxes, int at) {
        double x = boxes[at + 3] - boxes[at];
        double y = boxes[at + 4] - boxes[at + 1];
        double z = boxes[at + 5] - boxes[at + 2];
        return x * y + y * z + z * x;
    }

    /** Exchanges two boxes of the same array. */
    static void exchange(double[] boxes, int at, int other) {
        for (int k = 0; k < STRIDE; k++) {
            double number = boxes[at + k];
            boxes[at + k] = boxes[other + k];
            boxes[other + k] = number;
        }
    }
}
