package raytracing.numerics;

import java.util.List;
import raytracing.math.Vector;

/** Rays at planes that look for the weak places of a kernel. */
final class PlaneAttack {
    static final List<Family> FAMILIES = List.of(
        // normal 10^-200 to 10^200 long
        new Attack(Shape.PLANE, "any length of the normal", PlaneAttack::normals),
        // offset 0
        new Attack(Shape.PLANE, "through the world's origin", PlaneAttack::throughTheOrigin),
        // origin exactly on it, or but for a few ulps of one number
        new Attack(Shape.PLANE, "on the plane but for ulps", PlaneAttack::onButForUlps),
        // direction exactly along it, or but for a few ulps of one number
        new Attack(Shape.PLANE, "along the plane but for ulps", PlaneAttack::alongButForUlps),
        // a part of the direction is below 10^-20, down to the smallest double
        new Attack(Shape.PLANE, "tiny part of the direction", PlaneAttack::tinyPart),
        // every number with a size of its own
        new Attack(Shape.PLANE, "mixed sizes", PlaneAttack::mixed),
        // direction 10^-160 to 10^160 long
        new Attack(Shape.PLANE, "any length of the direction", PlaneAttack::speed),
        // crossings at the ends of the doubles and beyond
        new Attack(Shape.PLANE, "crossings at the ends of the range", PlaneAttack::ends));

    /** Products of such numbers, and sums of three, are exact. */
    private static final int LARGEST_WHOLE = 1 << 25;

    private PlaneAttack() {
    }

    private static Query ordinary(RandomNumbers random, Line line) {
        Vector normal = random.direction();
        return line.with(normal, normal.dot(line.at(random.sign() * random.between(1, 20))));
    }

    private static Query scaledNormal(Query query, double factor) {
        return new Query(query.origin(), query.direction(), query.vector().times(factor), query.scalar() * factor);
    }

    private static Query normals(RandomNumbers random, Line line) {
        Query query = random.oneIn(3) ? onButForUlps(random, line) : ordinary(random, line);
        return scaledNormal(query, random.magnitude(-664, 640));
    }

    private static Query throughTheOrigin(RandomNumbers random, Line line) {
        Vector normal = random.oneIn(2) ? random.direction() : random.wholes(9);
        Vector onPlane = normal.cross(random.wholes(9));
        Vector origin = random.oneIn(2) ? random.beside(onPlane, 2) : line.origin();
        return new Query(origin, line.direction(), normal, random.zero());
    }

    private static Query onButForUlps(RandomNumbers random, Line line) {
        Vector normal = random.wholes(LARGEST_WHOLE);
        Vector origin = random.wholes(LARGEST_WHOLE);
        Query on = new Query(origin, line.direction(), normal, normal.dot(origin));
        return switch (random.random().nextInt(5)) {
            case 0 -> new Query(random.beside(origin, 3), on.direction(), normal, on.scalar());
            case 1 -> on.withVector(random.beside(normal, 3));
            case 2 -> new Query(origin, on.direction(), normal, random.beside(on.scalar(), 3));
            default -> on;
        };
    }

    private static Query alongButForUlps(RandomNumbers random, Line line) {
        Vector normal = random.wholes(1 << 12);
        Vector direction = Pythagorean.perpendicularTo(normal, random);
        Query along = new Query(line.origin(), direction, normal, random.between(-10, 10) * normal.largestPart());
        return switch (random.random().nextInt(4)) {
            case 0 -> along;
            case 1 -> along.withVector(random.beside(normal, 3));
            default -> along.withDirection(random.beside(direction, 3));
        };
    }

    private static Query tinyPart(RandomNumbers random, Line line) {
        int axis = random.axis();
        Vector direction = Axes.withPart(line.direction(), axis, random.sign() * random.magnitude(-1074, -66));
        Query query = ordinary(random, line).withDirection(direction);
        return random.oneIn(2) ? query
            : query.withVector(Axes.withPart(Vector.ZERO, axis, random.sign() * random.magnitude(-10, 10)));
    }

    private static Query mixed(RandomNumbers random, Line unused) {
        Vector origin = anySizes(random);
        Vector normal = anySizes(random);
        double near = normal.dot(origin) * (1 + random.sign() * random.magnitude(-52, -1));
        double offset = random.oneIn(2) ? near : random.sign() * random.magnitude(-60, 60);
        return new Query(origin, anySizes(random), normal, offset);
    }

    private static Vector anySizes(RandomNumbers random) {
        return new Vector(random.sign() * random.magnitude(-60, 60), random.sign() * random.magnitude(-60, 60),
            random.sign() * random.magnitude(-60, 60));
    }

    private static Query speed(RandomNumbers random, Line line) {
        Query query = random.oneIn(3) ? alongButForUlps(random, line) : ordinary(random, line);
        return query.withDirection(query.direction().times(random.magnitude(-531, 531)));
    }

    private static Query ends(RandomNumbers random, Line line) {
        Query query = random.oneIn(3) ? onButForUlps(random, line) : ordinary(random, line);
        boolean isSmall = random.oneIn(2);
        double lengths = isSmall ? random.powerOfTwo(-320, -270) : random.powerOfTwo(270, 320);
        double speed = isSmall ? random.magnitude(720, 820) : random.magnitude(-820, -720);
        double normals = random.powerOfTwo(-300, 300);
        return new Query(query.origin().times(lengths), query.direction().times(speed), query.vector().times(normals),
            query.scalar() * lengths * normals);
    }
}
