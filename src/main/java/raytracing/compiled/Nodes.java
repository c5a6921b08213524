package raytracing.compiled;

import java.util.Arrays;

/**
 * The nodes of a hierarchy, flat. Siblings stand next to each other, so one number leads to both, and their boxes share
 * lines of the processor's cache. Node 0 is the root; node 1 is none, as the root has no sibling.
 *
 * <p>While the tree is built, the children of a group that is cut before position k are nodes 2k and 2k + 1: no two
 * groups are cut at the same place, so threads build their parts without asking each other. {@link #compact} closes
 * the gaps.
 */
final class Nodes {
    private double[] boxes;
    private int[] links;
    private byte[] sizes;

    /**
     * Makes room for the nodes of a tree.
     *
     * @param bodies how many bodies it is over
     */
    Nodes(int bodies) {
        links = new int[Math.multiplyExact(2, bodies)];
        boxes = new double[Math.multiplyExact(Bounds.STRIDE, links.length)];
        sizes = new byte[links.length];
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

    /** Numbers the nodes anew in the same order, without gaps, and gives back the room. */
    void compact() {
        int[] compacted = new int[links.length / 2];
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

    int count() {
        return links.length;
    }

    /** The boxes around the nodes, as {@link Bounds} has them. */
    double[] boxes() {
        return boxes;
    }

    /** Of a node with children, the number of the first; of a leaf, ~ the first of its positions. */
    int[] links() {
        return links;
    }

    /** Of a leaf, the number of its bodies. */
    byte[] sizes() {
        return sizes;
    }
}
