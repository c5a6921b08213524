package raytracing.compiled;

/**
 * Finds the leaves of a hierarchy that a ray may meet, nearer ones first. It belongs to one thread, serves query after
 * query and makes no garbage.
 *
 * <p>A ray is inside a box while it is between the planes of all faces (Kay, Kajiya, Ray Tracing Complex Scenes,
 * SIGGRAPH 1986). What a body answers must never be lost by a box, so boxes are a little too large: rounding makes the
 * times at which a ray passes two planes wrong by a few parts in 2^53, and the later one is lengthened by more than
 * that (Ize, Robust BVH Ray Traversal, Journal of Computer Graphics Techniques 2(2), 2013, there by two units in the
 * last place).
 */
final class HierarchyWalk {
    /**
     * Proved: entry and exit are off by 3 parts in 2^53, for the difference, the reciprocal and the product, and by one
     * more if the direction was rounded. The crossings that {@code latest} comes from are off by at most 16 ulp, or
     * 2^-48. The rest is reserve.
     */
    private static final double LENGTHENED = 1 + 0x1p-45;

    /** Times below this have fewer digits than others, and each may be wrong by as much as its last one. */
    private static final double SMALLEST_TIME = Double.MIN_NORMAL;

    /**
     * A point that is off by its error to either side of a surface lies on it, and is then asked for the crossing on
     * the far side, up to four errors away for a body smaller than the error itself. Twice that, as reserve.
     */
    private static final double GROWN = 8;

    private static final double MISSED = -1;

    private final int[] waiting = new int[Hierarchy.GREATEST_DEPTH];
    private final double[] entryOfWaiting = new double[Hierarchy.GREATEST_DEPTH];
    private int waitingCount;

    private double[] boxes;
    private int[] links;
    private byte[] sizes;

    /** Where the number of a box's near face stands, and that of the far one. */
    private int nearX;
    private int nearY;
    private int nearZ;
    private int farX;
    private int farY;
    private int farZ;

    /** The origin, moved ahead for near faces and back for far ones, which is as if the boxes had grown. */
    private double nearOriginX;
    private double nearOriginY;
    private double nearOriginZ;
    private double farOriginX;
    private double farOriginY;
    private double farOriginZ;

    private double perX;
    private double perY;
    private double perZ;

    private int from;
    private int to;

    /**
     * Begins to follow the ray o + t d, t above 0. The ray of a segment p + t (q - p) may have been rounded.
     *
     * @param hierarchy over the bodies in question
     * @param ox origin, x part
     * @param oy y part
     * @param oz z part
     * @param originError how far each part of the origin may be off; of a segment, of either end
     * @param dx direction, x part; not all three 0
     * @param dy y part
     * @param dz z part
     */
    void startRay(Hierarchy hierarchy, double ox, double oy, double oz, double originError,
                  double dx, double dy, double dz) {
        boxes = hierarchy.nodes().boxes();
        links = hierarchy.nodes().links();
        sizes = hierarchy.nodes().sizes();
        double grown = GROWN * originError;
        startX(ox, grown, reciprocal(dx));
        startY(oy, grown, reciprocal(dy));
        startZ(oz, grown, reciprocal(dz));
        waitingCount = 0;
        double entry = entry(Hierarchy.ROOT, Double.POSITIVE_INFINITY);
        if (!(entry < 0)) {
            waiting[0] = Hierarchy.ROOT;
            entryOfWaiting[0] = entry;
            waitingCount = 1;
        }
    }

    /**
     * Infinite along an axis on which the ray does not go: then it is between the faces at all times or at none.
     * Infinite because the ray is slow, it becomes NaN, which compares with nothing and so misses nothing.
     */
    private static double reciprocal(double d) {
        double reciprocal = 1 / d;
        return d == 0 || Math.abs(reciprocal) <= Double.MAX_VALUE ? reciprocal : Double.NaN;
    }

