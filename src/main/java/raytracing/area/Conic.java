package raytracing.area;

/**
 * A convex figure in the (x, y) plane that a conic bounds: the points with
 * Q(x, y) = xx x x + 2 xy x y + yy y y + 2 (x0 x + y0 y) + c &gt;= 0 on one side of a line, which separates the
 * two branches of a hyperbola. It can be set again and again. Not thread-safe.
 */
class Conic {
    /** An arc of an ellipse with this shape leaves out less than 2^-56 of it, and its chord may be only rounding. */
    private static final double SHAPE_OF_NEARLY_ALL = 0x1p40;

    /** A smaller part of an ellipse may be only the rounding where two outlines touch. */
    private static final double NEGLIGIBLE = 0x1p-20;

    private double xx;
    private double xy;
    private double yy;
    private double x0;
    private double y0;
    private double c;

    /** The figure is where this linear function is above 0. */
    private double lineA;
    private double lineB;
    private double lineC;

    /** For an ellipse only; other figures are unbounded, so they are in no polygon, and have area 0 here. */
    private double middleX;
    private double middleY;
    private double wholeArea;

    /** Twice the area found so far, seen from (0, 0). */
    private double twiceArea;

    /** Whether an arc seemed to go nearly all around: it may be a mere touch, as the chord's direction is not certain. */
    private boolean isTouched;

    /** Where the outline of the polygon last left the figure, and where it first entered it. */
    private boolean hasLeft;
    private double leftX;
    private double leftY;
    private double enteredX;
    private double enteredY;

    /** Sets the coefficients of Q. */
    final void setForm(double xx, double xy, double yy, double x0, double y0, double c) {
        this.xx = xx;
        this.xy = xy;
        this.yy = yy;
        this.x0 = x0;
        this.y0 = y0;
        this.c = c;
        wholeArea = 0;
    }

    /** Sets the line; the figure is where a x + b y + c is above 0. */
    final void setLine(double a, double b, double c) {
        lineA = a;
        lineB = b;
        lineC = c;
    }

    /** Sets the centre and area of a conic that is an ellipse. */
    final void setEllipse(double x, double y, double area) {
        middleX = x;
        middleY = y;
        wholeArea = area;
    }

    /** Sets all to a disc. */
    final void setDisc(double x, double y, double radius) {
        setForm(-1, 0, -1, x, y, radius * radius - x * x - y * y);
        setLine(0, 0, 1);
        setEllipse(x, y, Math.PI * radius * radius);
    }

    private boolean contains(double x, double y) {
        return x * (xx * x + xy * y + x0) + y * (xy * x + yy * y + y0) + (x0 * x + y0 * y + c) >= 0
            && lineA * x + lineB * y + lineC > 0;
    }

    /** Whether a polygon is in the figure. */
    final Side side(ConvexPolygons polygons, int polygon) {
        boolean isWithin = true;
        boolean isBeyond = true;
        for (int i = polygons.from(polygon); i < polygons.to(polygon); i++) {
            boolean isInside = contains(polygons.x(i), polygons.y(i));
            isWithin &= isInside;
            isBeyond &= !isInside;
            if (!isWithin && !isBeyond) {
                return Side.CUT;
            }
        }
        if (isWithin) {
            return Side.WITHIN;
        }
        return area(polygons, polygon) > 0 ? Side.CUT : Side.BEYOND;
    }

    /**
     * The area, at least 0, of the part of a polygon that is in the figure. The common part has straight sides, where the
     * polygon's outline is in the figure, and arcs of the conic between them: a polygon of chords, and a segment for each
     * arc. The error is of the order of rounding (measured in {@code ConicTest}).
     *
     * <p>Along a side, Q is proportional to q1 + 2 b s + q2 s s, with s from 0 to infinity at s / (1 + s) of the way.
     */
    final double area(ConvexPolygons polygons, int polygon) {
        int from = polygons.from(polygon);
        int to = polygons.to(polygon);
        if (to - from < 3) {
            return 0;
        }
        twiceArea = 0;
        hasLeft = false;
        isTouched = false;
        boolean isCrossed = false;
        double x1 = polygons.x(to - 1);
        double y1 = polygons.y(to - 1);
        double gradientX = xx * x1 + xy * y1 + x0;
        double gradientY = xy * x1 + yy * y1 + y0;
        double rest = x0 * x1 + y0 * y1 + c;
        double q1 = x1 * gradientX + y1 * gradientY + rest;
        double ahead1 = lineA * x1 + lineB * y1 + lineC;
        boolean inside1 = q1 >= 0 && ahead1 > 0;
        for (int i = from; i < to; i++) {
            double x2 = polygons.x(i);
            double y2 = polygons.y(i);
            double b = x2 * gradientX + y2 * gradientY + rest;
            gradientX = xx * x2 + xy * y2 + x0;
            gradientY = xy * x2 + yy * y2 + y0;
            rest = x0 * x2 + y0 * y2 + c;
            double q2 = x2 * gradientX + y2 * gradientY + rest;
            double ahead2 = lineA * x2 + lineB * y2 + lineC;
            boolean inside2 = q2 >= 0 && ahead2 > 0;
            if (inside1 && inside2) {
                twiceArea += x1 * y2 - x2 * y1;
            } else if (inside1) {
                isCrossed = true;
                leave(x1, y1, x2, y2, firstExit(q1, b, q2));
            } else if (inside2) {
                isCrossed = true;
                enter(x1, y1, x2, y2, 1 - firstExit(q2, b, q1));
            } else if (b > 0 && q1 < 0 && q2 < 0 && b * b > q1 * q2) {
                double sum = b + Math.sqrt(b * b - q1 * q2);
                double entry = -q1 / (sum - q1);
                isCrossed |= ahead1 + entry * (ahead2 - ahead1) > 0
                    && passThrough(x1, y1, x2, y2, entry, sum / (sum - q2));
            }
            x1 = x2;
            y1 = y2;
            q1 = q2;
            ahead1 = ahead2;
            inside1 = inside2;
        }
        if (!isCrossed) {
            return inside1 ? polygons.area(polygon) : uncrossedArea(polygons, polygon);
        }
        if (hasLeft) {
            addArc(enteredX, enteredY);
        }
        double area = Math.max(twiceArea / 2, 0);
        if (isTouched && area < NEGLIGIBLE * wholeArea) {
            area = Math.max(area, uncrossedArea(polygons, polygon));
        }
        return Math.min(area, polygons.area(polygon));
    }

