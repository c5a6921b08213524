package raytracing.numerics;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.stream.Stream;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/** Rays and triangles. Unless it says otherwise: a unit direction, coordinates up to about 30, edges of about 4. */
enum TriangleFamily {
    ORDINARY("ordinary", TriangleFamily::ordinary),
    /** The origin is so near the plane that the ray runs along it but for 2^-50 to 2^-10. */
    GRAZING("grazing", TriangleFamily::grazing),
    /** In the plane, exactly or but for some ulps of the direction, or from a point that is some ulps off it. */
    IN_ITS_PLANE("along the plane but for ulps", TriangleFamily::inItsPlane),
    /** Through a point of an edge, without any rounding. */
    EDGE("through an edge", random -> through(random, TriangleFamily::onAnEdge)),
    /** The same, with one number moved by up to three units in its last place. */
    EDGE_BUT_FOR_ULPS("through an edge but for ulps", random -> butForUlps(random, through(random, TriangleFamily::onAnEdge))),
    /** Towards a point of an edge that is rounded. */
    ROUNDED_EDGE("through a rounded point of an edge", TriangleFamily::roundedEdge),
    /** Through a corner, without any rounding. */
    CORNER("through a corner", random -> through(random, TriangleFamily::atACorner)),
    CORNER_BUT_FOR_ULPS("through a corner but for ulps",
        random -> butForUlps(random, through(random, TriangleFamily::atACorner))),
    /** A length is 2^3 to 2^50 widths. */
    NEEDLE("needles", TriangleFamily::needle),
    /** 2^10 to 2^26 edges away. */
    FAR("far away", TriangleFamily::farAway),
    /** Edges of 2^-26 to 2^-7. */
    TINY("tiny", TriangleFamily::tiny),
    /** Edges of 2^13 to 2^40, the plane 2^-3 to 2^5 away. */
    HUGE("huge", TriangleFamily::huge),
    /** Origin on the plane but for rounding, in the triangle or beside it. */
    ON_THE_PLANE("on the plane", TriangleFamily::onThePlane),
    /** Origin in the triangle, on an edge or a corner, exactly or but for ulps. */
    ON_IT("on the triangle but for ulps", TriangleFamily::onIt),
    /** Half a square face of a box, from and to points of a grid of tenths. */
    GRID("half a face in a grid of tenths", TriangleFamily::grid),
    /** A part of the direction is below 2^-66, down to the smallest double. */
    TINY_DIRECTION("tiny part of the direction", TriangleFamily::tinyDirection),
    /** Both 2^10 to 2^30 from the world's origin. */
    OFFSET("far from the world's origin", TriangleFamily::offset),
    /** All corners and the origin differ in size by up to 2^60. */
    MIXED("mixed sizes", TriangleFamily::mixed),
    /** All lengths times 2^-640 to 2^640, the direction times 2^-300 to 2^300. */
    ANY_UNIT("any unit of length", TriangleFamily::anyUnit),
    /** Crossings, and products on the way to them, at the ends of the doubles and beyond. */
    ENDS("at the ends of the range", TriangleFamily::ends);

    private final String title;
    private final Function<RandomNumbers, TriangleQuery> recipe;

    TriangleFamily(String title, Function<RandomNumbers, TriangleQuery> recipe) {
        this.title = title;
        this.recipe = recipe;
    }

    /** In words, for a table. */
    String title() {
        return title;
    }

    /** Without an end, the same for the same seed on every machine. */
    Stream<TriangleQuery> endless(long seed) {
        RandomNumbers random = new RandomNumbers(new SplittableRandom(seed));
        return Stream.generate(() -> recipe.apply(random)).filter(TriangleQuery::isValid);
    }

    List<TriangleQuery> queries(long seed, int count) {
        return endless(seed).limit(count).toList();
    }

    /** A point of the triangle's plane, by how far it is along two edges; inside for half of the points. */
    private static Vector target(RandomNumbers random, Vector a, Vector b, Vector c) {
        return at(a, b, c, random.between(-0.2, 0.8), random.between(-0.2, 0.8));
    }

    private static Vector at(Vector a, Vector b, Vector c, double alongAb, double alongAc) {
        return Vectors.plus(Vectors.plus(a, alongAb, b.minus(a)), alongAc, c.minus(a));
    }

    private static TriangleQuery aimed(RandomNumbers random, Vector origin, Vector a, Vector b, Vector c) {
        return new TriangleQuery(origin, target(random, a, b, c).minus(origin).unit(), a, b, c);
    }

    private static TriangleQuery ordinary(RandomNumbers random) {
        return around(random, random.vector(10), random.vector(20), 4);
    }

    private static TriangleQuery around(RandomNumbers random, Vector origin, Vector middle, double size) {
        return aimed(random, origin, Vectors.plus(middle, random.vector(size)), Vectors.plus(middle, random.vector(size)),
            Vectors.plus(middle, random.vector(size)));
    }

