package raytracing.area;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The shadows of several balls on a plane, and how much light they take from a polygon. Not thread-safe.
 *
 * <p>Where shadows overlap, no boundary of the fourth degree has to be found. A point e is in the shadow of ball i if
 * f_i(e) = m_i . e / sqrt(k_i) is at least |e|: all shadows compare a linear function with the same length. So where f_i is
 * the greatest, every point that is in any shadow is in that of ball i. This cuts the polygon into convex cells, a power
 * diagram of cones with one apex, in each of which the shadows are nested: what ball i takes there has a closed form, and
 * behind it only the others remain.
 */
public final class BallShadows {
    /** More balls than this are first distributed over two halves of the polygon, if that separates them (measured). */
    private static final int MOST_AT_ONCE = 4;

    /** The most by which distributing balls may multiply their number, as some go to both halves. */
    private static final double MOST_GROWTH = 1.5;

    /** Smaller parts, as a share of the polygon's area, are not halved. */
    private static final double LEAST_PART = 0x1p-16;

    private final ConvexPolygons polygons;
    private double depth;

    /** Those that {@link #add} sets, allocated once. */
    private final List<BallShadow> own = new ArrayList<>();

    /** A stack of sets of balls, each a range of members. All balls are the first set. */
    private BallShadow[] members = new BallShadow[32];
    private int memberCount;
    private double leastArea;

    /** No balls; polygons are cut on the given stack, which every query leaves unchanged. */
    BallShadows(ConvexPolygons polygons) {
        this.polygons = polygons;
    }

    /** Removes all balls; {@code planeDepth} is the distance from the apex (0, 0, 0) to the plane, above 0. */
    void clear(double planeDepth) {
        depth = planeDepth;
        memberCount = 0;
    }

    /**
     * Adds a ball.
     *
     * @param x of its centre, relative to the apex
     * @param radius of the ball; the apex is outside it, or on it but for rounding
     * @param transmittance share of light that the ball lets through, in [0, 1]
     */
    public void add(double x, double y, double z, double radius, double transmittance) {
        while (own.size() <= memberCount) {
            own.add(new BallShadow());
        }
        BallShadow ball = own.get(memberCount);
        ball.set(x, y, z, radius, transmittance, depth);
        push(ball);
    }

    /** Adds a ball until {@link #pop}. */
    void push(BallShadow ball) {
        if (memberCount == members.length) {
            members = Arrays.copyOf(members, 2 * memberCount);
        }
        members[memberCount++] = ball;
    }

    /** Removes the ball that was added last. */
    void pop() {
        memberCount--;
    }

    /** Whether no ball's shadow overlaps that of another ball. */
    boolean areApartFrom(BallShadow other) {
        for (int i = 0; i < memberCount; i++) {
            if (!members[i].isApartFrom(other)) {
                return false;
            }
        }
        return true;
    }

    /**
     * The light that the balls take from a polygon that shines evenly with 1 for each unit of area: the integral over the
     * polygon of 1 minus the product of the transmittances of the balls that shadow a point.
     */
    double takenLight(int polygon) {
        if (memberCount == 0) {
            return 0;
        }
        leastArea = LEAST_PART * polygons.area(polygon);
        int count = memberCount;
        for (int i = 0; i < count; i++) {
            push(members[i]);
        }
        double taken = takenLight(polygon, count);
        memberCount = count;
        return taken;
    }

    /** The light that the set of balls on top takes: the members from an index on. */
    private double takenLight(int polygon, int from) {
        if (memberCount == from + 1) {
            return (1 - members[from].transmittance()) * members[from].area(polygons, polygon);
        }
        return keepThoseThatTouch(polygon, from) ? takenByAll(polygon, from) : polygons.area(polygon);
    }

    /** Removes balls whose shadows miss the polygon; false if one ball takes all its light. */
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

    /** The same for balls that all touch the polygon. */
    private double takenByAll(int polygon, int from) {
        return memberCount - from > MOST_AT_ONCE && polygons.area(polygon) > leastArea ? takenFromHalves(polygon, from)
            : takenInCells(polygon, from);
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

    /** Distributes many balls over two halves of the polygon, unless too many touch both. */
    private double takenFromHalves(int polygon, int from) {
        int to = memberCount;
        int mark = polygons.count();
        int first = polygons.cutHalf(polygon, -1);
        int second = polygons.cutHalf(polygon, 1);
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

    /** Puts those of a set that touch a polygon on top; false, and none are put, if one ball takes all its light. */
    private boolean addThoseThatTouch(int polygon, int from, int to) {
        int top = memberCount;
        for (int i = from; i < to; i++) {
            push(members[i]);
        }
        boolean isSomeLeft = keepThoseThatTouch(polygon, top);
        memberCount = isSomeLeft ? memberCount : top;
        return isSomeLeft;
    }

    /**
     * The light taken in the cell of one ball: by itself, and by the others from what it lets through. Balls whose shadows
     * are apart do not bound each other's cells, as no point is in both.
     */
    private double takenInCell(int polygon, int index, int from, int to) {
        BallShadow ball = members[index];
        int mark = polygons.count();
        int cell = polygon;
        for (int i = from; i < to && cell >= 0; i++) {
            BallShadow other = members[i];
            if (i != index && !ball.isApartFrom(other)) {
                push(other);
                cell = ball.cutToCell(polygons, cell, other, index < i);
            }
        }
        double taken = 0;
        if (cell >= 0) {
            taken = (1 - ball.transmittance()) * ball.area(polygons, cell);
            if (ball.transmittance() > 0 && memberCount > to) {
                taken += ball.transmittance() * takenLight(cell, to);
            }
        }
        polygons.dropTo(mark);
        return taken;
    }
}
