package raytracing.compiled;

/**
 * Boxes around bodies, boxes around these, and so on up to one around all (Rubin, Whitted, A 3-Dimensional
 * Representation for Fast Rendering of Complex Scenes, SIGGRAPH 1980): who misses a box misses all that is in it. It
 * knows nothing of the bodies but the boxes around them. Immutable; {@link HierarchyWalk} and {@link PyramidWalk} find
 * the bodies in it.
 */
final class Hierarchy {
    /** No leaf is further than this from the root. */
    static final int GREATEST_DEPTH = HierarchyBuilder.GREATEST_DEPTH;

    /** The node around all bodies. */
    static final int ROOT = 0;

    private final int[] order;
    private final Nodes nodes;

    private Hierarchy(int[] order, Nodes nodes) {
        this.order = order;
        this.nodes = nodes;
    }

    /**
     * Builds a hierarchy. The same boxes give the same one, with any workers and at any scale: boxes that are all
     * multiplied by a power of two change nothing but the boxes.
     *
     * @param bounds a box around each body, at least one; they are brought in the order of the hierarchy
     * @param workers who builds it
     * @return the hierarchy
     */
    static Hierarchy over(Bounds bounds, Workers workers) {
        int[] order = new int[bounds.size()];
        for (int i = 0; i < order.length; i++) {
            order[i] = i;
        }
        return new Hierarchy(order, HierarchyBuilder.build(bounds, order, workers));
    }

    /** The body at each position. Every leaf is a range of positions: arrays in this order have its bodies in a row. */
    int[] order() {
        return order;
    }

    Nodes nodes() {
        return nodes;
    }
}
