package raytracing.area;

import java.util.Arrays;

/**
 * The shadows of balls that the plane itself cuts, in a disc. On the inner side of a line, light passes differently in
 * the disc and around it; beyond the line, the ball may throw the shadow of its cone. That is how it is with every such
 * ball: in front of its tangent circle it hides only what is in it, behind the circle all of the cone; and a ball
 * around the apex, or one that the apex lies on, hides everything on its side but what is in it.
 *
 * <p>The area of a disc in a convex piece is closed-form. Where shadows of other balls meet the same piece, a polygon
 * takes the disc's place; the discs are few and rarely come together, as a lamp that cuts the wall of a ball is rare.
 *
 * <p>One thread, question after question.
 */
public final class DiscShadows {
    /** Sides of the polygon for a disc whose radius is as long as the piece is wide. */
    private static final int SIDES = 64;
    private static final int FEWEST_SIDES = 16;
    private static final int MOST_SIDES = 1 << 12;

    private final ConvexPolygons polygons;
    private final BallShadows balls;
    private double depth;
    private double scale;
    private Disc[] discs = {new Disc(), new Disc()};
    private int count;

    /** One of the discs; filled anew for every question. */
    private static final class Disc {
        private final Conic outline = new Conic();
        private double middleX;
        private double middleY;
        private double radius;
        private double insidePassing;
        private double outsidePassing;

        /** The inner side of this line is where the disc counts. */
        private double a;
        private double b;
        private double c;

        /** The ball whose cone counts beyond the line, unless the apex is in it. */
        private final BallShadow ball = new BallShadow();
        private boolean isAroundApex;
    }

    DiscShadows(ConvexPolygons polygons, BallShadows balls) {
        this.polygons = polygons;
        this.balls = balls;
    }

    /** Forgets all discs; lengths are multiplied by {@code lengthScale}, the depth is so already. */
    void clear(double planeDepth, double lengthScale) {
        depth = planeDepth;
        scale = lengthScale;
        count = 0;
    }

    /**
     * Adds a ball around the apex, or with the apex on it: on the inner side of a line it hides all but its disc.
     *
     * @param x middle of the disc
     * @param y y part
     * @param radius of the disc, at least 0
     * @param passing share of light that comes through the ball, in [0, 1]
     * @param a of the line
     * @param b of the line
     * @param c of the line
     */
    public void addAround(double x, double y, double radius, double passing, double a, double b, double c) {
        Disc disc = next(x, y, radius, a, b, c);
        disc.isAroundApex = true;
        disc.insidePassing = 1;
        disc.outsidePassing = passing;
    }

    /**
     * Adds a ball that the apex is not in, cut by the plane. The line that parts disc and cone goes through the two points
     * where they touch. If there are none, one is wholly within the other, and counts alone.
     *
     * @param ballX its centre, seen from the apex
     * @param ballY y part
     * @param ballZ z part
     * @param ballRadius its radius
     * @param radius of the disc in the plane, above 0
     * @param passing share of light that comes through the ball, in [0, 1]
     */
    public void addThroughPlane(double ballX, double ballY, double ballZ, double ballRadius, double radius,
                                double passing) {
        double x = scale * ballX;
        double y = scale * ballY;
        double z = scale * ballZ;
        double r = scale * ballRadius;
        double k = x * x + y * y + (z - r) * (z + r);
        double beforeLine = k - z * depth - (x * x + y * y);
        double reach = scale * radius * Math.sqrt(x * x + y * y);
        if (beforeLine <= -reach) {
            balls.add(ballX, ballY, ballZ, ballRadius, passing);
            return;
        }
        Disc disc = beforeLine >= reach ? next(ballX, ballY, radius, 0, 0, 1)
            : next(ballX, ballY, radius, -x, -y, (k - z * depth) / scale);
        disc.isAroundApex = false;
        disc.insidePassing = passing;
        disc.outsidePassing = 1;
        disc.ball.set(x, y, z, r, passing, depth);
    }

