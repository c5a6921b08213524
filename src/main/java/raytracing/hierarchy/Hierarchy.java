package raytracing.hierarchy;

import java.util.Arrays;
import raytracing.parallel.ForkJoin;

/**
 * Boxes around bodies, boxes around these, and so on up to one around all (Rubin, Whitted, A 3-Dimensional
 * Representation for Fast Rendering of Complex Scenes, SIGGRAPH 1980): a ray that misses a box misses all that is in it.
 * It knows nothing of the bodies but the boxes around them. {@link RayTraversal}, {@link PyramidTraversal} and
 * {@link PointTraversal} find the bodies in it. It does not change once it is built.
 *
 * <p>How the nodes are kept is told by {@link Nodes}.
 */
public final class Hierarchy {
    /** The node around all bodies. */
    static final int ROOT = 0;

    private final int[] order;
    private final float[] boxes;
    private final int[] links;

    private Hierarchy(int[] order, Nodes nodes) {
        this.order = order;
        links = nodes.count() == nodes.links().length ? nodes.links() : Arrays.copyOf(nodes.links(), nodes.count());
        int numbers = Bounds.STRIDE * nodes.count();
        boxes = numbers == nodes.boxes().length ? nodes.boxes() : Arrays.copyOf(nodes.boxes(), numbers);
    }

    /**
     * Builds a hierarchy over bodies, given a box around each, at least one; they are put in its order. The same boxes give
     * the same one, with any workers; and in the range of floats at any scale: boxes that are all multiplied by a power of two
     * change nothing else.
     */
    public static Hierarchy over(Bounds bounds, ForkJoin workers) {
        if (bounds.size() > Nodes.MOST_BODIES) {
            throw new IllegalArgumentException("more than " + Nodes.MOST_BODIES + " bodies: " + bounds.size());
        }
        int[] order = new int[bounds.size()];
        for (int i = 0; i < order.length; i++) {
            order[i] = i;
        }
        return new Hierarchy(order, HierarchyBuilder.build(bounds, order, workers));
    }

    /** The body at each position. Every leaf is a range of positions, so arrays in this order have its bodies in a row. */
    public int[] order() {
        return order;
    }

    /** The boxes around the nodes, as in {@link Bounds}. */
    float[] boxes() {
        return boxes;
    }

    /** The links of the nodes, as in {@link Nodes}. */
    int[] links() {
        return links;
    }
}