    private static TriangleQuery grazing(RandomNumbers random) {
        TriangleQuery query = ordinary(random);
        Vector normal = query.b().minus(query.a()).cross(query.c().minus(query.a())).unit();
        Vector inPlane = at(query.a(), query.b(), query.c(), random.between(-9, 9), random.between(-9, 9));
        double height = random.sign() * random.magnitude(-50, -10);
        return aimed(random, Vectors.plus(inPlane, height, normal), query.a(), query.b(), query.c());
    }

    private static TriangleQuery inItsPlane(RandomNumbers random) {
        Vector a = random.eighths(4);
        Vector b = Vectors.plus(a, random.eighths(4));
        Vector c = Vectors.plus(a, random.eighths(4));
        Vector inPlane = at(a, b, c, random.whole(9), random.whole(9));
        Vector target = at(a, b, c, random.random().nextInt(-2, 9) / 16.0, random.random().nextInt(-2, 9) / 16.0);
        Vector along = target.minus(inPlane);
        Vector beside = random.beside(inPlane, 9);
        TriangleQuery query = new TriangleQuery(inPlane, along, a, b, c);
        return switch (random.random().nextInt(4)) {
            case 0 -> query;
            case 1 -> query.withDirection(random.beside(along, 1));
            default -> query.withOrigin(beside).withDirection(target.minus(beside));
        };
    }

    /** What lies around a point that a ray goes through. */
    @FunctionalInterface
    private interface Around {
        TriangleQuery triangle(RandomNumbers random, Line line, Vector point);
    }

    /** The line's points have so few digits that they are exact. */
    private static TriangleQuery through(RandomNumbers random, Around around) {
        Line line = new Line(random.eighths(8), random.oneIn(4) ? random.wholes(8).times(0.125) : random.eighths(1));
        Vector point = line.at(random.sign() * random.powerOfTwo(-2, 6));
        return around.triangle(random, line, random.oneIn(4) ? line.at(random.powerOfTwo(-2, 6)) : point)
            .renamed(random.random().nextInt(6));
    }

    private static TriangleQuery onAnEdge(RandomNumbers random, Line line, Vector point) {
        Vector along = random.wholes(9).times(random.powerOfTwo(-3, 2));
        return new TriangleQuery(line.origin(), line.direction(), Vectors.plus(point, random.random().nextInt(1, 9), along),
            Vectors.plus(point, -random.random().nextInt(1, 9), along),
            Vectors.plus(point, random.wholes(99).times(random.powerOfTwo(-5, 2))));
    }

    private static TriangleQuery atACorner(RandomNumbers random, Line line, Vector point) {
        return new TriangleQuery(line.origin(), line.direction(), point,
            Vectors.plus(point, random.wholes(99).times(random.powerOfTwo(-5, 2))),
            Vectors.plus(point, random.wholes(99).times(random.powerOfTwo(-5, 2))));
    }

    private static TriangleQuery butForUlps(RandomNumbers random, TriangleQuery query) {
        return switch (random.random().nextInt(5)) {
            case 0 -> query.withOrigin(random.beside(query.origin(), 3));
            case 1 -> query.withDirection(random.beside(query.direction(), 3));
            case 2 -> new TriangleQuery(query.origin(), query.direction(), random.beside(query.a(), 3), query.b(), query.c());
            case 3 -> new TriangleQuery(query.origin(), query.direction(), query.a(), random.beside(query.b(), 3), query.c());
            default -> new TriangleQuery(query.origin(), query.direction(), query.a(), query.b(), random.beside(query.c(), 3));
        };
    }

    private static TriangleQuery roundedEdge(RandomNumbers random) {
        TriangleQuery query = ordinary(random).renamed(random.random().nextInt(6));
        Vector point = Vectors.plus(query.a(), random.between(0, 1), query.b().minus(query.a()));
        Vector way = point.minus(query.origin());
        return query.withDirection(random.oneIn(2) ? way : way.unit());
    }

    private static TriangleQuery needle(RandomNumbers random) {
        Vector a = random.vector(20);
        Vector along = random.direction().times(random.between(0.5, 8));
        Vector aside = random.perpendicularTo(along).times(random.magnitude(-50, -3));
        Vector c = Vectors.plus(Vectors.plus(a, random.between(-0.2, 1.2), along), aside);
        return aimed(random, random.vector(10), a, Vectors.plus(a, along), c).renamed(random.random().nextInt(6));
    }

    private static TriangleQuery farAway(RandomNumbers random) {
        Line line = random.line();
        return around(random, line.origin(), line.at(random.magnitude(12, 28)), 4);
    }

    private static TriangleQuery tiny(RandomNumbers random) {
        return around(random, random.vector(10), random.vector(20), random.magnitude(-26, -7));
    }

