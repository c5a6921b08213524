package raytracing.hierarchy;

/**
 * Boxes along the axes in one array: each is six numbers in a row, its low x, y and z and then its high ones. Floats, rounded
 * outwards: a box is never smaller than what it was set to, and half as many bytes have to be moved as with doubles. What is
 * beyond the range of floats gets an infinite box, and what is below it a box of the smallest size: such a box holds its body
 * too, and is only met more often than it need be. Scenes come here with ordinary lengths.
 */
public final class Bounds {
    /** How many numbers make a box. */
    static final int STRIDE = 6;

    /** From the index of a low number to that of the high one of the same axis. */
    static final int TO_HIGH = 3;

    /** Low numbers go no further up than this, high ones no further down: the way to a face met first does not overflow. */
    static final float FAR = 0x1p126f;

    private final float[] numbers;

    /** Room for so many boxes. */
    public Bounds(int size) {
        numbers = new float[Math.multiplyExact(STRIDE, size)];
    }

    public int size() {
        return numbers.length / STRIDE;
    }

    /** Sets box i to one around a ball or a cube, given its centre and half its width. */
    public void setAround(int i, double x, double y, double z, double half) {
        int at = STRIDE * i;
        numbers[at] = below(x - half);
        numbers[at + 1] = below(y - half);
        numbers[at + 2] = below(z - half);
        numbers[at + 3] = above(x + half);
        numbers[at + 4] = above(y + half);
        numbers[at + 5] = above(z + half);
    }

    /** Sets box i to one around three points. */
    public void setAround(int i, double ax, double ay, double az, double bx, double by, double bz,
                          double cx, double cy, double cz) {
        int at = STRIDE * i;
        numbers[at] = below(Math.min(ax, Math.min(bx, cx)));
        numbers[at + 1] = below(Math.min(ay, Math.min(by, cy)));
        numbers[at + 2] = below(Math.min(az, Math.min(bz, cz)));
        numbers[at + 3] = above(Math.max(ax, Math.max(bx, cx)));
        numbers[at + 4] = above(Math.max(ay, Math.max(by, cy)));
        numbers[at + 5] = above(Math.max(az, Math.max(bz, cz)));
    }

    /**
     * A float below a sum of two numbers that was rounded to a double. The one next to the nearest float is at least half a
     * step of floats below, far more than the sum's rounding.
     */
    private static float below(double sum) {
        return Math.min(Math.nextDown((float) sum), FAR);
    }

    /** A float above a sum of two numbers that was rounded to a double. */
    private static float above(double sum) {
        return Math.max(Math.nextUp((float) sum), -FAR);
    }

    /** The numbers themselves, box after box. */
    float[] numbers() {
        return numbers;
    }

    /** Makes a box empty, so that the first one that it is to {@link #include} replaces it. */
    static void clear(float[] boxes, int at) {
        boxes[at] = Float.POSITIVE_INFINITY;
        boxes[at + 1] = Float.POSITIVE_INFINITY;
        boxes[at + 2] = Float.POSITIVE_INFINITY;
        boxes[at + 3] = Float.NEGATIVE_INFINITY;
        boxes[at + 4] = Float.NEGATIVE_INFINITY;
        boxes[at + 5] = Float.NEGATIVE_INFINITY;
    }

    /** Grows a box until it holds another. Minima have no branches, which would be hard to predict here. */
    static void include(float[] boxes, int at, float[] others, int other) {
        boxes[at] = Math.min(boxes[at], others[other]);
        boxes[at + 1] = Math.min(boxes[at + 1], others[other + 1]);
        boxes[at + 2] = Math.min(boxes[at + 2], others[other + 2]);
        boxes[at + 3] = Math.max(boxes[at + 3], others[other + 3]);
        boxes[at + 4] = Math.max(boxes[at + 4], others[other + 4]);
        boxes[at + 5] = Math.max(boxes[at + 5], others[other + 5]);
    }

    /** Half the surface of a box; at the ends of the range of floats it may be 0, infinite or NaN. */
    static float halfArea(float[] boxes, int at) {
        float x = boxes[at + 3] - boxes[at];
        float y = boxes[at + 4] - boxes[at + 1];
        float z = boxes[at + 5] - boxes[at + 2];
        return x * y + y * z + z * x;
    }

    /** Exchanges two boxes of the same array. */
    static void exchange(float[] boxes, int at, int other) {
        for (int k = 0; k < STRIDE; k++) {
            float number = boxes[at + k];
            boxes[at + k] = boxes[other + k];
            boxes[other + k] = number;
        }
    }
}
