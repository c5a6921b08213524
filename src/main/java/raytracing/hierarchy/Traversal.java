package raytracing.hierarchy;

/**
 * What the traversals of a hierarchy share: its nodes, the nodes that still wait for their turn, and the leaf found last.
 * Serves one query after the other and does not allocate. Not thread-safe.
 */
abstract class Traversal {
    /** Nodes to be visited, the next one last; at most one for each step down, and one more. */
    final int[] waiting = new int[HierarchyBuilder.GREATEST_DEPTH + 1];
    int waitingCount;

    float[] boxes;
    int[] links;
    private int from;
    private int to;

    /** Starts a query with the root waiting. */
    final void start(Hierarchy hierarchy) {
        boxes = hierarchy.boxes();
        links = hierarchy.links();
        waiting[0] = Hierarchy.ROOT;
        waitingCount = 1;
    }

    /** Makes a leaf, given by its link, the one found last. */
    final void setLeaf(int link) {
        from = Nodes.from(link);
        to = Nodes.to(link);
    }

    /** The leaf's first position in the hierarchy's order. */
    public final int from() {
        return from;
    }

    /** The position after the leaf's last. */
    public final int to() {
        return to;
    }
}
