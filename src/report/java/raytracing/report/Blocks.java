package raytracing.report;

import java.util.ArrayList;
import java.util.List;
import raytracing.render.Region;

/** The parts of a picture that are compared with its reference: all of it, or squares spread evenly over it. */
final class Blocks {
    /** Edge of a square: that of the close-ups. */
    static final int EDGE = Closeup.EDGE;

    /** So few of them say little about a picture, which is small then: it is compared as a whole. */
    private static final int LEAST = 16;

    /** Neighbouring rows of squares begin so many squares apart: no two of the compared ones touch. */
    private static final int SHIFT = 3;

    private Blocks() {
    }

    /**
     * The parts of a square picture, all of the same size.
     *
     * @param size width and height of the picture in pixels
     * @param onePer one of so many squares; 1 for the whole picture
     */
    static List<Region> of(int size, int onePer) {
        int count = size / EDGE;
        if (onePer == 1 || count * count < LEAST * onePer) {
            return List.of(Region.whole(size, size));
        }
        int margin = (size - count * EDGE) / 2;
        List<Region> blocks = new ArrayList<>();
        for (int y = 0; y < count; y++) {
            for (int x = 0; x < count; x++) {
                if ((x + SHIFT * y) % onePer == onePer / 2) {
                    int left = margin + x * EDGE;
                    int top = margin + y * EDGE;
                    blocks.add(new Region(left, top, left + EDGE, top + EDGE));
                }
            }
        }
        return blocks;
    }
}
