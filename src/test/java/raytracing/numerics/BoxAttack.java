package raytracing.numerics;

import java.util.List;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/** Rays at boxes that look for the weak places of a kernel. */
final class BoxAttack {
    static final List<Family> FAMILIES = List.of(
        // edge about 10^-3, box and origin about 10^12 away from the world's origin
        new Attack(Shape.BOX, "small and far from the world's origin", BoxAttack::farAndSmall),
        // through an edge or a corner exactly, or but for a few ulps of one number
        new Attack(Shape.BOX, "through an edge but for ulps", BoxAttack::edgeButForUlps),
        // along a face, an edge or through a corner of a grid of tenths
        new Attack(Shape.BOX, "a grid of tenths", BoxAttack::tenths),
        // origin exactly on a face, an edge or a corner, or but for a few ulps of one number
        new Attack(Shape.BOX, "on the box but for ulps", BoxAttack::onButForUlps),
        // a part of the direction is below 10^-300, down to the smallest double
        new Attack(Shape.BOX, "subnormal part of the direction", BoxAttack::subnormalPart),
        // edge and distance each between 2^-60 and 2^60
        new Attack(Shape.BOX, "mixed sizes", BoxAttack::mixed),
        // direction 10^-160 to 10^160 long
        new Attack(Shape.BOX, "any length of the direction", BoxAttack::speed),
        // all lengths times 10^-200 to 10^200, and the direction
        new Attack(Shape.BOX, "any unit of length", BoxAttack::units),
        // all parts of the direction are subnormal, all lengths so small that crossings are not
        new Attack(Shape.BOX, "subnormal direction", BoxAttack::slow),
        // crossings at the ends of the doubles and beyond
        new Attack(Shape.BOX, "crossings at the ends of the range", BoxAttack::ends));

    private BoxAttack() {
    }

    private static Query around(RandomNumbers random, Vector point, double edge, double halfEdges, Line line) {
        return line.with(Vectors.plus(point, edge / 2, random.vector(halfEdges)), edge);
    }

    private static Query ordinary(RandomNumbers random, Line line) {
        return around(random, line.at(random.between(-5, 20)), random.magnitude(0, 3), 1.8, line);
    }

    private static Query farAndSmall(RandomNumbers random, Line line) {
        Vector place = random.direction().times(random.magnitude(38, 42));
        Line far = new Line(Vectors.plus(line.origin(), place), line.direction());
        double edge = random.magnitude(-12, -8);
        return around(random, far.at(random.between(1, 20)), edge, random.oneIn(2) ? 1.2 : 0x1p5, far);
    }

    /** A corner, or a point of an edge, or of a face: as many parts of the way to the centre are half an edge long. */
    private static Vector towardsCentre(RandomNumbers random, double half) {
        Vector corner = new Vector(random.sign() * half, random.sign() * half, random.sign() * half);
        Vector edge = Axes.withPart(corner, random.axis(), random.whole(7) * half / 8);
        return random.oneIn(3) ? corner : random.oneIn(2) ? edge
            : Axes.withPart(edge, random.axis(), random.whole(7) * half / 8);
    }

    private static Query edgeButForUlps(RandomNumbers random, Line unused) {
        Line line = new Line(random.eighths(8), random.eighths(1));
        double edge = random.powerOfTwo(-3, 4);
        Vector point = line.at(random.powerOfTwo(-3, 7));
        return random.besideByUlps(line.with(Vectors.plus(point, towardsCentre(random, edge / 2)), edge));
    }

    private static Query onButForUlps(RandomNumbers random, Line line) {
        Vector origin = random.eighths(8);
        double edge = random.powerOfTwo(-3, 4);
        Vector direction = switch (random.random().nextInt(3)) {
            case 0 -> line.direction();
            case 1 -> Axes.withPart(line.direction(), random.axis(), random.zero());
            default -> Axes.withPart(line.direction(), random.axis(), random.sign() * random.magnitude(-1074, -40));
        };
        return random.besideByUlps(new Query(origin, direction, Vectors.plus(origin, towardsCentre(random, edge / 2)), edge));
    }

    private static Query tenths(RandomNumbers random, Line unused) {
        return new Query(tenths(random, 9), tenths(random, 3), tenths(random, 9), random.random().nextInt(1, 9) / 10.0);
    }

    private static Vector tenths(RandomNumbers random, int most) {
        Vector wholes = random.wholes(most);
        return new Vector(wholes.x() / 10, wholes.y() / 10, wholes.z() / 10);
    }

    private static Query subnormalPart(RandomNumbers random, Line line) {
        int axis = random.axis();
        Vector direction = Axes.withPart(line.direction(), axis, random.sign() * random.magnitude(-1074, -1000));
        Query query = ordinary(random, line).withDirection(direction);
        double onFace = Axes.part(line.origin(), axis) + random.sign() * query.scalar() / 2;
        return random.oneIn(2) ? query : query.withVector(Axes.withPart(query.vector(), axis, onFace));
    }

    private static Query mixed(RandomNumbers random, Line line) {
        Line fromAnywhere = new Line(line.origin().times(random.magnitude(-60, 60)), line.direction());
        return around(random, fromAnywhere.at(random.sign() * random.magnitude(-60, 60)), random.magnitude(-60, 60), 1.5,
            fromAnywhere);
    }

    private static Query ordinaryOrHard(RandomNumbers random, Line line) {
        return random.oneIn(3) ? edgeButForUlps(random, line) : ordinary(random, line);
    }

    private static Query speed(RandomNumbers random, Line line) {
        Query query = ordinaryOrHard(random, line);
        return query.withDirection(query.direction().times(random.magnitude(-531, 531)));
    }

    private static Query units(RandomNumbers random, Line line) {
        double lengths = random.powerOfTwo(-640, 640);
        double speed = random.magnitude(-300, 300);
        return ordinaryOrHard(random, line).inUnits(lengths, speed);
    }

    private static Query slow(RandomNumbers random, Line line) {
        double speed = random.powerOfTwo(-1060, -1022);
        Query query = ordinaryOrHard(random, line).inUnits(0x1p-80, speed);
        return query.direction().isZero() ? slow(random, line) : query;
    }

    private static Query ends(RandomNumbers random, Line line) {
        boolean isSmall = random.oneIn(2);
        double lengths = isSmall ? random.powerOfTwo(-320, -270) : random.powerOfTwo(270, 320);
        double speed = isSmall ? random.magnitude(720, 820) : random.magnitude(-820, -720);
        return ordinaryOrHard(random, line).inUnits(lengths, speed);
    }
}
