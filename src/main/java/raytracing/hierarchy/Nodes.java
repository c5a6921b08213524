package raytracing.hierarchy;

import java.util.Arrays;

/**
 * The nodes of a tree, or of a part of one that is built alone. Siblings stand next to each other, so one number leads to
 * both, and their boxes share lines of the processor's cache; the children of the first of two siblings follow close
 * behind. The root, number 0, has no sibling, so number 1 is unused.
 *
 * <p>The link of a node with children, above 0, is how much further on the first of them is, and so a part that is copied into
 * a larger tree needs no other links. That of a leaf, below 0, is ~ (8 times its first position + the number of its bodies
 * - 1): a leaf has 1 to 8 bodies.
 */
final class Nodes {
    /** No leaf has more bodies. */
    static final int LARGEST_LEAF = 8;

    /** What the position of a leaf, times 8, leaves of an int. */
    static final int MOST_BODIES = 1 << 28;

    private static final int LOG_OF_LARGEST_LEAF = 3;

    private float[] boxes;
    private int[] links;
    private int count = 2;

    /** Room for so many nodes at first, at least 2. */
    Nodes(int room) {
        boxes = new float[Bounds.STRIDE * room];
        links = new int[room];
    }

    /** Two more nodes; returns the number of the first. */
    int addPair() {
        if (count + 2 > links.length) {
            int room = links.length + links.length / 2 + 2;
            links = Arrays.copyOf(links, room);
            boxes = Arrays.copyOf(boxes, Bounds.STRIDE * room);
        }
        count += 2;
        return count - 2;
    }

    void setLeaf(int node, int from, int to) {
        links[node] = ~(from << LOG_OF_LARGEST_LEAF | to - from - 1);
    }

    void setChildren(int node, int first) {
        links[node] = first - node;
    }

    /** Makes a node, whose box stands already, the root of a part, and copies what is below into new nodes. */
    void copyBelow(int node, Nodes part) {
        int start = count - 2;               // where the part's nodes 0 and 1 would come
        int below = part.count - 2;
        int rootLink = part.links[0];
        links[node] = rootLink < 0 ? rootLink : rootLink + start - node;
        System.arraycopy(part.links, 2, links, count, below);
        System.arraycopy(part.boxes, 2 * Bounds.STRIDE, boxes, Bounds.STRIDE * count, Bounds.STRIDE * below);
        count += below;
    }

    /** How many there are, the unused one included. */
    int count() {
        return count;
    }

    /** The boxes around the nodes, as in {@link Bounds}; there may be more room. */
    float[] boxes() {
        return boxes;
    }

    int[] links() {
        return links;
    }

    /** The first position of the leaf with a link. */
    static int from(int link) {
        return ~link >> LOG_OF_LARGEST_LEAF;
    }

    /** The position after the last of the leaf with a link. */
    static int to(int link) {
        return from(link) + (~link & LARGEST_LEAF - 1) + 1;
    }
}
