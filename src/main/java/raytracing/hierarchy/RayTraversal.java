package raytracing.hierarchy;

/**
 * Finds the leaves of a hierarchy that a ray may meet, nearer ones first.
 *
 * <p>A ray is inside a box while it is between the planes of all faces (Kay, Kajiya, Ray Tracing Complex Scenes, SIGGRAPH
 * 1986). A box must never miss a ray that its bodies meet, though times are floats here: entries are made too early and exits
 * too late, and what remains is covered by comparing with some slack (as Ize, Robust BVH Ray Traversal, Journal of Computer
 * Graphics Techniques 2(2), 2013, does with two units in the last place).
 *
 * <p>Times are compared by their bits, read as whole numbers: of floats that are not negative, the larger has the larger bits,
 * and negative ones have negative bits. The greatest of three times and 0 is right then, and the least of some is negative if
 * one of them is. The processor has a greatest of whole numbers; that of floats takes five instructions, as Java wants it for
 * zeros and NaN.
 *
 * <p>Proof that nothing is lost. The origin is moved ahead for the faces passed first and back for those passed last. As the
 * boxes' numbers are floats, the ways to the faces are differences of floats, off by at most one rounding; the reciprocal is
 * off by one, the product by one: 3 in 2^24, with a unit of the last place for times below the normal numbers. Ways to faces
 * that are passed first do not overflow ({@link Bounds}), and where times do, they are above all others. An exit below 0 has a
 * way below 0, which is right. A NaN comes only from a ray that runs parallel to a face and, once moved, in its
 * plane: the ray itself is outside then, and whatever the bits are, nothing is lost. Along an axis whose reciprocal is no normal
 * float, though the ray moves, all times count as inside.
 */
public final class RayTraversal extends Traversal {
    /**
     * In units in the last place, of which each is at least 2^-24 of a time: 6 for an entry and an exit, 2 for the roundings of
     * the latest time and of a direction. The rest is reserve.
     */
    private static final int SLACK = 16;

    /**
     * A ray from a point that is off by its error to either side of a surface counts as starting on it, and then the crossing
     * on the far side is computed, up to four errors away for a body smaller than the error itself. Twice that, as reserve.
     */
    private static final double GROWN = 8;

    /** Twice what an origin is off by that is rounded to a float, moved, and rounded again: 2^-24 of its size each time. */
    private static final float ROUNDING = 0x1p-22f;

    /** In place of the number of a node. */
    private static final int NOTHING = Integer.MAX_VALUE;

    private final int[] entryOfWaiting = new int[waiting.length];

    /** Which number of a box is the face that the ray passes first along an axis, and which the one that it passes last. */
    private int nearX;
    private int nearY;
    private int nearZ;
    private int farX;
    private int farY;
    private int farZ;

    /** The origin, moved ahead for near faces and back for far ones, which is as if the boxes had grown. */
    private float nearOriginX;
    private float nearOriginY;
    private float nearOriginZ;
    private float farOriginX;
    private float farOriginY;
    private float farOriginZ;

    private float perX;
    private float perY;
    private float perZ;

    /**
     * Starts a query for the ray o + t d, t above 0. The ray of a segment p + t (q - p) may have been rounded.
     *
     * @param originError how far each coordinate of the origin may be off; of a segment, of either end
     * @param dx not 0 if dy and dz are
     */
    public void startRay(Hierarchy hierarchy, double ox, double oy, double oz, double originError,
                         double dx, double dy, double dz) {
        start(hierarchy);
        float grown = (float) (GROWN * originError) + Float.MIN_NORMAL;
        perX = (float) (1 / dx);
        perY = (float) (1 / dy);
        perZ = (float) (1 / dz);
        nearX = firstFace(0, perX);
        nearY = firstFace(1, perY);
        nearZ = firstFace(2, perZ);
        farX = Bounds.TO_HIGH - nearX;
        farY = 2 + Bounds.TO_HIGH - nearY;
        farZ = 4 + Bounds.TO_HIGH - nearZ;
        float x = (float) ox;
        float y = (float) oy;
        float z = (float) oz;
        float moveX = move(x, grown, perX);
        float moveY = move(y, grown, perY);
        float moveZ = move(z, grown, perZ);
        nearOriginX = x + moveX;
        nearOriginY = y + moveY;
        nearOriginZ = z + moveZ;
        farOriginX = x - moveX;
        farOriginY = y - moveY;
        farOriginZ = z - moveZ;
        if (!(isOrdinary(x, perX) && isOrdinary(y, perY) && isOrdinary(z, perZ))) {
            freeExtraordinary(x, y, z, dx, dy, dz);
        }
        waiting[0] = below(Hierarchy.ROOT);
        entryOfWaiting[0] = 0;
    }

    /** The face of a box that is passed first along an axis; the reciprocal of 0 is infinite, with the sign of the 0. */
    private static int firstFace(int axis, float per) {
        return per < 0 ? axis + Bounds.TO_HIGH : axis;
    }

    /** How far the origin moves along the ray's direction: further than it has grown and was rounded, in these sums too. */
    private static float move(float origin, float grown, float per) {
        float move = Math.abs(origin) * ROUNDING + grown * (1 + ROUNDING);
        return per < 0 ? -move : move;
    }

