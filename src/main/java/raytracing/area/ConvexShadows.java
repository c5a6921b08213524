package raytracing.area;

import java.util.Arrays;

/**
 * Shadows on a plane, and how much light they leave of a square. Figures with straight outlines come first: each cuts the
 * square into convex pieces that are either in its shadow or not, and the next shadow is applied to each piece. Then come
 * {@link DiscShadows} and {@link BallShadows}. Pieces without light are dropped at once.
 *
 * <p>Shadows are cast from the apex (0, 0, 0) on the plane z = depth. The inner side of a line (a, b, c) is where
 * a x + b y + c &gt;= 0. Not thread-safe.
 */
public final class ConvexShadows {
    private final ConvexPolygons polygons = new ConvexPolygons();
    private final BallShadows balls = new BallShadows(polygons);
    private final DiscShadows discs = new DiscShadows(polygons, balls);
    private double[] a = new double[32];
    private double[] b = new double[32];
    private double[] c = new double[32];
    private int lineCount;

    /** Figure i has the lines from firstLine[i] to firstLine[i + 1]. */
    private int[] firstLine = new int[9];
    private double[] insidePassing = new double[8];
    private double[] outsidePassing = new double[8];

    /** A figure's lines before this one do not belong to its outline: the shadow is on their inner sides only. */
    private int[] firstOfOutline = new int[8];
    private int count;

    /** A power of two that makes the square about as wide as 1, for which the constants of the conics are chosen. */
    private double scale;
    private double halfWidth;

    /**
     * Removes all shadows. Must be called before the first one is added.
     *
     * @param depth distance from the apex to the plane, above 0, and less than 2^100 times the width of the square
     * @param halfWidthOfSquare half the edge of the square around (0, 0), above 0
     */
    public void clear(double depth, double halfWidthOfSquare) {
        scale = Math.scalb(1.0, -Math.getExponent(halfWidthOfSquare));
        halfWidth = scale * halfWidthOfSquare;
        lineCount = 0;
        count = 0;
        discs.clear(scale * depth, scale);
        balls.clear(scale * depth);
    }

    /** The shadows of balls that the plane does not cut. */
    public BallShadows balls() {
        return balls;
    }

    /** The shadows of balls that the plane cuts. */
    public DiscShadows discs() {
        return discs;
    }

    /**
     * Begins a shadow: a convex figure with straight sides, whose lines follow. It may be bounded by other lines, which come
     * first, and {@link #beginOutline} before those of the figure. Transmittances are given in it and around it, in [0, 1].
     */
    public void beginFigure(double inside, double outside) {
        if (count == insidePassing.length) {
            insidePassing = Arrays.copyOf(insidePassing, 2 * count);
            outsidePassing = Arrays.copyOf(outsidePassing, 2 * count);
            firstOfOutline = Arrays.copyOf(firstOfOutline, 2 * count);
            firstLine = Arrays.copyOf(firstLine, 2 * count + 1);
        }
        insidePassing[count] = inside;
        outsidePassing[count] = outside;
        firstOfOutline[count] = lineCount;
        count++;
        firstLine[count] = lineCount;
    }

    /** The lines that follow are those of the figure begun last; those before only bound the shadow. */
    public void beginOutline() {
        firstOfOutline[count - 1] = lineCount;
    }

    /** Adds a line to the figure begun last, which is on the inner side of all its lines. */
    public void addLine(double lineA, double lineB, double lineC) {
        if (lineCount == a.length) {
            a = Arrays.copyOf(a, 2 * lineCount);
            b = Arrays.copyOf(b, 2 * lineCount);
            c = Arrays.copyOf(c, 2 * lineCount);
        }
        a[lineCount] = lineA;
        b[lineCount] = lineB;
        c[lineCount] = scale * lineC;
        firstLine[count] = ++lineCount;
    }

    /**
     * The share of light, in [0, 1], that comes to the apex from the square, which shines evenly: the mean over the square of
     * the product of the transmittances of all shadows that cover a point.
     */
    public double share() {
        polygons.dropTo(0);
        double share = light(polygons.addSquare(halfWidth), 0, 1) / (4 * halfWidth * halfWidth);
        return share > 0 ? Math.min(share, 1) : 0;
    }

    /** The light of a piece that shines with some strength, past the figures from an index on, the discs and the balls. */
    private double light(int piece, int figure, double strength) {
        if (strength == 0) {
            return 0;
        }
        return figure == count ? discs.light(piece, 0, strength)
            : lightPastGate(piece, figure, firstLine[figure], strength);
    }

    private double lightPastGate(int piece, int figure, int gate, double strength) {
        if (gate == firstOfOutline[figure]) {
            return lightPastFigure(piece, figure, strength);
        }
        return switch (polygons.side(piece, a[gate], b[gate], c[gate])) {
            case WITHIN -> lightPastGate(piece, figure, gate + 1, strength);
            case BEYOND -> light(piece, figure + 1, strength);
            case CUT -> {
                int mark = polygons.count();
                double light = light(polygons.cut(piece, -a[gate], -b[gate], -c[gate]), figure + 1, strength);
                polygons.dropTo(mark);
                light += lightPastGate(polygons.cut(piece, a[gate], b[gate], c[gate]), figure, gate + 1, strength);
                polygons.dropTo(mark);
                yield light;
            }
        };
    }

    /**
     * The part outside the figure is cut off line by line, so that every part is convex. A piece that is wholly beyond one
     * line is not cut, which is tested first. This method is long on purpose: the virtual machine does not inline a hot
     * method of more than 325 bytes into its callers (DECISIONS).
     */
    private double lightPastFigure(int piece, int figure, double strength) {
        int from = firstOfOutline[figure];
        double inside = insidePassing[figure] * strength;
        double outside = outsidePassing[figure] * strength;
        int to = firstLine[figure + 1];
        for (int i = from; i < to; i++) {
            if (polygons.side(piece, a[i], b[i], c[i]) == Side.BEYOND) {
                return light(piece, figure + 1, outside);
            }
        }
        int mark = polygons.count();
        int rest = piece;
        double light = 0;
        for (int i = from; i < to; i++) {
            Side side = polygons.side(rest, a[i], b[i], c[i]);
            if (side == Side.BEYOND) {
                light += light(rest, figure + 1, outside);
                polygons.dropTo(mark);
                return light;
            }
            if (side == Side.CUT) {
                if (outside > 0) {
                    int top = polygons.count();
                    light += light(polygons.cut(rest, -a[i], -b[i], -c[i]), figure + 1, outside);
                    polygons.dropTo(top);
                }
                rest = polygons.cut(rest, a[i], b[i], c[i]);
            }
        }
        if (inside > 0) {
            light += light(rest, figure + 1, inside);
        }
        polygons.dropTo(mark);
        return light;
    }
}
