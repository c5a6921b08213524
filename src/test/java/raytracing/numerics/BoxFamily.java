package raytracing.numerics;

import raytracing.math.Vector;
import raytracing.math.Vectors;

/** Rays and boxes. Unless it says otherwise: a unit direction, coordinates up to about 30, edge 1 to 8. */
public enum BoxFamily implements Family {
    ORDINARY("ordinary", new Recipe(16, RandomNumbers::line, BoxFamily::ordinary)),
    /** Along an axis, with zeros of both signs. */
    AXIS("along an axis", new Recipe(1, BoxFamily::axisLine, BoxFamily::ordinary)),
    /** In the plane of a face, or an ulp beside it. */
    IN_A_FACE("in a face's plane", new Recipe(1, BoxFamily::levelLine, BoxFamily::inAFace)),
    /** Through a point of an edge: exactly for half of the rays, for the others but for rounding. */
    EDGE("through an edge", new Recipe(1, BoxFamily::roundLine, BoxFamily::edge)),
    /** Through a corner, likewise. */
    CORNER("through a corner", new Recipe(1, BoxFamily::roundLine, BoxFamily::corner)),
    /** Origin on a face but for rounding. */
    ON_A_FACE("on a face", new Recipe(1, RandomNumbers::line, BoxFamily::onAFace)),
    INSIDE("inside", new Recipe(1, RandomNumbers::line, BoxFamily::inside)),
    /** Edge 10^-8 to 10^-2, 10^3 to 10^8 edges away. */
    TINY_AND_FAR("tiny and far away", new Recipe(1, RandomNumbers::line, BoxFamily::tinyAndFar)),
    /** Edge 10^4 to 10^12, a face 10^-1 to 30 ahead. */
    HUGE("huge", new Recipe(1, RandomNumbers::line, BoxFamily::huge)),
    /** A part of the direction is 10^-20 or less, down to the smallest double. */
    TINY_DIRECTION("tiny part of the direction", new Recipe(1, BoxFamily::nearlyLevelLine, BoxFamily::tinyDirection)),
    /** Both 10^3 to 10^8 from the world's origin. */
    OFFSET("far from the world's origin", new Recipe(1, BoxFamily::farLine, BoxFamily::ordinary));

    private final String title;
    private final Recipe recipe;

    BoxFamily(String title, Recipe recipe) {
        this.title = title;
        this.recipe = recipe;
    }

    @Override
    public Shape shape() {
        return Shape.BOX;
    }

    @Override
    public String title() {
        return title;
    }

    @Override
    public Recipe recipe() {
        return recipe;
    }

    private static Line farLine(RandomNumbers random) {
        Line line = random.line();
        return new Line(Vectors.plus(line.origin(), random.magnitude(10, 27), random.direction()), line.direction());
    }

    private static Line axisLine(RandomNumbers random) {
        Vector zeros = new Vector(random.zero(), random.zero(), random.zero());
        return new Line(random.vector(10), Axes.withPart(zeros, random.axis(), random.sign()));
    }

    private static Line levelLine(RandomNumbers random) {
        return new Line(random.vector(10), Axes.withPart(random.direction(), random.axis(), random.zero()));
    }

    private static Line nearlyLevelLine(RandomNumbers random) {
        double smallPart = random.sign() * random.magnitude(-1074, -66);
        return new Line(random.vector(10), Axes.withPart(random.direction(), random.axis(), smallPart));
    }

    /** Half of these lines have so few digits that their points are exact. */
    private static Line roundLine(RandomNumbers random) {
        return random.oneIn(2) ? new Line(random.eighths(8), random.eighths(1)) : random.line();
    }

    /** A box around a point that lies beside its middle by up to so many half edges. */
    private static Query around(RandomNumbers random, Vector point, double edge, double halfEdges, Line line) {
        return line.with(Vectors.plus(point, edge / 2, random.vector(halfEdges)), edge);
    }

    private static Query ordinary(RandomNumbers random, Line line) {
        return around(random, line.at(random.between(7, 20)), random.magnitude(0, 3), 1.8, line);
    }

    /** Moves a box along an axis until the origin lies in the plane of one of its faces. */
    private static Query withOriginInAFacesPlane(RandomNumbers random, Query query, int axis) {
        double centre = Axes.part(query.origin(), axis) + random.sign() * query.scalar() / 2;
        return query.withVector(Axes.withPart(query.vector(), axis, centre));
    }

    private static int axisOfLeastChange(Line line) {
        Vector d = line.direction();
        if (Math.abs(d.x()) < Math.abs(d.y()) && Math.abs(d.x()) < Math.abs(d.z())) {
            return 0;
        }
        return Math.abs(d.y()) < Math.abs(d.z()) ? 1 : 2;
    }

    private static Query inAFace(RandomNumbers random, Line line) {
        int axis = axisOfLeastChange(line);
        Query inside = withOriginInAFacesPlane(random, ordinary(random, line), axis);
        double centre = Axes.part(inside.vector(), axis);
        double beside = random.oneIn(2) ? centre : centre + random.sign() * Math.ulp(centre);
        return inside.withVector(Axes.withPart(inside.vector(), axis, beside));
    }

    private static Query edge(RandomNumbers random, Line line) {
        return edgeOrCorner(random, line, Axes.withPart(signs(random), random.axis(), random.between(-1, 1)));
    }

    private static Query corner(RandomNumbers random, Line line) {
        return edgeOrCorner(random, line, signs(random));
    }

    private static Vector signs(RandomNumbers random) {
        return new Vector(random.sign(), random.sign(), random.sign());
    }

    private static Query edgeOrCorner(RandomNumbers random, Line line, Vector halfEdgesToTheCentre) {
        double edge = random.powerOfTwo(0, 3);
        return line.with(Vectors.plus(line.at(random.powerOfTwo(1, 5)), edge / 2, halfEdgesToTheCentre), edge);
    }

    private static Query onAFace(RandomNumbers random, Line line) {
        Query inside = around(random, line.origin(), random.magnitude(0, 3), 1, line);
        return withOriginInAFacesPlane(random, inside, random.axis());
    }

    private static Query inside(RandomNumbers random, Line line) {
        return around(random, line.origin(), random.magnitude(0, 3), 1, line);
    }

    private static Query tinyAndFar(RandomNumbers random, Line line) {
        double edge = random.magnitude(-26, -7);
        return around(random, line.at(edge * random.magnitude(10, 26)), edge, 2, line);
    }

    private static Query huge(RandomNumbers random, Line line) {
        double edge = random.magnitude(13, 40);
        int axis = random.axis();
        Query beside = around(random, line.origin(), edge, 1.25, line);
        double height = random.magnitude(-3, 5);
        double centre = Axes.part(line.origin(), axis) + random.sign() * (edge / 2 + height);
        return beside.withVector(Axes.withPart(beside.vector(), axis, centre));
    }

    private static Query tinyDirection(RandomNumbers random, Line line) {
        Query beside = ordinary(random, line);
        return random.oneIn(2) ? beside : withOriginInAFacesPlane(random, beside, axisOfLeastChange(line));
    }
}
