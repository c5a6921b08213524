package raytracing.area;

import java.util.Arrays;

/**
 * The shadows of several balls on a plane, as {@link BallShadow} has them, and how much light they take from a polygon.
 *
 * <p>Where shadows overlap, no boundary of the fourth degree has to be found. A point e is in the shadow of ball i if
 * f_i(e) = m_i . e / sqrt(k_i) is at least |e|: all shadows compare a linear function with the same length. So where
 * f_i is the greatest, whatever is in any shadow is in that of ball i. This cuts the polygon into convex cells, a power
 * diagram of cones with one apex, in each of which the shadows are nested: what ball i takes there is closed-form, and
 * behind it only the others remain.
 *
 * <p>One thread, question after question.
 */
public final class BallShadows {
    /** More balls than this are first shared out between the halves of the polygon, if that parts them (measured). */
    private static final int MOST_AT_ONCE = 4;

    /** Of the number of balls when they are shared out, as some go to both halves. */
    private static final double MOST_GROWTH = 1.5;

    /** Smaller parts of a polygon are not halved: of its area. */
    private static final double LEAST_PART = 0x1p-16;

    private final ConvexPolygons polygons;
    private double depth;
    private BallShadow[] balls = {};

    /** Those that {@link #add} fills, made once; among the balls there may be others for a while. */
    private BallShadow[] own = {};
    private int count;

    /** Sets of balls, one above the other: each is a row of members. */
    private BallShadow[] members = new BallShadow[32];
    private int memberCount;
    private double leastArea;

    /**
     * No balls.
     *
     * @param polygons the stack on which polygons are cut; left as it was found
     */
    BallShadows(ConvexPolygons polygons) {
        this.polygons = polygons;
    }

    /** Forgets all balls; {@code planeDepth} is the distance from the apex (0, 0, 0) to the plane, above 0. */
    void clear(double planeDepth) {
        depth = planeDepth;
        count = 0;
    }

    /**
     * Adds a ball.
     *
     * @param x its centre, seen from the apex
     * @param y y part
     * @param z z part
     * @param radius of the ball; the apex is outside or as good as on it
     * @param transmittance share of light that the ball lets through, in [0, 1]
     */
    public void add(double x, double y, double z, double radius, double transmittance) {
        if (own.length <= count) {
            own = Arrays.copyOf(own, 2 * count + 4);
        }
        if (own[count] == null) {
            own[count] = new BallShadow();
        }
        own[count].set(x, y, z, radius, transmittance, depth);
        push(own[count]);
    }

    /** Adds a ball for a while. */
    void push(BallShadow ball) {
        if (count == balls.length) {
            balls = Arrays.copyOf(balls, 2 * count + 4);
        }
        balls[count++] = ball;
    }

    /** Drops the ball that was added last. */
    void pop() {
        count--;
    }

    /** Whether no ball's shadow overlaps that of another ball. */
    boolean areApartFrom(BallShadow other) {
        for (int i = 0; i < count; i++) {
            if (!balls[i].isApartFrom(other)) {
                return false;
            }
        }
        return true;
    }

    /**
     * The light that the balls take from a polygon that shines evenly with 1 for each unit of area.
     *
     * @param polygon which one
     * @return integral over the polygon of 1 minus the product of the transmittances of the balls that shadow a point
     */
    double takenLight(int polygon) {
        if (count == 0) {
            return 0;
        }
        memberCount = 0;
        leastArea = LEAST_PART * polygons.area(polygon);
        for (int i = 0; i < count; i++) {
            addMember(balls[i]);
        }
        return takenLight(polygon, 0);
    }

    private void addMember(BallShadow ball) {
        if (memberCount == members.length) {
            members = Arrays.copyOf(members, 2 * memberCount);
        }
        members[memberCount++] = ball;
    }

    /** By the set of balls on top, from a place on. */
    private double takenLight(int polygon, int from) {
        if (memberCount == from + 1) {
            return takenByOne(polygon, members[from]);
        }
        return keepThoseThatTouch(polygon, from) ? takenByAll(polygon, from) : polygons.area(polygon);
    }

