package raytracing.area;

import java.util.ArrayList;
import java.util.List;

/**
 * The shadows of balls that the plane cuts in a disc. On the inner side of a line, light passes differently in the disc and
 * around it; beyond the line, the ball may cast the shadow of its cone. This covers every such ball: in front of its tangent
 * circle it hides only what is in it, behind the circle the whole cone; and a ball around the apex, or with the apex on it,
 * hides everything on its side but what is in it. Not thread-safe.
 *
 * <p>The area of a disc in a convex piece has a closed form. Where shadows of other balls meet the same piece, a polygon
 * replaces the disc; this is rare, as a lamp seldom cuts the wall of a ball.
 */
public final class DiscShadows {
    /** Sides of the polygon for a disc whose radius is the width of the piece. */
    private static final int SIDES = 64;
    private static final int FEWEST_SIDES = 16;
    private static final int MOST_SIDES = 1 << 12;

    private final ConvexPolygons polygons;
    private final BallShadows balls;
    private double depth;
    private double scale;

    /** Of these, the first ones count; all are set anew for every query. */
    private final List<Disc> discs = new ArrayList<>();
    private int count;

    private static final class Disc {
        private final Conic outline = new Conic();
        private double middleX;
        private double middleY;
        private double radius;

        /** The inner side of this line is where the disc counts. */
        private double a;
        private double b;
        private double c;

        private double passing;
        private boolean isAroundApex;

        /** The ball whose cone counts beyond the line, unless the apex is in it. */
        private final BallShadow ball = new BallShadow();
    }

    DiscShadows(ConvexPolygons polygons, BallShadows balls) {
        this.polygons = polygons;
        this.balls = balls;
    }

    /** Removes all discs; other lengths will be multiplied by {@code lengthScale}, the depth already is. */
    void clear(double planeDepth, double lengthScale) {
        depth = planeDepth;
        scale = lengthScale;
        count = 0;
    }

    /**
     * Adds a ball around the apex, or with the apex on it: on the inner side of the line (a, b, c) it hides all but its disc,
     * which is given by centre and radius, at least 0; {@code passing} is the ball's transmittance, in [0, 1].
     */
    public void addAround(double x, double y, double radius, double passing, double a, double b, double c) {
        next(x, y, radius, passing, a, b, c).isAroundApex = true;
    }

    /**
     * Adds a ball that the plane cuts and that does not hold the apex. The line that separates disc and cone goes through the
     * two points where they touch. If there are none, one is wholly within the other, and only one of them counts.
     *
     * @param ballX of its centre, relative to the apex
     * @param radius of the disc in the plane, above 0
     * @param passing transmittance of the ball, in [0, 1]
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
        Disc disc = beforeLine >= reach ? next(ballX, ballY, radius, passing, 0, 0, 1)
            : next(ballX, ballY, radius, passing, -x, -y, (k - z * depth) / scale);
        disc.isAroundApex = false;
        disc.ball.set(x, y, z, r, passing, depth);
    }

    private Disc next(double x, double y, double radius, double passing, double a, double b, double c) {
        if (count == discs.size()) {
            discs.add(new Disc());
        }
        Disc disc = discs.get(count++);
        disc.middleX = scale * x;
        disc.middleY = scale * y;
        disc.radius = scale * radius;
        disc.outline.setDisc(disc.middleX, disc.middleY, disc.radius);
        disc.passing = passing;
        disc.a = a;
        disc.b = b;
        disc.c = scale * c;
        return disc;
    }

    /** The light of a piece that shines with some strength, past the discs from an index on and the balls. */
    double light(int piece, int index, double strength) {
        if (strength == 0) {
            return 0;
        }
        if (index == count) {
            return strength * Math.max(polygons.area(piece) - balls.takenLight(piece), 0);
        }
        Disc disc = discs.get(index);
        if (!disc.isAroundApex && disc.ball.side(polygons, piece) == Side.BEYOND) {
            return light(piece, index + 1, strength);
        }
        return switch (polygons.side(piece, disc.a, disc.b, disc.c)) {
            case WITHIN -> lightWithin(piece, disc, index + 1, strength);
            case BEYOND -> lightBeyond(piece, disc, index + 1, strength);
            case CUT -> {
                int mark = polygons.count();
                double light = lightWithin(polygons.cut(piece, disc.a, disc.b, disc.c), disc, index + 1, strength);
                polygons.dropTo(mark);
                light += lightBeyond(polygons.cut(piece, -disc.a, -disc.b, -disc.c), disc, index + 1, strength);
                polygons.dropTo(mark);
                yield light;
            }
        };
    }

    private double lightBeyond(int piece, Disc disc, int next, double strength) {
        if (disc.isAroundApex) {
            return light(piece, next, strength);
        }
        balls.push(disc.ball);
        double light = light(piece, next, strength);
        balls.pop();
        return light;
    }

    private double lightWithin(int piece, Disc disc, int next, double strength) {
        double passed = disc.passing * strength;
        double inside = disc.isAroundApex ? strength : passed;
        double outside = disc.isAroundApex ? passed : strength;
        double covered = disc.outline.area(polygons, piece);
        double open = light(piece, next, 1);
        if (covered > 0 && open < polygons.area(piece) && meetsOthers(disc, next)) {
            covered = Math.max(covered - takenFromDisc(piece, disc, next), 0);
        }
        return outside * open - (outside - inside) * covered;
    }

    /** Whether other shadows may overlap a disc: those of the discs from an index on, and of balls. */
    private boolean meetsOthers(Disc disc, int from) {
        if (disc.isAroundApex) {
            return true;
        }
        for (int i = from; i < count; i++) {
            Disc other = discs.get(i);
            if (other.isAroundApex || !disc.ball.isApartFrom(other.ball)) {
                return true;
            }
        }
        return !balls.areApartFrom(disc.ball);
    }

    /** The light that the shadows from an index on take from the part of a piece that a disc covers. */
    private double takenFromDisc(int piece, Disc disc, int from) {
        int mark = polygons.count();
        int sides = sides(disc.radius, polygons.area(piece));
        int part = polygons.common(polygons.addRegular(disc.middleX, disc.middleY, disc.radius, sides), piece);
        double taken = polygons.area(part) - light(part, from, 1);
        polygons.dropTo(mark);
        return taken;
    }

    /**
     * The number of the polygon's sides. Where the outline of a disc crosses that of another shadow, the area is off by up
     * to a tenth of the area between one side of the polygon and its arc, about 2^-17 of the piece; all crossings of three
     * balls came to less than 2^-14 of the square. Where two outlines coincide, as those of equal balls do, every side
     * counts, which came to less than 2^-11 (both measured in {@code DiscShadowsTest}).
     */
    private static int sides(double radius, double area) {
        double sides = SIDES * Math.sqrt(radius / Math.sqrt(area));
        return (int) Math.max(FEWEST_SIDES, Math.min(sides, MOST_SIDES));
    }
}
