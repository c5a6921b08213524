package raytracing.numerics;

import java.util.List;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/** Rays at spheres that look for the weak places of a kernel. */
final class SphereAttack {
    static final List<Family> FAMILIES = List.of(
        // from 2^30 to 2^100 radii away, past the world's origin without a rounding; closest approach r (1 -/+ 2^-50 to 1/2)
        new Attack(Shape.SPHERE, "grazing from afar", SphereAttack::distantGraze),
        // touching exactly, or but for a few ulps of one number
        new Attack(Shape.SPHERE, "touching but for ulps", SphereAttack::tangent),
        // the same from up to 2^40 away
        new Attack(Shape.SPHERE, "touching but for ulps, from afar", SphereAttack::distantTangent),
        // origin exactly on the sphere, or but for a few ulps of one number
        new Attack(Shape.SPHERE, "on the sphere but for ulps", SphereAttack::onButForUlps),
        // inside, next to the wall, and nearly along it
        new Attack(Shape.SPHERE, "along the inner wall", SphereAttack::alongTheWall),
        // a part of the direction is below 10^-20, down to the smallest double
        new Attack(Shape.SPHERE, "tiny part of the direction", SphereAttack::tinyPart),
        // radius and distance each between 2^-60 and 2^60
        new Attack(Shape.SPHERE, "mixed sizes", SphereAttack::mixed),
        // direction 10^-160 to 10^160 long
        new Attack(Shape.SPHERE, "any length of the direction", SphereAttack::speed),
        // all lengths times 10^-90 to 10^90, and then the direction
        new Attack(Shape.SPHERE, "any unit of length", SphereAttack::units),
        // all parts of the direction are subnormal, all lengths so small that crossings are not
        new Attack(Shape.SPHERE, "subnormal direction", SphereAttack::slow),
        // crossings at the ends of the doubles and beyond
        new Attack(Shape.SPHERE, "crossings at the ends of the range", SphereAttack::ends));

    private SphereAttack() {
    }

    private static Query distantGraze(RandomNumbers random, Line line) {
        double radius = random.magnitude(-20, 20);
        Vector origin = line.direction().times(radius * random.magnitude(30, 100));
        double part = 1 + random.sign() * random.magnitude(-50, -1);
        Vector centre = random.perpendicularTo(line.direction()).times(radius * part);
        return new Query(origin, origin.times(-random.powerOfTwo(-100, 10)), centre, radius);
    }

    private static Query tangent(RandomNumbers random, Line unused) {
        return tangentFrom(random, random.powerOfTwo(-3, 5));
    }

    private static Query distantTangent(RandomNumbers random, Line unused) {
        return tangentFrom(random, random.powerOfTwo(5, 41));
    }

    private static Query tangentFrom(RandomNumbers random, double steps) {
        Vector towardsContact = Pythagorean.vector(random);
        Vector direction = Pythagorean.perpendicularTo(towardsContact, random);
        Vector centre = random.eighths(16);
        Vector origin = Vectors.plus(Vectors.plus(centre, towardsContact), -steps, direction);
        return random.besideByUlps(new Query(origin, direction, centre, towardsContact.length()));
    }

    private static Query onButForUlps(RandomNumbers random, Line line) {
        Vector outward = Pythagorean.vector(random);
        Vector centre = random.eighths(16);
        Vector direction = random.oneIn(2) ? Pythagorean.perpendicularTo(outward, random) : line.direction();
        return random.besideByUlps(new Query(Vectors.plus(centre, outward), direction, centre, outward.length()));
    }

    private static Query alongTheWall(RandomNumbers random, Line line) {
        double radius = random.magnitude(-1, 2);
        Vector outward = random.perpendicularTo(line.direction());
        Vector origin = outward.times(radius * (1 - random.magnitude(-52, -20)));
        Vector direction = Vectors.plus(line.direction(), random.sign() * random.magnitude(-60, -2), outward);
        return new Query(origin, direction, random.oneIn(2) ? Vector.ZERO : outward.times(0x1p-60), radius);
    }

    private static Query tinyPart(RandomNumbers random, Line line) {
        double tiny = random.sign() * random.magnitude(-1074, -66);
        Vector direction = Axes.withPart(line.direction(), random.axis(), tiny);
        return passed(random, new Line(line.origin(), direction), random.between(1, 20), random.magnitude(-1, 2));
    }

    private static Query passed(RandomNumbers random, Line line, double distance, double radius) {
        double part = random.oneIn(2) ? random.between(0, 1.5) : 1 + random.sign() * random.magnitude(-50, -9);
        Vector aside = random.perpendicularTo(line.direction());
        return line.with(Vectors.plus(line.at(distance), radius * part, aside), radius);
    }

    private static Query mixed(RandomNumbers random, Line line) {
        Line fromAnywhere = new Line(line.origin().times(random.magnitude(-60, 60)), line.direction());
        return passed(random, fromAnywhere, random.sign() * random.magnitude(-60, 60), random.magnitude(-60, 60));
    }

    private static Query ordinaryOrHard(RandomNumbers random, Line line) {
        return random.oneIn(3) ? tangent(random, line)
            : passed(random, line, random.between(-4, 20), random.magnitude(-1, 2));
    }

    private static Query speed(RandomNumbers random, Line line) {
        Query query = ordinaryOrHard(random, line);
        return query.withDirection(query.direction().times(random.magnitude(-531, 531)));
    }

    private static Query units(RandomNumbers random, Line line) {
        double lengths = random.powerOfTwo(-299, 299);
        double speed = random.magnitude(-531, 531);
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