    private double takenByOne(int polygon, BallShadow ball) {
        return (1 - ball.transmittance()) * ball.area(polygons, polygon);
    }

    /** Drops balls whose shadows are beside the polygon; false if one ball takes all its light. */
    private boolean keepThoseThatTouch(int polygon, int from) {
        int to = from;
        for (int i = from; i < memberCount; i++) {
            BallShadow ball = members[i];
            Side side = ball.side(polygons, polygon);
            if (side == Side.WITHIN && ball.transmittance() == 0) {
                return false;
            }
            if (side != Side.BEYOND) {
                members[to++] = ball;
            }
        }
        memberCount = to;
        return true;
    }

    /** By balls that all touch the polygon. */
    private double takenByAll(int polygon, int from) {
        if (memberCount - from > MOST_AT_ONCE && polygons.area(polygon) > leastArea) {
            return takenFromHalves(polygon, from);
        }
        return takenInCells(polygon, from);
    }

    private double takenInCells(int polygon, int from) {
        int to = memberCount;
        double taken = 0;
        for (int i = from; i < to; i++) {
            taken += takenInCell(polygon, i, from, to);
            memberCount = to;
        }
        return taken;
    }

    /** Shares many balls out between two halves of the polygon, unless too many touch both. */
    private double takenFromHalves(int polygon, int from) {
        int to = memberCount;
        int mark = polygons.count();
        int first = polygons.cutFirstHalf(polygon);
        int second = polygons.cutSecondHalf(polygon);
        boolean someOfFirstIsLeft = addThoseThatTouch(first, from, to);
        int middle = memberCount;
        boolean someOfSecondIsLeft = addThoseThatTouch(second, from, to);
        double taken;
        if (someOfFirstIsLeft && someOfSecondIsLeft && memberCount - to > MOST_GROWTH * (to - from)) {
            memberCount = to;
            taken = takenInCells(polygon, from);
        } else {
            taken = someOfSecondIsLeft ? takenByAll(second, middle) : polygons.area(second);
            memberCount = middle;
            taken += someOfFirstIsLeft ? takenByAll(first, to) : polygons.area(first);
        }
        memberCount = to;
        polygons.dropTo(mark);
        return taken;
    }

    /** Adds a set on top: those of another that touch a polygon; false, and none, if one ball takes all its light. */
    private boolean addThoseThatTouch(int polygon, int from, int to) {
        int top = memberCount;
        for (int i = from; i < to; i++) {
            addMember(members[i]);
        }
        boolean isSomeLeft = keepThoseThatTouch(polygon, top);
        memberCount = isSomeLeft ? memberCount : top;
        return isSomeLeft;
    }

    /**
     * What is taken in the cell of one ball: by itself, and by the others of what it lets through. Balls whose shadows
     * are apart do not bound each other's cells, as no point is in both.
     */
    private double takenInCell(int polygon, int place, int from, int to) {
        BallShadow ball = members[place];
        int mark = polygons.count();
        int cell = polygon;
        for (int i = from; i < to; i++) {
            BallShadow other = members[i];
            if (i != place && !ball.isApartFrom(other)) {
                addMember(other);
                // where both are the same ball, the first has it all
                Side side = place < i ? ball.sideOfCell(polygons, cell, other)
                    : other.sideOfCell(polygons, cell, ball).opposite();
                if (side == Side.BEYOND) {
                    polygons.dropTo(mark);
                    return 0;
                }
                cell = side == Side.WITHIN ? cell : ball.cutToCell(polygons, cell, other);
            }
        }
        double taken = (1 - ball.transmittance()) * ball.area(polygons, cell);
        if (ball.transmittance() > 0 && memberCount > to) {
            taken += ball.transmittance() * takenLight(cell, to);
        }
        polygons.dropTo(mark);
        return taken;
    }
}
