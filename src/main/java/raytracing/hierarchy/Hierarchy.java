package raytracing.hierarchy;

import java.util.Arrays;
import raytracing.parallel.ForkJoin;

/**
 * Boxes around bodies, boxes around these, and so on up to one around all (Rubin, Whitted, A 3-Dimensional
 * Representation for Fast Rendering of Complex Scenes, SIGGRAPH 1980): a ray that misses a box misses all that is in it.
 * It knows nothing of the bodies but the boxes around them. {@link RayTraversal}, {@link PyramidTraversal} and
 * {@link PointTraversal} find the bodies in it. It does not change once it is built.
 *
 * <p>The nodes are in arrays. Siblings stand next to each other, so one number leads to both, and their boxes share lines of
 * the processor's cache. Node 1 is unused, as the root has no sibling. While the tree is built, the children of a group that
 * is cut before position k are nodes 2k and 2k + 1: no two groups are cut at the same place, so threads build their parts
 * without locks. {@link #compact} closes the gaps.
 */
public final class Hierarchy {
    /** The node around all bodies. */
    static final int ROOT = 0;

    private final int[] order;
    private double[] boxes;
    private int[] links;
    private byte[] sizes;

    private Hierarchy(int bodies) {
        order = new int[bodies];
        for (int i = 0; i < bodies; i++) {
            order[i] = i;
        }
        links = new int[Math.multiplyExact(2, bodies)];
        boxes = new double[Math.multiplyExact(Bounds.STRIDE, links.length)];
        sizes = new byte[links.length];
    }

    /**
     * Builds a hierarchy over bodies, given a box around each, at least one; they are put in its order. The same boxes give
     * the same one, with any workers and at any scale: boxes that are all multiplied by a power of two change nothing else.
     */
    public static Hierarchy over(Bounds bounds, ForkJoin workers) {
        Hierarchy hierarchy = new Hierarchy(bounds.size());
        HierarchyBuilder.build(bounds, hierarchy, workers);
        hierarchy.compact();
        return hierarchy;
    }

    void setLeaf(int node, int from, int to) {
        links[node] = ~from;
        sizes[node] = (byte) (to - from);
    }

    /** Notes where a group is cut and returns the first of its children. */
    int setChildren(int node, int middle) {
        links[node] = 2 * middle;
        return links[node];
    }

    /** Numbers the nodes anew in the same order, without gaps, and frees the memory of the gaps. */
    private void compact() {
        int[] compacted = new int[order.length];
        int count = 0;
        for (int pair = 0; pair < compacted.length; pair++) {
            compacted[pair] = count;
            count += isUsed(pair) ? 2 : 0;
        }
        for (int pair = 0; pair < compacted.length; pair++) {
            if (isUsed(pair)) {
                move(2 * pair, compacted[pair], compacted);
                move(2 * pair + 1, compacted[pair] + 1, compacted);
            }
        }
        links = Arrays.copyOf(links, count);
        boxes = Arrays.copyOf(boxes, Bounds.STRIDE * count);
        sizes = Arrays.copyOf(sizes, count);
    }

    private boolean isUsed(int pair) {
        return links[2 * pair] != 0;
    }

    private void move(int node, int target, int[] compacted) {
        int link = links[node];
        links[target] = link < 0 ? link : compacted[link / 2];
        sizes[target] = sizes[node];
        System.arraycopy(boxes, Bounds.STRIDE * node, boxes, Bounds.STRIDE * target, Bounds.STRIDE);
    }

    /** The body at each position. Every leaf is a range of positions, so arrays in this order have its bodies in a row. */
    public int[] order() {
        return order;
    }

    /** The boxes around the nodes, as in {@link Bounds}. */
    double[] boxes() {
        return boxes;
    }

    /** For a node with children, the number of the first; for a leaf, ~ its first position. */
    int[] links() {
        return links;
    }

    /** For a leaf, the number of its bodies. */
    byte[] sizes() {
        return sizes;
    }
}