    private static TriangleQuery huge(RandomNumbers random) {
        double size = random.magnitude(13, 40);
        TriangleQuery far = around(random, Vector.ZERO, Vector.ZERO, size);
        Vector normal = far.b().minus(far.a()).cross(far.c().minus(far.a())).unit();
        Vector below = target(random, far.a(), far.b(), far.c());
        Vector origin = Vectors.plus(below, random.sign() * random.magnitude(-3, 5), normal);
        return far.withOrigin(origin).withDirection(random.direction());
    }

    private static TriangleQuery onThePlane(RandomNumbers random) {
        TriangleQuery query = ordinary(random);
        Vector origin = at(query.a(), query.b(), query.c(), random.between(-1, 1), random.between(-1, 1));
        return random.oneIn(2) ? query.withOrigin(origin) : aimed(random, origin, query.a(), query.b(), query.c());
    }

    private static TriangleQuery onIt(RandomNumbers random) {
        Vector a = random.eighths(8);
        Vector b = Vectors.plus(a, 8, random.eighths(1));
        Vector c = Vectors.plus(a, 8, random.eighths(1));
        double alongAb = random.random().nextInt(9) / 8.0;
        double alongAc = random.oneIn(2) ? 0 : random.random().nextInt(9) / 8.0 * (1 - alongAb);
        TriangleQuery query = new TriangleQuery(at(a, b, c, alongAb, alongAc), random.direction(), a, b, c);
        return butForUlps(random, query).renamed(random.random().nextInt(6));
    }

    private static TriangleQuery grid(RandomNumbers random) {
        int axis = random.axis();
        Vector a = tenths(random, 9);
        double edge = random.random().nextInt(1, 9) / 10.0;
        Vector b = Axes.withPart(a, (axis + 1) % 3, Axes.part(a, (axis + 1) % 3) + edge);
        Vector c = Axes.withPart(random.oneIn(2) ? a : b, (axis + 2) % 3, Axes.part(a, (axis + 2) % 3) + edge);
        Vector through = at(a, b, c, random.random().nextInt(5) / 4.0, random.random().nextInt(5) / 4.0);
        Vector direction = random.oneIn(2) ? tenths(random, 3) : Axes.withPart(Vector.ZERO, axis, random.sign());
        Vector origin = Vectors.plus(through, -random.random().nextInt(1, 9), direction);
        return new TriangleQuery(origin, direction, a, b, c).renamed(random.random().nextInt(6));
    }

    private static Vector tenths(RandomNumbers random, int most) {
        Vector wholes = random.wholes(most);
        return new Vector(wholes.x() / 10, wholes.y() / 10, wholes.z() / 10);
    }

    private static TriangleQuery tinyDirection(RandomNumbers random) {
        int axis = random.axis();
        TriangleQuery query = ordinary(random);
        Vector target = target(random, query.a(), query.b(), query.c());
        Vector level = Axes.withPart(query.origin(), axis, Axes.part(target, axis));
        double part = random.sign() * random.magnitude(-1074, -66);
        return query.withOrigin(level).withDirection(Axes.withPart(target.minus(level).unit(), axis, part));
    }

    private static TriangleQuery offset(RandomNumbers random) {
        Vector place = random.direction().times(random.magnitude(10, 30));
        return around(random, Vectors.plus(place, random.vector(10)), Vectors.plus(place, random.vector(20)), 4);
    }

    private static TriangleQuery mixed(RandomNumbers random) {
        return aimed(random, random.direction().times(random.magnitude(-30, 30)),
            random.direction().times(random.magnitude(-30, 30)), random.direction().times(random.magnitude(-30, 30)),
            random.direction().times(random.magnitude(-30, 30)));
    }

    private static TriangleQuery ordinaryOrHard(RandomNumbers random) {
        return random.oneIn(3) ? butForUlps(random, through(random, TriangleFamily::onAnEdge)) : ordinary(random);
    }

    private static TriangleQuery anyUnit(RandomNumbers random) {
        return ordinaryOrHard(random).inUnits(random.powerOfTwo(-640, 640), random.magnitude(-300, 300));
    }

    private static TriangleQuery ends(RandomNumbers random) {
        return switch (random.random().nextInt(5)) {
            case 0 -> ordinaryOrHard(random).inUnits(random.powerOfTwo(-320, -270), random.magnitude(720, 820));
            case 1 -> ordinaryOrHard(random).inUnits(random.powerOfTwo(270, 320), random.magnitude(-820, -720));
            case 2 -> ordinaryOrHard(random).inUnits(random.powerOfTwo(-1070, -1000), random.magnitude(-1070, -1000));
            case 3 -> ordinaryOrHard(random).inUnits(random.powerOfTwo(1000, 1018), random.magnitude(-40, 1020));
            default -> ordinaryOrHard(random).inUnits(random.powerOfTwo(-40, 40), random.magnitude(-1060, 1018));
        };
    }
}