    private void startX(double o, double grown, double per) {
        boolean isBackwards = per < 0;
        perX = per;
        nearX = isBackwards ? Bounds.TO_HIGH : 0;
        farX = isBackwards ? 0 : Bounds.TO_HIGH;
        nearOriginX = isBackwards ? below(o, grown) : above(o, grown);
        farOriginX = isBackwards ? above(o, grown) : below(o, grown);
    }

    private void startY(double o, double grown, double per) {
        boolean isBackwards = per < 0;
        perY = per;
        nearY = isBackwards ? 1 + Bounds.TO_HIGH : 1;
        farY = isBackwards ? 1 : 1 + Bounds.TO_HIGH;
        nearOriginY = isBackwards ? below(o, grown) : above(o, grown);
        farOriginY = isBackwards ? above(o, grown) : below(o, grown);
    }

    private void startZ(double o, double grown, double per) {
        boolean isBackwards = per < 0;
        perZ = per;
        nearZ = isBackwards ? 2 + Bounds.TO_HIGH : 2;
        farZ = isBackwards ? 2 : 2 + Bounds.TO_HIGH;
        nearOriginZ = isBackwards ? below(o, grown) : above(o, grown);
        farOriginZ = isBackwards ? above(o, grown) : below(o, grown);
    }

    /**
     * The next number after the sum, and not the sum: a ray along a plane in which many boxes end would meet 0 times
     * infinity, which says nothing, at all of them.
     */
    private static double above(double o, double grown) {
        return Math.nextUp(o + grown);
    }

    private static double below(double o, double grown) {
        return Math.nextDown(o - grown);
    }

    /**
     * Goes on to the next leaf.
     *
     * @param latest the last time that matters; it may have become earlier since the last call
     * @return whether there is another leaf whose box the ray may meet at some t from 0 to {@code latest}, both
     *         included
     */
    boolean nextLeaf(double latest) {
        double end = latest * LENGTHENED;
        while (waitingCount > 0) {
            waitingCount--;
            if (!(entryOfWaiting[waitingCount] > end) && reachesLeaf(waiting[waitingCount], end)) {
                return true;
            }
        }
        return false;
    }

    /** Goes down from a node, each time to the nearer child, while the other one waits. */
    private boolean reachesLeaf(int start, double end) {
        int count = waitingCount;
        int node = start;
        int link = links[node];
        while (link >= 0) {
            double entry = entry(link, end);
            double otherEntry = entry(link + 1, end);
            if (entry < 0 && otherEntry < 0) {
                waitingCount = count;
                return false;
            }
            boolean isOtherFirst = entry < 0 || otherEntry >= 0 && otherEntry < entry;
            node = isOtherFirst ? link + 1 : link;
            if (!(entry < 0 || otherEntry < 0)) {
                waiting[count] = isOtherFirst ? link : link + 1;
                entryOfWaiting[count] = isOtherFirst ? entry : otherEntry;
                count++;
            }
            link = links[node];
        }
        waitingCount = count;
        from = ~link;
        to = from + sizes[node];
        return true;
    }

    /**
     * When the ray comes into a node's box, 0 if it starts inside, NaN if that cannot be said; {@link #MISSED} if it
     * certainly does not before the end. Every comparison is such that NaN misses nothing.
     */
    private double entry(int node, double end) {
        int at = Bounds.STRIDE * node;
        double entryX = (boxes[at + nearX] - nearOriginX) * perX;
        double entryY = (boxes[at + nearY] - nearOriginY) * perY;
        double entryZ = (boxes[at + nearZ] - nearOriginZ) * perZ;
        double exitX = (boxes[at + farX] - farOriginX) * perX;
        double exitY = (boxes[at + farY] - farOriginY) * perY;
        double exitZ = (boxes[at + farZ] - farOriginZ) * perZ;
        double entry = Math.max(Math.max(entryX, entryY), Math.max(entryZ, 0));
        double exit = Math.min(Math.min(exitX, exitY), Math.min(exitZ, end));
        return entry > exit * LENGTHENED + SMALLEST_TIME ? MISSED : entry;
    }

    /** The first position of the leaf. */
    int from() {
        return from;
    }

    /** The position after the leaf's last. */
    int to() {
        return to;
    }
}
