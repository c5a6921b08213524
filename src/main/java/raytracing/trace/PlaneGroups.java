package raytracing.trace;

import java.util.Arrays;
import raytracing.math.Vector;
import raytracing.surface.Plane;

/**
 * Many planes, in groups of groups, so that a query leaves out at once all planes that a line does not reach. Endless planes
 * have no bounds in space. But a plane is four numbers, its unit normal N and its offset c, and similar planes have similar
 * ones: a group has an interval for each. From these follow intervals of the gap c - N . o of a point and of the approach
 * N . d of a line o + t d, and so the first t at which the line may meet any plane of the group.
 *
 * <p>The groups are a complete binary tree: 1 is the root, 2 i and 2 i + 1 are the halves of group i. So a query needs no
 * stack, and its state is a single number, its place: the group, and a bit for each group above it, itself included, whose
 * other half waits. Immutable.
 */
public final class PlaneGroups {
    /** The place of a query that has not begun. */
    public static final long START = 0;

    /** The place of a query that is over. */
    public static final long END = -1;

    private static final int ROOT = 1;
    private static final int MOST_IN_A_LEAF = 4;

    /** Of the four numbers, the middles of the intervals, then how far the intervals reach from there. */
    private static final int STRIDE = 8;
    private static final int NUMBERS = 4;
    private static final int OFFSET = 3;

    /** Normals of other lengths are in no group that may be left out: their unit vectors may be off by more than roundings. */
    private static final double SHORTEST = 0x1p-1000;
    private static final double LONGEST = 0x1p1000;

    /**
     * 8 u, with u = 2^-53: what the numbers of a group's planes, its middle and its reach are off by together, relative to the
     * larger end of the interval (proved: 5 u for a unit vector, a rounding for the middle and two for the reach).
     */
    private static final double WIDENED = 0x1p-50;

    /**
     * 256 u, in multiples of the sizes that go into a gap, an approach or how far it reaches: far above their rounding, at
     * most 10 u, and not below what a shaft allows for, so that no plane is left out that is an obstacle there.
     */
    private static final double ROUNDING = 0x1p-45;

    /** In multiples of a point's error, which counts once for each axis: at most 1.8 for a unit normal. */
    private static final double ERRORS = 8;

    private static final double MISSED = -1;

    /** Positions along an interval by which planes are sorted. */
    private static final double POSITIONS = 1 << 30;

    private final int count;
    private final int depth;
    private final double[] groups;

    private PlaneGroups(int count) {
        this.count = count;
        int levels = 0;
        while (count > MOST_IN_A_LEAF << levels) {
            levels++;
        }
        depth = levels;
        groups = new double[STRIDE << (depth + 1)];
    }

    /** Groups planes, and brings them and their numbers in the order of the groups. */
    static PlaneGroups of(Plane[] planes, int[] numbers) {
        PlaneGroups made = new PlaneGroups(planes.length);
        Grouping grouping = new Grouping(planes);
        made.group(ROOT, 0, planes.length, grouping);
        Plane[] listed = planes.clone();
        int[] listedNumbers = numbers.clone();
        for (int i = 0; i < planes.length; i++) {
            planes[i] = listed[grouping.order[i]];
            numbers[i] = listedNumbers[grouping.order[i]];
        }
        return made;
    }

    /** Groups a range of the order, which becomes a group. */
    private void group(int group, int from, int to, Grouping grouping) {
        grouping.measure(from, to);
        grouping.write(groups, STRIDE * group);
        if (group < 1 << depth) {
            grouping.sortAlongWidest(from, to);
            int middle = from(2 * group + 1);
            group(2 * group, from, middle, grouping);
            group(2 * group + 1, middle, to, grouping);
        }
    }

    /** The first entry of a group. */
    private int from(int group) {
        int level = 31 - Integer.numberOfLeadingZeros(group);
        return (int) ((long) count * (group - (1 << level)) >> level);
    }

    /** The four numbers of each plane, and the order in which they are grouped. */
    private static final class Grouping {
        private final double[][] numbers;
        private final int[] order;
        private final long[] sorted;
        private final double typicalOffset;
        private final double[] least = new double[NUMBERS];
        private final double[] most = new double[NUMBERS];

        Grouping(Plane[] planes) {
            numbers = new double[NUMBERS][planes.length];
            order = new int[planes.length];
            sorted = new long[planes.length];
            double sum = 0;
            for (int i = 0; i < planes.length; i++) {
                Vector normal = planes[i].normal();
                double length = normal.length();
                double divisor = length >= SHORTEST && length <= LONGEST ? length : Double.NaN;
                numbers[0][i] = normal.x() / divisor;
                numbers[1][i] = normal.y() / divisor;
                numbers[2][i] = normal.z() / divisor;
                numbers[OFFSET][i] = planes[i].offset() / divisor;
                order[i] = i;
                sum += Math.abs(numbers[OFFSET][i]) / planes.length;
            }
            typicalOffset = sum;
        }

