package raytracing.area;

import java.util.Arrays;

/**
 * A stack of convex polygons in the (x, y) plane, empty at first, their corners counterclockwise. Polygons are cut by
 * half-planes into new ones, which are put on top; a caller drops those that it no longer needs, so cutting does not allocate.
 * Not thread-safe.
 */
public final class ConvexPolygons {
    private double[] x = new double[64];
    private double[] y = new double[64];

    /** Polygon i has the corners from start[i] to start[i + 1]. */
    private int[] start = new int[16];
    private int count;

    /** How many polygons there are; the next one gets this number. */
    int count() {
        return count;
    }

    /** Drops the polygons on top, so that {@code count} are left. */
    public void dropTo(int count) {
        this.count = count;
    }

    /** Puts a square around (0, 0) on top, given half its edge, above 0; returns its number. */
    public int addSquare(double halfWidth) {
        int at = begin(4);
        x[at] = -halfWidth;
        y[at++] = -halfWidth;
        x[at] = halfWidth;
        y[at++] = -halfWidth;
        x[at] = halfWidth;
        y[at++] = halfWidth;
        x[at] = -halfWidth;
        y[at++] = halfWidth;
        return end(at);
    }

    /** Puts a regular polygon on top, given the radius, above 0, of the disc with the same area; returns its number. */
    int addRegular(double middleX, double middleY, double radius, int sides) {
        double turn = 2 * Math.PI / sides;
        double cosine = StrictMath.cos(turn);
        double sine = StrictMath.sin(turn);
        double cornerX = radius * Math.sqrt(turn / sine);
        double cornerY = 0;
        int at = begin(sides);
        for (int i = 0; i < sides; i++) {
            x[at] = middleX + cornerX;
            y[at++] = middleY + cornerY;
            double turned = cosine * cornerX - sine * cornerY;
            cornerY = sine * cornerX + cosine * cornerY;
            cornerX = turned;
        }
        return end(at);
    }

    /** Makes room for a polygon on top; returns the index of its first corner. */
    private int begin(int mostCorners) {
        if (count + 2 > start.length) {
            start = Arrays.copyOf(start, 2 * start.length);
        }
        int from = start[count];
        if (from + mostCorners > x.length) {
            x = Arrays.copyOf(x, 2 * (from + mostCorners));
            y = Arrays.copyOf(y, 2 * (from + mostCorners));
        }
        return from;
    }

    /** Ends the polygon on top before an index; returns its number. */
    private int end(int to) {
        start[count + 1] = to;
        return count++;
    }

    /** Index of a polygon's first corner, for {@link #x} and {@link #y}. */
    int from(int polygon) {
        return start[polygon];
    }

    /** Index after its last corner. */
    int to(int polygon) {
        return start[polygon + 1];
    }

    double x(int at) {
        return x[at];
    }

    double y(int at) {
        return y[at];
    }

    /** Whether a polygon is in the half-plane a x + b y + c &gt;= 0; one on the border counts as within. */
    Side side(int polygon, double a, double b, double c) {
        boolean isWithin = true;
        boolean isBeyond = true;
        for (int i = start[polygon]; i < start[polygon + 1]; i++) {
            double value = a * x[i] + b * y[i] + c;
            isWithin &= value >= 0;
            isBeyond &= value <= 0;
        }
        return isWithin ? Side.WITHIN : isBeyond ? Side.BEYOND : Side.CUT;
    }

    /**
     * Puts the part of a polygon, which stays, with a x + b y + c &gt;= 0 on top; returns its number. The cut with -a, -b, -c
     * has the same corners on the border, bit for bit, so nothing is lost or counted twice between the two.
     */
    public int cut(int polygon, double a, double b, double c) {
        int from = start[polygon];
        int to = start[polygon + 1];
        int at = begin(2 * (to - from));
        int last = to - 1;
        double lastHeight = to > from ? a * x[last] + b * y[last] + c : 0;
        for (int i = from; i < to; i++) {
            double height = a * x[i] + b * y[i] + c;
            if (height > 0 && lastHeight < 0 || height < 0 && lastHeight > 0) {
                double fraction = lastHeight / (lastHeight - height);
                x[at] = x[last] + fraction * (x[i] - x[last]);
                y[at++] = y[last] + fraction * (y[i] - y[last]);
            }
            if (height >= 0) {
                x[at] = x[i];
                y[at++] = y[i];
            }
            last = i;
            lastHeight = height;
        }
        return end(at);
    }

    /** Puts half a polygon on top: the left for sign -1, the right for 1, or lower and upper if it is higher than wide. */
    int cutHalf(int polygon, double sign) {
        double left = Double.POSITIVE_INFINITY;
        double right = Double.NEGATIVE_INFINITY;
        double lower = Double.POSITIVE_INFINITY;
        double upper = Double.NEGATIVE_INFINITY;
        for (int i = start[polygon]; i < start[polygon + 1]; i++) {
            left = Math.min(left, x[i]);
            right = Math.max(right, x[i]);
            lower = Math.min(lower, y[i]);
            upper = Math.max(upper, y[i]);
        }
        return right - left >= upper - lower ? cut(polygon, sign, 0, -sign * (left + right) / 2)
            : cut(polygon, 0, sign, -sign * (lower + upper) / 2);
    }

    /** Puts the common part of two polygons on top, perhaps with others below it. */
    int common(int polygon, int other) {
        int common = polygon;
        int to = start[other + 1];
        int last = to - 1;
        for (int i = start[other]; i < to; i++) {
            double a = y[last] - y[i];
            double b = x[i] - x[last];
            common = cut(common, a, b, -a * x[i] - b * y[i]);
            last = i;
        }
        return common;
    }

    /** Whether a point is in a polygon or on its border. */
    boolean contains(int polygon, double pointX, double pointY) {
        int to = start[polygon + 1];
        int last = to - 1;
        for (int i = start[polygon]; i < to; i++) {
            if ((x[i] - x[last]) * (pointY - y[last]) < (pointX - x[last]) * (y[i] - y[last])) {
                return false;
            }
            last = i;
        }
        return true;
    }

    /** The area of a polygon, at least 0; 0 for fewer than three corners. */
    public double area(int polygon) {
        int from = start[polygon];
        double twice = 0;
        for (int i = from + 2; i < start[polygon + 1]; i++) {
            twice += (x[i - 1] - x[from]) * (y[i] - y[from]) - (x[i] - x[from]) * (y[i - 1] - y[from]);
        }
        return Math.max(twice / 2, 0);
    }
}
