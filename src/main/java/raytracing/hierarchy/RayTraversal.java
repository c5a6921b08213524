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
 * <p>Proof that nothing is lost. The origin is rounded ahead for the faces passed first and back for those passed last. As the
 * boxes' numbers are floats, the ways to the faces are differences of floats, off by at most one rounding; the reciprocal is
 * off by one, the product by one: 3 in 2^24, with a unit of the last place for times below the normal numbers. Ways to faces
 * that are passed first do not overflow ({@link Bounds}), and where times do, they are above all others. An exit below 0 has a
 * way below 0, which is right. A NaN comes only from a ray that runs parallel to a face and in its plane, as the origin
 * was rounded away from the box to a number other than its own: the ray is outside, and whatever the bits are, nothing is lost.
 * Along an axis whose reciprocal is no normal float, though the ray moves, all times count as inside.
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

    private static final int MISSED = -1;

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
        double grown = GROWN * originError;
        perX = reciprocal(dx);
        nearX = perX < 0 ? Bounds.TO_HIGH : 0;
        farX = Bounds.TO_HIGH - nearX;
        nearOriginX = perX < 0 ? Bounds.below(ox - grown) : Bounds.above(ox + grown);
        farOriginX = perX < 0 ? Bounds.above(ox + grown) : Bounds.below(ox - grown);
        perY = reciprocal(dy);
        nearY = perY < 0 ? 1 + Bounds.TO_HIGH : 1;
        farY = 2 + Bounds.TO_HIGH - nearY;
        nearOriginY = perY < 0 ? Bounds.below(oy - grown) : Bounds.above(oy + grown);
        farOriginY = perY < 0 ? Bounds.above(oy + grown) : Bounds.below(oy - grown);
        perZ = reciprocal(dz);
        nearZ = perZ < 0 ? 2 + Bounds.TO_HIGH : 2;
        farZ = 4 + Bounds.TO_HIGH - nearZ;
        nearOriginZ = perZ < 0 ? Bounds.below(oz - grown) : Bounds.above(oz + grown);
        farOriginZ = perZ < 0 ? Bounds.above(oz + grown) : Bounds.below(oz - grown);
        if (!(isOrdinary(perX) && isOrdinary(perY) && isOrdinary(perZ))) {
            freeExtraordinary(dx, dy, dz);
        }
        int entry = entry(Hierarchy.ROOT, Float.floatToRawIntBits(Float.POSITIVE_INFINITY));
        entryOfWaiting[0] = entry;
        waitingCount = entry < 0 ? 0 : 1;
    }

    /** Infinite along an axis on which the ray does not go: then it is between the faces at all times or at none. */
    private static float reciprocal(double d) {
        return (float) (1 / d);
    }

    private static boolean isOrdinary(float reciprocal) {
        return Math.abs(reciprocal) >= Float.MIN_NORMAL && Math.abs(reciprocal) <= Float.MAX_VALUE;
    }

    /** Lets a ray be between the faces at all times along axes whose reciprocals say nothing. */
    private void freeExtraordinary(double dx, double dy, double dz) {
        if (dx != 0 && !isOrdinary(perX)) {
            nearX = 0;
            farX = Bounds.TO_HIGH;
            nearOriginX = Float.POSITIVE_INFINITY;
            farOriginX = Float.NEGATIVE_INFINITY;
            perX = 1;
        }
        if (dy != 0 && !isOrdinary(perY)) {
            nearY = 1;
            farY = 1 + Bounds.TO_HIGH;
            nearOriginY = Float.POSITIVE_INFINITY;
            farOriginY = Float.NEGATIVE_INFINITY;
            perY = 1;
        }
        if (dz != 0 && !isOrdinary(perZ)) {
            nearZ = 2;
            farZ = 2 + Bounds.TO_HIGH;
            nearOriginZ = Float.POSITIVE_INFINITY;
            farOriginZ = Float.NEGATIVE_INFINITY;
            perZ = 1;
        }
    }

    /**
     * Goes on to the next leaf whose box the ray may meet at some t from 0 to {@code latest}, both included; returns
     * whether there is one.
     *
     * @param latest at least 0; may have become earlier since the last call
     */
    public boolean nextLeaf(double latest) {
        int end = Float.floatToRawIntBits((float) latest);
        while (waitingCount > 0) {
            waitingCount--;
            if (entryOfWaiting[waitingCount] <= end + SLACK && reachesLeaf(waiting[waitingCount], end)) {
                return true;
            }
        }
        return false;
    }

    /** Goes down from a node, each time to the nearer child, while the other one waits. */
    private boolean reachesLeaf(int start, int end) {
        int count = waitingCount;
        int node = start;
        int link = links[node];
        while (link >= 0) {
            int child = node + link;
            int entry = entry(child, end);
            int otherEntry = entry(child + 1, end);
            if ((entry & otherEntry) < 0) {              // both are missed
                waitingCount = count;
                return false;
            }
            if ((entry | otherEntry) < 0) {              // one is
                node = entry < 0 ? child + 1 : child;
            } else {
                int isOtherFirst = otherEntry < entry ? 1 : 0;
                node = child + isOtherFirst;
                waiting[count] = child + 1 - isOtherFirst;
                entryOfWaiting[count] = Math.max(entry, otherEntry);
                count++;
            }
            link = links[node];
        }
        waitingCount = count;
        setLeaf(link);
        return true;
    }

    /**
     * The bits of the time at which the ray comes into a node's box, 0 if it starts inside; {@link #MISSED} if it certainly
     * does not before the end, whose bits are given.
     */
    private int entry(int node, int end) {
        int at = Bounds.STRIDE * node;
        int entryX = Float.floatToRawIntBits((boxes[at + nearX] - nearOriginX) * perX);
        int entryY = Float.floatToRawIntBits((boxes[at + nearY] - nearOriginY) * perY);
        int entryZ = Float.floatToRawIntBits((boxes[at + nearZ] - nearOriginZ) * perZ);
        int exitX = Float.floatToRawIntBits((boxes[at + farX] - farOriginX) * perX);
        int exitY = Float.floatToRawIntBits((boxes[at + farY] - farOriginY) * perY);
        int exitZ = Float.floatToRawIntBits((boxes[at + farZ] - farOriginZ) * perZ);
        int entry = Math.max(Math.max(entryX, entryY), Math.max(entryZ, 0));
        int exit = Math.min(Math.min(exitX, exitY), Math.min(exitZ, end));
        return entry > exit + SLACK ? MISSED : entry;
    }
}
