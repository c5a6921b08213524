package raytracing.hierarchy;

import raytracing.parallel.ForkJoin;

/**
 * Builds a hierarchy from the top down: each group of bodies, a range of positions, is cut in two by {@link Bins}. The
 * parts of a large group may go to two threads, which write to different places only.
 */
final class HierarchyBuilder {
    /** No leaf has more bodies; coincident ones, which no cut separates, are spread over several leaves. */
    private static final int LARGEST_LEAF = 8;

    /** The cost of testing a ray against two boxes, if a test against a body costs 1 (tuned by measurement). */
    private static final double STEP_COST = 3;

    /**
     * Below this depth groups are halved by position. Useful trees of millions of bodies are less deep; bodies that the
     * heuristic can only peel off one by one would otherwise take a time that grows with the square of their number.
     */
    private static final int DEEPEST_CUT = 48;

    /** Halving the largest possible number of bodies reaches leaves in so many steps. */
    private static final int MOST_HALVINGS = 28;

    /** No leaf lies deeper, the root being at depth 0. */
    static final int GREATEST_DEPTH = DEEPEST_CUT + MOST_HALVINGS;

    /** Handing a group of this size to another thread costs far less than the work in it. */
    private static final int LARGE_GROUP = 1 << 16;

    /** Node, first position, position after the last, and depth. */
    private static final int NUMBERS_OF_A_GROUP = 4;

    private final double[] bodies;
    private final Hierarchy hierarchy;
    private final ForkJoin workers;
    private final Bins bins;
    private final int[] groups = new int[NUMBERS_OF_A_GROUP * (GREATEST_DEPTH + 2)];
    private int waiting;

    private HierarchyBuilder(double[] bodies, Hierarchy hierarchy, ForkJoin workers) {
        this.bodies = bodies;
        this.hierarchy = hierarchy;
        this.workers = workers;
        bins = new Bins(bodies);
    }

    /** Builds the tree; puts the bodies and their numbers in its order. */
    static void build(Bounds bounds, Hierarchy hierarchy, ForkJoin workers) {
        HierarchyBuilder builder = new HierarchyBuilder(bounds.numbers(), hierarchy, workers);
        builder.writeBox(Hierarchy.ROOT, 0, bounds.size());
        builder.build(Hierarchy.ROOT, 0, bounds.size(), 0);
    }

    private void writeBox(int node, int from, int to) {
        double[] boxes = hierarchy.boxes();
        Bounds.clear(boxes, Bounds.STRIDE * node);
        for (int i = from; i < to; i++) {
            Bounds.include(boxes, Bounds.STRIDE * node, bodies, Bounds.STRIDE * i);
        }
    }

    /**
     * Builds the tree under a node. The groups that still have to be built wait in a list: if this method called itself for
     * them, the virtual machine would inline it three times into itself, and compiling that takes longer than building.
     */
    private void build(int node, int from, int to, int depth) {
        int waitingBefore = waiting;
        add(node, from, to, depth);
        while (waiting > waitingBefore) {
            waiting -= NUMBERS_OF_A_GROUP;
            buildNode(groups[waiting], groups[waiting + 1], groups[waiting + 2], groups[waiting + 3]);
        }
        if (to - from <= LARGE_GROUP) {
            workers.advance(to - from);      // the parts of a larger group were counted one by one
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
            bins.writeSides(hierarchy.boxes(), Bounds.STRIDE * hierarchy.setChildren(node, middle));
            addChildren(from, middle, to, depth + 1);
        } else if (to - from > LARGEST_LEAF) {
            int middle = (from + to) >>> 1;
            int first = hierarchy.setChildren(node, middle);
            writeBox(first, from, middle);
            writeBox(first + 1, middle, to);
            addChildren(from, middle, to, depth + 1);
        } else {
            hierarchy.setLeaf(node, from, to);
        }
    }

    /** Compares the expected costs of a ray that meets the node's box, with a cut and without; cuts a large group anyway. */
    private boolean isWorthCutting(int node, int from, int to) {
        double cost = bins.findCut(from, to);
        int count = to - from;
        double area = Bounds.halfArea(hierarchy.boxes(), Bounds.STRIDE * node);
        return count > LARGEST_LEAF ? cost < Double.POSITIVE_INFINITY : STEP_COST * area + cost < count * area;
    }

    /**
     * Moves the bodies before the cut to the front; returns the first position of the others. The boxes move as well as the
     * numbers: a group close together in memory is read twice as fast.
     */
    private int cut(int from, int to) {
        int[] order = hierarchy.order();
        int front = from;
        int back = to - 1;
        while (front <= back) {
            if (bins.isBeforeCut(Bounds.STRIDE * front)) {
                front++;
            } else if (!bins.isBeforeCut(Bounds.STRIDE * back)) {
                back--;
            } else {
                int body = order[front];
                order[front] = order[back];
                order[back] = body;
                Bounds.exchange(bodies, Bounds.STRIDE * front, Bounds.STRIDE * back);
            }
        }
        return front;
    }

    private void addChildren(int from, int middle, int to, int depth) {
        if (to - from > LARGE_GROUP) {
            HierarchyBuilder helper = new HierarchyBuilder(bodies, hierarchy, workers);
            workers.runBoth(() -> build(2 * middle, from, middle, depth),
                () -> helper.build(2 * middle + 1, middle, to, depth));
        } else {
            add(2 * middle + 1, middle, to, depth);
            add(2 * middle, from, middle, depth);
        }
    }
}