    private Disc next(double x, double y, double radius, double a, double b, double c) {
        if (count == discs.length) {
            discs = Arrays.copyOf(discs, 2 * count);
            for (int i = count; i < discs.length; i++) {
                discs[i] = new Disc();
            }
        }
        Disc disc = discs[count++];
        disc.middleX = scale * x;
        disc.middleY = scale * y;
        disc.radius = scale * radius;
        disc.outline.setDisc(disc.middleX, disc.middleY, disc.radius);
        disc.a = a;
        disc.b = b;
        disc.c = scale * c;
        return disc;
    }

    /** What a piece sends, that shines with the given strength, past all discs and balls. */
    double light(int piece, double strength) {
        return light(piece, 0, strength);
    }

    private double light(int piece, int place, double strength) {
        if (strength == 0) {
            return 0;
        }
        if (place == count) {
            return strength * Math.max(polygons.area(piece) - balls.takenLight(piece), 0);
        }
        Disc disc = discs[place];
        if (!disc.isAroundApex && disc.ball.side(polygons, piece) == Side.BEYOND) {
            return light(piece, place + 1, strength);
        }
        return switch (polygons.side(piece, disc.a, disc.b, disc.c)) {
            case WITHIN -> lightWithin(piece, place, strength);
            case BEYOND -> lightBeyond(piece, place, strength);
            case CUT -> {
                int mark = polygons.count();
                double light = lightWithin(polygons.cut(piece, disc.a, disc.b, disc.c), place, strength);
                polygons.dropTo(mark);
                light += lightBeyond(polygons.cut(piece, -disc.a, -disc.b, -disc.c), place, strength);
                polygons.dropTo(mark);
                yield light;
            }
        };
    }

    private double lightBeyond(int piece, int place, double strength) {
        Disc disc = discs[place];
        if (disc.isAroundApex) {
            return light(piece, place + 1, strength);
        }
        balls.push(disc.ball);
        double light = light(piece, place + 1, strength);
        balls.pop();
        return light;
    }

    private double lightWithin(int piece, int place, double strength) {
        Disc disc = discs[place];
        double inside = disc.insidePassing * strength;
        double outside = disc.outsidePassing * strength;
        double covered = disc.outline.area(polygons, piece);
        double open = light(piece, place + 1, 1);
        if (covered > 0 && open < polygons.area(piece) && meetsOthers(disc, place + 1)) {
            covered = Math.max(covered - takenFromDisc(piece, disc, place + 1), 0);
        }
        return outside * open - (outside - inside) * covered;
    }

    /** Whether other shadows may overlap a disc: those of discs from a place on, and of balls. */
    private boolean meetsOthers(Disc disc, int from) {
        if (disc.isAroundApex) {
            return true;
        }
        for (int i = from; i < count; i++) {
            if (discs[i].isAroundApex || !disc.ball.isApartFrom(discs[i].ball)) {
                return true;
            }
        }
        return !balls.areApartFrom(disc.ball);
    }

    /** What the shadows from a place on take of the part of a piece that a disc covers. */
    private double takenFromDisc(int piece, Disc disc, int from) {
        int mark = polygons.count();
        int polygon = polygons.addRegular(disc.middleX, disc.middleY, disc.radius,
            sides(disc.radius, polygons.area(piece)));
        int part = polygons.common(polygon, piece);
        double taken = polygons.area(part) - light(part, from, 1);
        polygons.dropTo(mark);
        return taken;
    }

    /**
     * Where the outline of a disc crosses that of another shadow, the area is off by up to a tenth of what lies between
     * one side of the polygon and its arc, about 2^-17 of the piece; all crossings of three balls came to less than
     * 2^-14 of the square. Where two outlines coincide, as those of twins do, every side counts, which came to less
     * than 2^-11 (both measured in {@code DiscShadowsTest}).
     */
    private static int sides(double radius, double area) {
        double sides = SIDES * Math.sqrt(radius / Math.sqrt(area));
        return (int) Math.max(FEWEST_SIDES, Math.min(sides, MOST_SIDES));
    }
}
