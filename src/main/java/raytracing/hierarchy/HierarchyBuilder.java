package raytracing.hierarchy;

import raytracing.parallel.ForkJoin;

/**
 * Builds a hierarchy from the top down: each group of bodies, a range of positions, is cut in two by {@link Bins}. Two threads
 * fill the bins of a large group, and each of its parts may go to a thread of its own; threads write to different places only.
 * So the trees below large groups are parts, which are joined in the end in the order in which one thread would have built
 * them.
 */
final class HierarchyBuilder {
    /** The cost of testing a ray against two boxes, if a test against a body costs 1 (tuned by measurement). */
    private static final float STEP_COST = 3;

    /**
     * Below this depth groups are halved by position. Useful trees of millions of bodies are less deep; bodies that the
     * heuristic can only peel off one by one would otherwise take a time that grows with the square of their number.
     */
    private static final int DEEPEST_CUT = 48;

    /** Halving the largest possible number of bodies reaches leaves in so many steps. */
    private static final int MOST_HALVINGS = 28;

    /** No leaf lies deeper, the root being at depth 0. */
    static final int GREATEST_DEPTH = DEEPEST_CUT + MOST_HALVINGS;

    /** Groups that may go to several threads are larger. */
    private static final int LARGE_GROUP = ForkJoin.LARGE_RANGE;

    /** Node, first position, position after the last, and depth. */
    private static final int NUMBERS_OF_A_GROUP = 4;

    private final float[] bodies;
    private final int[] order;
    private final ForkJoin workers;
    private final Bins bins;
    private final int[] groups = new int[NUMBERS_OF_A_GROUP * (GREATEST_DEPTH + 2)];

    /** For each group that waits, the box around twice the centres of its bodies; the two last ones while they are found. */
    private final float[] spreads = new float[Bounds.STRIDE * (GREATEST_DEPTH + 3)];
    private int waiting;

    private HierarchyBuilder(float[] bodies, int[] order, ForkJoin workers) {
        this.bodies = bodies;
        this.order = order;
        this.workers = workers;
        bins = new Bins(bodies);
    }

    /** A tree below a node: all of it, or of a large group two nodes and the trees below them. */
    private static final class Part {
        private Nodes nodes = new Nodes(2);
        private Part[] below = {};

        /** How many nodes it has but its root and the unused one. */
        int size() {
            int size = nodes.count() - 2;
            for (Part part : below) {
                size += part.size();
            }
            return size;
        }

        /** Writes all of it below a node of a tree that has its box. */
        void write(Nodes tree, int node) {
            int first = tree.count();
            tree.copyBelow(node, nodes);
            for (int i = 0; i < below.length; i++) {
                below[i].write(tree, first + i);
            }
        }
    }

    /** Builds the tree over bodies, and puts them and their numbers in its order. */
    static Nodes build(Bounds bounds, int[] order, ForkJoin workers) {
        Part part = new Part();
        HierarchyBuilder builder = new HierarchyBuilder(bounds.numbers(), order, workers);
        builder.writeRoot(part.nodes.boxes(), bounds.size());
        builder.build(part, 0, bounds.size(), 0);
        if (part.below.length == 0) {
            return part.nodes;
        }
        Nodes tree = new Nodes(part.size() + 2);
        System.arraycopy(part.nodes.boxes(), 0, tree.boxes(), 0, Bounds.STRIDE);
        part.write(tree, 0);
        return tree;
    }

    /** Writes the box around all bodies, and the spread of their centres; two threads may look at half of them each. */
    private void writeRoot(float[] boxes, int size) {
        if (size <= LARGE_GROUP) {
            writeBoxes(boxes, 0, spreads, 0, 0, size);
            return;
        }
        int middle = size >>> 1;
        float[] others = new float[Bounds.STRIDE];
        float[] otherSpreads = new float[Bounds.STRIDE];
        workers.runBoth(() -> writeBoxes(boxes, 0, spreads, 0, 0, middle),
            () -> writeBoxes(others, 0, otherSpreads, 0, middle, size));
        Bounds.include(boxes, 0, others, 0);
        Bounds.include(spreads, 0, otherSpreads, 0);
    }

    /** Writes the boxes around the bodies at some positions, and around twice their centres. */
    private void writeBoxes(float[] boxes, int at, float[] centres, int atCentres, int from, int to) {
        Bounds.clear(boxes, at);
        Bounds.clear(centres, atCentres);
        for (int i = from; i < to; i++) {
            Bounds.include(boxes, at, bodies, Bounds.STRIDE * i);
            Bins.includeCentre(centres, atCentres, bodies, Bounds.STRIDE * i);
        }
    }

    /** Builds the tree below the root of a part, whose box stands there, and the spread of its bodies in this builder. */
    private void build(Part part, int from, int to, int depth) {
        if (to - from > LARGE_GROUP) {
            buildLarge(part, from, to, depth);
        } else {
            buildSmall(part, from, to, depth);
            workers.advance(to - from);
        }
    }

