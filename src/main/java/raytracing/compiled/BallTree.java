package raytracing.compiled;

/** Balls that are found by the points in them, through the same hierarchy as the surfaces of a scene. Immutable. */
public final class BallTree {
    /** Numbers of a ball: its middle, x, y and z, and its radius. */
    public static final int STRIDE = 4;

    /** Which of them is the radius. */
    public static final int RADIUS = 3;

    private final Hierarchy hierarchy;

    /**
     * Sorts balls.
     *
     * @param balls {@link #STRIDE} numbers for each, world axes, none of them NaN; at least one ball
     */
    public BallTree(double[] balls) {
        Bounds bounds = new Bounds(balls.length / STRIDE);
        for (int i = 0; i < bounds.size(); i++) {
            int at = STRIDE * i;
            bounds.setAround(i, balls[at], balls[at + 1], balls[at + 2], balls[at + RADIUS]);
        }
        hierarchy = Hierarchy.over(bounds, Workers.ALONE);
    }

    /**
     * The ball at each position of the tree: arrays in this order have the balls of every leaf in a row.
     *
     * @return numbers of balls, counted from 0
     */
    public int[] order() {
        return hierarchy.order().clone();
    }

    Nodes nodes() {
        return hierarchy.nodes();
    }
}
