package raytracing.compiled;

/** Finds the leaves of a tree of balls that may hold a point. One thread, point after point, without garbage. */
public final class BallWalk {
    private final int[] waiting = new int[Hierarchy.GREATEST_DEPTH + 2];
    private int waitingCount;
    private double[] boxes;
    private int[] links;
    private byte[] sizes;
    private double x;
    private double y;
    private double z;
    private int from;
    private int to;

    /** A walk that has not started. */
    public BallWalk() {
    }

    /**
     * Begins to look for the balls around a point.
     *
     * @param tree of the balls
     * @param pointX x part, world axes
     * @param pointY y part
     * @param pointZ z part
     */
    public void start(BallTree tree, double pointX, double pointY, double pointZ) {
        boxes = tree.nodes().boxes();
        links = tree.nodes().links();
        sizes = tree.nodes().sizes();
        x = pointX;
        y = pointY;
        z = pointZ;
        waiting[0] = Hierarchy.ROOT;
        waitingCount = 1;
    }

    /**
     * Goes on to the next leaf.
     *
     * @return whether there is another one whose balls may hold the point
     */
    public boolean nextLeaf() {
        while (waitingCount > 0) {
            int node = waiting[--waitingCount];
            if (holdsPoint(node)) {
                int link = links[node];
                if (link < 0) {
                    from = ~link;
                    to = from + sizes[node];
                    return true;
                }
                waiting[waitingCount++] = link + 1;
                waiting[waitingCount++] = link;
            }
        }
        return false;
    }

    private boolean holdsPoint(int node) {
        int at = Bounds.STRIDE * node;
        return x >= boxes[at] && x <= boxes[at + 3] && y >= boxes[at + 1] && y <= boxes[at + 4]
            && z >= boxes[at + 2] && z <= boxes[at + 5];
    }

    /**
     * The leaf.
     *
     * @return position of its first ball
     */
    public int from() {
        return from;
    }

    /**
     * The leaf.
     *
     * @return position after its last ball
     */
    public int to() {
        return to;
    }
}
