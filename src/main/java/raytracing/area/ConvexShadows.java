package raytracing.area;

import java.util.Arrays;

/**
 * Shadows on a plane, and how much light they leave of a square. Figures with straight outlines come first: each cuts
 * the square into convex pieces in which it does one thing, and the next shadow is asked for each piece. Then come
 * {@link DiscShadows}, and at last {@link BallShadows}, for what is left. Pieces without light are dropped at once.
 *
 * <p>Whatever throws a shadow is seen from the apex (0, 0, 0), and the plane is z = depth. A line (a, b, c) has its
 * inner side where a x + b y + c &gt;= 0. One thread, question after question.
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

    /** The first lines, up to this one, are no part of its outline: it counts on their inner sides only. */
    private int[] firstOfOutline = new int[8];
    private int count;

    /** A power of two that makes the square about as wide as 1, to which the conics' rounding is fitted. */
    private double scale;
    private double halfWidth;

    /** No shadows. */
    public ConvexShadows() {
    }

    /**
     * Forgets all shadows.
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

    /**
     * The shadows of balls that count everywhere, to which more may be added.
     *
     * @return those added so far
     */
    public BallShadows balls() {
        return balls;
    }

    /**
     * The shadows of balls that the plane cuts, to which more may be added.
     *
     * @return those added so far
     */
    public DiscShadows discs() {
        return discs;
    }

    /**
     * Begins a shadow that is a convex figure with straight sides; its lines follow.
     *
     * @param passing share of light that comes through, in [0, 1]
     */
    public void beginFigure(double passing) {
        begin(passing, 1);
    }

    /**
     * Begins a shadow that is everything but a convex figure with straight sides. Lines follow that bound the shadow
     * too, if there are some, then {@link #exceptFigure}, then the lines of the figure.
     *
     * @param passing share of light that comes through, in [0, 1]
     */
    public void beginAllButFigure(double passing) {
        begin(1, passing);
    }

    /** The lines from here on are those of the figure that is left out of the shadow. */
    public void exceptFigure() {
        firstOfOutline[count - 1] = lineCount;
    }

    private void begin(double inside, double outside) {
        if (count == insidePassing.length) {
            insidePassing = Arrays.copyOf(insidePassing, 2 * count);
            outsidePassing = Arrays.copyOf(outsidePassing, 2 * count);
            firstOfOutline = Arrays.copyOf(firstOfOutline, 2 * count);
            firstLine = Arrays.copyOf(firstLine, 2 * count + 1);
        }
        insidePassing[count] = inside;
        outsidePassing[count] = outside;
        firstLine[count] = lineCount;
        firstOfOutline[count] = lineCount;
        count++;
        firstLine[count] = lineCount;
    }

    /**
     * Adds a line to the figure that was begun last. The figure is on the inner side of all its lines.
     *
     * @param lineA of the line
     * @param lineB of the line
     * @param lineC of the line
     */
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
     * The light that comes to the apex from the square, which shines evenly, as a share of what came without shadows.
     *
     * @return mean over the square of the product of the transmittances of all shadows that cover a point, in [0, 1]
     */
    public double share() {
        polygons.dropTo(0);
        double light = light(polygons.addSquare(halfWidth), 0, 1);
        double share = light / (4 * halfWidth * halfWidth);
        return share > 0 ? Math.min(share, 1) : 0;
    }

    /** What a piece sends, that shines with the given strength, past all figures but the first few. */
    private double light(int piece, int figure, double strength) {
        if (strength == 0) {
            return 0;
        }
        if (figure == count) {
            return discs.light(piece, strength);
        }
        return lightPastGate(piece, figure, firstLine[figure], strength);
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
     * What is around the figure is cut off line by line, so that every part is convex. First comes the question whether
     * all of the piece is beyond one line: then it stays in one. This method is long on purpose: the virtual machine
     * does not compile a method of more than 325 bytes into its callers again (DECISIONS).
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