    /** Whether ways from the origin do not overflow, and the reciprocal is a normal number, with all its digits. */
    private static boolean isOrdinary(float origin, float per) {
        return Math.abs(origin) <= Bounds.FAR && Math.abs(per) >= Float.MIN_NORMAL && Math.abs(per) <= Float.MAX_VALUE;
    }

    /**
     * Lets a ray be between the faces at all times along axes on which nothing else is certain. Along an axis on which it does
     * not go, an infinite reciprocal says that it is between the faces at all times or at none.
     */
    private void freeExtraordinary(float x, float y, float z, double dx, double dy, double dz) {
        if (!isOrdinary(x, dx == 0 ? 1 : perX)) {
            nearX = 0;
            farX = Bounds.TO_HIGH;
            nearOriginX = Float.POSITIVE_INFINITY;
            farOriginX = Float.NEGATIVE_INFINITY;
            perX = 1;
        }
        if (!isOrdinary(y, dy == 0 ? 1 : perY)) {
            nearY = 1;
            farY = 1 + Bounds.TO_HIGH;
            nearOriginY = Float.POSITIVE_INFINITY;
            farOriginY = Float.NEGATIVE_INFINITY;
            perY = 1;
        }
        if (!isOrdinary(z, dz == 0 ? 1 : perZ)) {
            nearZ = 2;
            farZ = 2 + Bounds.TO_HIGH;
            nearOriginZ = Float.POSITIVE_INFINITY;
            farOriginZ = Float.NEGATIVE_INFINITY;
            perZ = 1;
        }
    }

    /**
     * Goes on to the next leaf whose box the ray may meet at some t from 0 to {@code latest}, both included; returns
     * whether there is one. Of two siblings it goes down from the one that is entered first, while what is below the other one
     * waits. Entry times are given by their bits; a box whose entry is after its exit or after the end is missed. The only
     * leaf of a hierarchy is found by every ray.
     *
     * <p>Both siblings are tested side by side, and all in one piece: the virtual machine does not compile a method of more than
     * 325 bytes into its callers again (DECISIONS).
     *
     * @param latest at least 0; may have become earlier since the last call
     */
    public boolean nextLeaf(double latest) {
        int end = Float.floatToRawIntBits((float) latest);
        int count = waitingCount;
        while (count > 0) {
            count--;
            int next = entryOfWaiting[count] <= end + SLACK ? waiting[count] : NOTHING;
            while (next >= 0 && next != NOTHING) {
                int at = Bounds.STRIDE * next;
                int entryX = Float.floatToRawIntBits((boxes[at + nearX] - nearOriginX) * perX);
                int entryY = Float.floatToRawIntBits((boxes[at + nearY] - nearOriginY) * perY);
                int entryZ = Float.floatToRawIntBits((boxes[at + nearZ] - nearOriginZ) * perZ);
                int exitX = Float.floatToRawIntBits((boxes[at + farX] - farOriginX) * perX);
                int exitY = Float.floatToRawIntBits((boxes[at + farY] - farOriginY) * perY);
                int exitZ = Float.floatToRawIntBits((boxes[at + farZ] - farOriginZ) * perZ);
                int entry = Math.max(Math.max(entryX, entryY), Math.max(entryZ, 0));
                int exit = Math.min(Math.min(exitX, exitY), Math.min(exitZ, end));
                int other = at + Bounds.STRIDE;
                int otherX = Float.floatToRawIntBits((boxes[other + nearX] - nearOriginX) * perX);
                int otherY = Float.floatToRawIntBits((boxes[other + nearY] - nearOriginY) * perY);
                int otherZ = Float.floatToRawIntBits((boxes[other + nearZ] - nearOriginZ) * perZ);
                int otherExitX = Float.floatToRawIntBits((boxes[other + farX] - farOriginX) * perX);
                int otherExitY = Float.floatToRawIntBits((boxes[other + farY] - farOriginY) * perY);
                int otherExitZ = Float.floatToRawIntBits((boxes[other + farZ] - farOriginZ) * perZ);
                int otherEntry = Math.max(Math.max(otherX, otherY), Math.max(otherZ, 0));
                int otherExit = Math.min(Math.min(otherExitX, otherExitY), Math.min(otherExitZ, end));
                boolean isMet = entry <= exit + SLACK;
                boolean isOtherMet = otherEntry <= otherExit + SLACK;
                if (isMet && isOtherMet) {
                    int isOtherFirst = otherEntry < entry ? 1 : 0;
                    waiting[count] = below(next + 1 - isOtherFirst);
                    entryOfWaiting[count] = Math.max(entry, otherEntry);
                    count++;
                    next = below(next + isOtherFirst);
                } else {
                    next = isMet ? below(next) : isOtherMet ? below(next + 1) : NOTHING;
                }
            }
            if (next < 0) {
                waitingCount = count;
                setLeaf(next);
                return true;
            }
        }
        waitingCount = 0;
        return false;
    }

    /** What comes below a node: the number of its first child, or below 0 the link of a leaf. */
    private int below(int node) {
        int link = links[node];
        return link < 0 ? link : node + link;
    }
}