    private void buildLarge(Part part, int from, int to, int depth) {
        int first = part.nodes.addPair();
        int half = (from + to) >>> 1;
        HierarchyBuilder helper = new HierarchyBuilder(bodies, order, workers);
        helper.bins.begin(to - from, spreads, 0);
        bins.begin(to - from, spreads, 0);
        workers.runBoth(() -> bins.fill(from, half), () -> helper.bins.fill(half, to));
        bins.add(helper.bins);
        boolean isCut = depth < DEEPEST_CUT && bins.findCut() < Float.POSITIVE_INFINITY;
        int middle = isCut ? cut(from, to) : half;
        if (isCut) {
            bins.writeSides(part.nodes.boxes(), Bounds.STRIDE * first);
            bins.writeSpreads(spreads, 0);
        } else {
            writeHalves(part.nodes.boxes(), first, 0, from, to);
        }
        part.nodes.setChildren(0, first);
        System.arraycopy(spreads, Bounds.STRIDE, helper.spreads, 0, Bounds.STRIDE);
        part.below = new Part[] {part(part.nodes, first), part(part.nodes, first + 1)};
        workers.runBoth(() -> build(part.below[0], from, middle, depth + 1),
            () -> helper.build(part.below[1], middle, to, depth + 1));
    }

    /** A part for the tree below a node. */
    private static Part part(Nodes nodes, int node) {
        Part part = new Part();
        System.arraycopy(nodes.boxes(), Bounds.STRIDE * node, part.nodes.boxes(), 0, Bounds.STRIDE);
        return part;
    }

    /**
     * The groups that still have to be built wait in a list: if this method called itself for them, the virtual machine would
     * inline it three times into itself, and compiling that takes longer than building.
     */
    private void buildSmall(Part part, int from, int to, int depth) {
        Nodes nodes = new Nodes(to - from + 2);
        System.arraycopy(part.nodes.boxes(), 0, nodes.boxes(), 0, Bounds.STRIDE);
        part.nodes = nodes;
        add(0, from, to, depth);
        while (waiting > 0) {
            waiting--;
            int at = NUMBERS_OF_A_GROUP * waiting;
            buildNode(nodes, groups[at], groups[at + 1], groups[at + 2], groups[at + 3]);
        }
    }

    private void add(int node, int from, int to, int depth) {
        int at = NUMBERS_OF_A_GROUP * waiting;
        groups[at] = node;
        groups[at + 1] = from;
        groups[at + 2] = to;
        groups[at + 3] = depth;
        waiting++;
    }

    private void buildNode(Nodes nodes, int node, int from, int to, int depth) {
        int spread = Bounds.STRIDE * waiting;
        if (to - from > STEP_COST && depth < DEEPEST_CUT && isWorthCutting(nodes, node, from, to, spread)) {
            int middle = cut(from, to);
            int first = nodes.addPair();
            bins.writeSides(nodes.boxes(), Bounds.STRIDE * first);
            bins.writeSpreads(spreads, spread);
            addChildren(nodes, node, first, from, middle, to, depth + 1);
        } else if (to - from > Nodes.LARGEST_LEAF) {
            int first = nodes.addPair();
            writeHalves(nodes.boxes(), first, spread, from, to);
            addChildren(nodes, node, first, from, (from + to) >>> 1, to, depth + 1);
        } else {
            nodes.setLeaf(node, from, to);
        }
    }

    private void writeHalves(float[] boxes, int first, int spread, int from, int to) {
        int middle = (from + to) >>> 1;
        writeBoxes(boxes, Bounds.STRIDE * first, spreads, spread, from, middle);
        writeBoxes(boxes, Bounds.STRIDE * (first + 1), spreads, spread + Bounds.STRIDE, middle, to);
    }

    /** Lets both children wait, the first one in front; their spreads stand in order and change places. */
    private void addChildren(Nodes nodes, int node, int first, int from, int middle, int to, int depth) {
        nodes.setChildren(node, first);
        Bounds.exchange(spreads, Bounds.STRIDE * waiting, Bounds.STRIDE * (waiting + 1));
        add(first + 1, middle, to, depth);
        add(first, from, middle, depth);
    }

    /** Compares the expected costs of a ray that meets the node's box, with a cut and without; cuts a large group anyway. */
    private boolean isWorthCutting(Nodes nodes, int node, int from, int to, int spread) {
        int count = to - from;
        bins.begin(count, spreads, spread);
        bins.fill(from, to);
        float cost = bins.findCut();
        float area = Bounds.halfArea(nodes.boxes(), Bounds.STRIDE * node);
        return count > Nodes.LARGEST_LEAF ? cost < Float.POSITIVE_INFINITY : STEP_COST * area + cost < count * area;
    }

    /**
     * Moves the bodies before the cut to the front; returns the first position of the others. The boxes move as well as the
     * numbers: a group close together in memory is read twice as fast.
     */
    private int cut(int from, int to) {
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
}