        /** Finds the intervals of a range; NaN, where a plane has such numbers. */
        void measure(int from, int to) {
            Arrays.fill(least, Double.POSITIVE_INFINITY);
            Arrays.fill(most, Double.NEGATIVE_INFINITY);
            for (int i = from; i < to; i++) {
                for (int k = 0; k < NUMBERS; k++) {
                    least[k] = Math.min(least[k], numbers[k][order[i]]);
                    most[k] = Math.max(most[k], numbers[k][order[i]]);
                }
            }
        }

        void write(double[] groups, int at) {
            for (int k = 0; k < NUMBERS; k++) {
                groups[at + k] = (least[k] + most[k]) / 2;
                groups[at + NUMBERS + k] =
                    (most[k] - least[k]) / 2 + WIDENED * Math.max(Math.abs(least[k]), Math.abs(most[k]));
            }
        }

        /** Sorts a measured range along its widest interval; a turn of a normal counts as it moves a plane far away. */
        void sortAlongWidest(int from, int to) {
            int widest = OFFSET;
            double width = most[OFFSET] - least[OFFSET];
            for (int k = 0; k < OFFSET; k++) {
                double moved = (most[k] - least[k]) * typicalOffset;
                if (moved > width) {
                    widest = k;
                    width = moved;
                }
            }
            double start = least[widest];
            double perPosition = POSITIONS / (most[widest] - start);
            for (int i = from; i < to; i++) {
                long position = (long) ((numbers[widest][order[i]] - start) * perPosition);
                sorted[i] = position << Integer.SIZE | order[i];
            }
            Arrays.sort(sorted, from, to);
            for (int i = from; i < to; i++) {
                order[i] = (int) sorted[i];
            }
        }
    }

    /**
     * Goes on to the next leaf whose planes a line o + t d may meet at some t from 0 to {@code latest}, both included. Nearer
     * leaves come first, as far as that is known.
     *
     * @param place of the leaf before, or {@link #START}
     * @param error how far each coordinate of the line's ends may be off
     * @param radius of a cone of lines, how far their ends at t = 1 are from o + d; 0 for a single line
     * @param latest may have become earlier since the last call
     * @return the leaf's place, or {@link #END}
     */
    public long next(long place, double ox, double oy, double oz, double error, double dx, double dy, double dz,
                     double radius, double latest) {
        int group = (int) place;
        int waiting = (int) (place >>> Integer.SIZE);
        int leaves = 1 << depth;
        do {
            if (group == START) {
                group = ROOT;
            } else if (waiting == 0) {
                return END;
            } else {
                int up = Integer.numberOfTrailingZeros(waiting);
                group = group >> up ^ 1;
                waiting = waiting >>> up & ~1;
            }
            boolean isMissed = entry(group, ox, oy, oz, error, dx, dy, dz, radius, latest) < 0;
            while (!isMissed && group < leaves) {
                double first = entry(2 * group, ox, oy, oz, error, dx, dy, dz, radius, latest);
                double second = entry(2 * group + 1, ox, oy, oz, error, dx, dy, dz, radius, latest);
                isMissed = first < 0 && second < 0;
                if (!isMissed) {
                    boolean isSecondFirst = first < 0 || second >= 0 && second < first;
                    group = isSecondFirst ? 2 * group + 1 : 2 * group;
                    waiting = waiting << 1 | (first < 0 || second < 0 ? 0 : 1);
                }
            }
            if (!isMissed) {
                return (long) waiting << Integer.SIZE | group;
            }
        } while (true);
    }

    /**
     * A t before which a line meets no plane of a group; {@link #MISSED} if it meets none up to {@code latest}. Every
     * comparison is such that NaN misses nothing.
     */
    private double entry(int group, double ox, double oy, double oz, double error, double dx, double dy, double dz,
                         double radius, double latest) {
        int at = STRIDE * group;
        double gap = groups[at + 3] - (groups[at] * ox + groups[at + 1] * oy + groups[at + 2] * oz);
        double approach = groups[at] * dx + groups[at + 1] * dy + groups[at + 2] * dz;
        double reachX = groups[at + 4] + ROUNDING;
        double reachY = groups[at + 5] + ROUNDING;
        double reachZ = groups[at + 6] + ROUNDING;
        double spread = reachX * Math.abs(ox) + reachY * Math.abs(oy) + reachZ * Math.abs(oz)
            + (groups[at + 7] * (1 + ROUNDING) + ROUNDING * Math.abs(groups[at + 3]) + ERRORS * error);
        double clear = Math.abs(gap) - spread;
        if (!(clear > 0 && clear <= Double.MAX_VALUE)) {
            return 0;
        }
        double speed = (gap < 0 ? -approach : approach)
            + (reachX * Math.abs(dx) + reachY * Math.abs(dy) + reachZ * Math.abs(dz) + radius);
        double entry = clear / speed;
        return speed <= 0 || entry > latest * (1 + ROUNDING) ? MISSED : entry;
    }

    /** First entry of the list in the leaf at a place. */
    public int from(long place) {
        return from((int) place);
    }

    /** The entry after the last of that leaf. */
    public int to(long place) {
        int leaf = (int) place;
        return leaf + 1 == 2 << depth ? count : from(leaf + 1);
    }
}