    /** Where a side that starts in the figure first leaves it, as a fraction of the side; b belongs to both ends. */
    private static double firstExit(double inside, double b, double outside) {
        double root = Math.sqrt(Math.max(b * b - inside * outside, 0));
        if (b > 0 && outside < 0) {
            return (b + root) / (b + root - outside);
        }
        double sum = inside + root - b;
        return sum > 0 ? inside / sum : 0;
    }

    private void leave(double x1, double y1, double x2, double y2, double exit) {
        leaveAt(x1 + exit * (x2 - x1), y1 + exit * (y2 - y1));
        twiceArea += x1 * leftY - leftX * y1;
    }

    private void enter(double x1, double y1, double x2, double y2, double entry) {
        double x = x1 + entry * (x2 - x1);
        double y = y1 + entry * (y2 - y1);
        enterAt(x, y);
        twiceArea += x * y2 - x2 * y;
    }

    /** Returns false if entry and exit are the same point: doubles cannot tell such a touch from a miss. */
    private boolean passThrough(double x1, double y1, double x2, double y2, double entry, double exit) {
        double entryX = x1 + entry * (x2 - x1);
        double entryY = y1 + entry * (y2 - y1);
        double exitX = x1 + exit * (x2 - x1);
        double exitY = y1 + exit * (y2 - y1);
        if (!(exit > entry) || entryX == exitX && entryY == exitY) {
            return false;
        }
        enterAt(entryX, entryY);
        twiceArea += entryX * exitY - exitX * entryY;
        leaveAt(exitX, exitY);
        return true;
    }

    private void leaveAt(double x, double y) {
        hasLeft = true;
        leftX = x;
        leftY = y;
    }

    private void enterAt(double x, double y) {
        if (hasLeft) {
            addArc(x, y);
        } else {
            enteredX = x;
            enteredY = y;
        }
        hasLeft = false;
    }

    /**
     * Adds the area between (0, 0) and the arc from where the outline left the figure to (toX, toY). The arc is on the right
     * of its chord. Half the chord is d; the direction conjugate to it leads from the chord's middle to the arc's apex, and
     * along it Q is proportional to q0 + 2 b t + a t t.
     */
    private void addArc(double toX, double toY) {
        twiceArea += leftX * toY - toX * leftY;
        double dx = (toX - leftX) / 2;
        double dy = (toY - leftY) / 2;
        double middleOfChordX = (toX + leftX) / 2;
        double middleOfChordY = (toY + leftY) / 2;
        double conjugateX = -(xy * dx + yy * dy);
        double conjugateY = xx * dx + xy * dy;
        double q0 = conjugateX * dy - conjugateY * dx;
        double a = conjugateX * (xx * conjugateX + xy * conjugateY) + conjugateY * (xy * conjugateX + yy * conjugateY);
        double b = conjugateX * (xx * middleOfChordX + xy * middleOfChordY + x0)
            + conjugateY * (xy * middleOfChordX + yy * middleOfChordY + y0);
        if (!(q0 > 0) || b >= 0 && !(a < 0)) {
            return;                          // so flat that rounding leaves no arc
        }
        double discriminant = b * b - a * q0;
        double root = Math.sqrt(Math.max(discriminant, 0));
        double apex = b > 0 ? (b + root) / -a : q0 / (root - b);
        if (discriminant < 0) {
            apex = Math.sqrt(q0 / a);        // for two straight lines, which rounding made of a sharp hyperbola
        }
        double shape = -a * apex * apex / q0;
        if (shape > SHAPE_OF_NEARLY_ALL) {
            isTouched = true;
        } else {
            twiceArea += 2 * q0 * apex * ConicSegment.areaFactor(shape);
        }
    }

    /** A polygon that rounding has shrunk to one point seems to contain every point. */
    private double uncrossedArea(ConvexPolygons polygons, int polygon) {
        return wholeArea > 0 && polygons.contains(polygon, middleX, middleY) ? Math.min(wholeArea, polygons.area(polygon)) : 0;
    }
}
