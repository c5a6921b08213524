package raytracing.compiled;

/**
 * Builds a hierarchy from the top down: each group of bodies, a range of positions, is cut in two by {@link Bins}. The
 * parts of a large group may go to two threads, which write to different places only.
 */
final class HierarchyBuilder {
    /** No leaf has more bodies, so that coincident ones, too, are spread over leaves. */
    private static final int LARGEST_LEAF = 8;

    /** What it costs a ray to be tested against two boxes, if a test against a body costs 1 (tuned by measurement). */
    private static final double STEP_COST = 3;

    /**
     * Below this depth groups are halved by position. Useful trees of millions of bodies are less deep; bodies that the
     * heuristic can only peel off one by one would otherwise take a time that grows with the square of their number.
     */
    private static final int DEEPEST_CUT = 48;

    /** Halving the largest number of bodies there can be reaches leaves in so many steps. */
    private static final int MOST_HALVINGS = 28;

    /** No leaf lies deeper, the root being at depth 0. */
    static final int GREATEST_DEPTH = DEEPEST_CUT + MOST_HALVINGS;

    /** Handing a group of this size to another thread costs far less than the work in it. */
    private static final int LARGE_GROUP = 1 << 16;

    /** Its node, where it begins and ends, its depth. */
    private static final int NUMBERS_OF_A_GROUP = 4;

    private final double[] bodies;
    private final int[] order;
    private final Workers workers;
    private final Nodes nodes;
    private final Bins bins;
    private final int[] groups = new int[NUMBERS_OF_A_GROUP * (GREATEST_DEPTH + 2)];
    private int waiting;

    private HierarchyBuilder(double[] bodies, int[] order, Workers workers, Nodes nodes) {
        this.bodies = bodies;
        this.order = order;
        this.workers = workers;
        this.nodes = nodes;
        bins = new Bins(bodies);
    }

    /** Builds the tree and brings the bodies and their numbers in its order. */
    static Nodes build(Bounds bounds, int[] order, Workers workers) {
        Nodes nodes = new Nodes(order.length);
        HierarchyBuilder builder = new HierarchyBuilder(bounds.numbers(), order, workers, nodes);
        builder.writeBox(Hierarchy.ROOT, 0, order.length);
        builder.build(Hierarchy.ROOT, 0, order.length, 0);
        nodes.compact();
        return nodes;
    }

    private void writeBox(int node, int from, int to) {
        double[] boxes = nodes.boxes();
        Bounds.clear(boxes, Bounds.STRIDE * node);
        for (int i = from; i < to; i++) {
            Bounds.include(boxes, Bounds.STRIDE * node, bodies, Bounds.STRIDE * i);
        }
    }

    /**
     * Builds the tree under a node. The groups that still have to be built wait in a list; calling this method for them
     * would have the virtual machine compile it three times into itself, which takes longer than the building.
     */
    private void build(int node, int from, int to, int depth) {
        int waitingBefore = waiting;
        add(node, from, to, depth);
        while (waiting > waitingBefore) {
            waiting -= NUMBERS_OF_A_GROUP;
            buildNode(groups[waiting], groups[waiting + 1], groups[waiting + 2], groups[waiting + 3]);
        }
        if (to - from <= LARGE_GROUP) {
            workers.advance(to - from);      // the parts of a larger group have told for themselves
        }
    }

    private void add(int node, int from, int to, int depth) {
        groups[waiting] = node;
        groups[waiting + 1] = from;
        groups[waiting + 2] = to;
        groups[waiting + 3] = depth;
        waiting += NUMBERS_OF_A_GROUP;
    }

    private void buildNode(int node, int from, int to, int depth) {
        if (to - from > STEP_COST && depth < DEEPEST_CUT && isWorthCutting(node, from, to)) {
            int middle = cut(from, to);
            bins.writeSides(nodes.boxes(), Bounds.STRIDE * nodes.setChildren(node, middle));
            addChildren(from, middle, to, depth + 1);
        } else if (to - from > LARGEST_LEAF) {
            int middle = (from + to) >>> 1;
            int first = nodes.setChildren(node, middle);
            writeBox(first, from, middle);
            writeBox(first + 1, middle, to);
            addChildren(from, middle, to, depth + 1);
        } else {
            nodes.setLeaf(node, from, to);
        }
    }

    /** Asked of what a ray that meets the node's box may expect to cost; a large group is cut anyway. */
    private boolean isWorthCutting(int node, int from, int to) {
        bins.sort(from, to);
        int count = to - from;
        double area = Bounds.halfArea(nodes.boxes(), Bounds.STRIDE * node);
        return count > LARGEST_LEAF ? bins.haveCut() : STEP_COST * area + bins.cost() < count * area;
    }

    /** Brings the bodies before the cut to the front; returns where the others begin. */
    private int cut(int from, int to) {
        int front = from;
        int back = to - 1;
        while (front <= back) {
            if (bins.isBeforeCut(Bounds.STRIDE * front)) {
                front++;
            } else if (!bins.isBeforeCut(Bounds.STRIDE * back)) {
                back--;
            } else {
                exchange(front, back);
            }
        }
        return front;
    }

    /** The boxes move as well as the numbers: a group close together in memory is read twice as fast. */
    private void exchange(int i, int j) {
        int body = order[i];
        order[i] = order[j];
        order[j] = body;
        Bounds.exchange(bodies, Bounds.STRIDE * i, Bounds.STRIDE * j);
    }

    private void addChildren(int from, int middle, int to, int depth) {
        if (to - from > LARGE_GROUP) {
            HierarchyBuilder helper = new HierarchyBuilder(bodies, order, workers, nodes);
            workers.doBoth(() -> build(2 * middle, from, middle, depth),
                () -> helper.build(2 * middle + 1, middle, to, depth));
        } else {
            add(2 * middle + 1, middle, to, depth);
            add(2 * middle, from, middle, depth);
        }
    }
}
