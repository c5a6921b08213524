package raytracing.hierarchy;

/**
 * Finds the leaves of a hierarchy that a ray may meet, nearer ones first.
 *
 * <p>A ray is inside a box while it is between the planes of all faces (Kay, Kajiya, Ray Tracing Complex Scenes, SIGGRAPH
 * 1986). A box must never miss a ray that its bodies meet, so boxes are a little too large: rounding makes the times at which
 * a ray passes two planes wrong by a few parts in 2^53, and the later one is lengthened by more than that (Ize, Robust BVH Ray
 * Traversal, Journal of Computer Graphics Techniques 2(2), 2013, there by two units in the last place).
 */
public final class RayTraversal extends Traversal {
    /**
     * Proved: entry and exit are off by 3 parts in 2^53, for the difference, the reciprocal and the product, and by one
     * more if the direction was rounded. The crossings that {@code latest} comes from are off by at most 16 ulp, or
     * 2^-48. The rest is reserve.
     */
    private static final double LENGTHENED = 1 + 0x1p-45;

    /** Times below this have fewer digits than others, and each may be wrong by as much as its last one. */
    private static final double SMALLEST_TIME = Double.MIN_NORMAL;

    /**
     * A ray from a point that is off by its error to either side of a surface counts as starting on it, and then the crossing
     * on the far side is computed, up to four errors away for a body smaller than the error itself. Twice that, as reserve.
     */
    private static final double GROWN = 8;

    private static final double MISSED = -1;

    private final double[] entryOfWaiting = new double[waiting.length];

    /** Which number of a box is the face that the ray passes first along an axis, and which the one that it passes last. */
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

    /**
     * Starts a query for the ray o + t d, t above 0. The ray of a segment p + t (q - p) may have been rounded.
     *
     * @param originError how far each coordinate of the origin may be off; of a segment, of either end
     * @param dx not 0 if dy and dz are
     */
    public void startRay(Hierarchy hierarchy, double ox, double oy, double oz, double originError,
                         double dx, double dy, double dz) {
        start(hierarchy);
        perX = reciprocal(dx);
        perY = reciprocal(dy);
        perZ = reciprocal(dz);
        double signX = perX < 0 ? -1 : 1;
        double signY = perY < 0 ? -1 : 1;
        double signZ = perZ < 0 ? -1 : 1;
        nearX = firstFace(0, signX);
        nearY = firstFace(1, signY);
        nearZ = firstFace(2, signZ);
        farX = firstFace(0, -signX);
        farY = firstFace(1, -signY);
        farZ = firstFace(2, -signZ);
        double grown = GROWN * originError;
        nearOriginX = ahead(ox, grown, signX);
        nearOriginY = ahead(oy, grown, signY);
        nearOriginZ = ahead(oz, grown, signZ);
        farOriginX = ahead(ox, grown, -signX);
        farOriginY = ahead(oy, grown, -signY);
        farOriginZ = ahead(oz, grown, -signZ);
        double entry = entry(Hierarchy.ROOT, Double.POSITIVE_INFINITY);
        entryOfWaiting[0] = entry;
        waitingCount = entry < 0 ? 0 : 1;
    }

    /**
     * Infinite along an axis on which the ray does not go: then it is between the faces at all times or at none.
     * Infinite because the ray is slow, it becomes NaN, which compares with nothing and so misses nothing.
     */
    private static double reciprocal(double d) {
        double reciprocal = 1 / d;
        return d == 0 || Math.abs(reciprocal) <= Double.MAX_VALUE ? reciprocal : Double.NaN;
    }

    /** The face of a box that is passed first by a ray whose direction has a sign, 1 or -1, along an axis. */
    private static int firstFace(int axis, double sign) {
        return sign < 0 ? axis + Bounds.TO_HIGH : axis;
    }

    /**
     * A coordinate moved along the sign. The next number after the sum, and not the sum: a ray along a plane in which many
     * boxes end would otherwise have 0 times infinity, which is NaN and so misses nothing, at all of them.
     */
    private static double ahead(double o, double grown, double sign) {
        return sign * Math.nextUp(sign * o + grown);
    }

    /**
     * Goes on to the next leaf whose box the ray may meet at some t from 0 to {@code latest}, both included; returns
     * whether there is one.
     *
     * @param latest may have become earlier since the last call
     */
    public boolean nextLeaf(double latest) {
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
        setLeaf(node, link);
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
}
