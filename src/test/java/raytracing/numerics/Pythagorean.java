package raytracing.numerics;

import java.util.List;
import raytracing.math.Vector;

/** Whole vectors whose length is whole: so points of a sphere, and rays that touch it, without any rounding. */
final class Pythagorean {
    private static final List<Vector> VECTORS = List.of(new Vector(3, 4, 0), new Vector(1, 2, 2), new Vector(2, 3, 6),
        new Vector(4, 4, 7), new Vector(1, 4, 8), new Vector(2, 6, 9), new Vector(6, 6, 7), new Vector(5, 12, 0),
        new Vector(3, 4, 12), new Vector(2, 5, 14), new Vector(2, 10, 11), new Vector(8, 15, 0), new Vector(1, 12, 12),
        new Vector(8, 9, 12), new Vector(20, 21, 0));

    private Pythagorean() {
    }

    /** Up to 29 long, in any order of axes and with any signs. */
    static Vector vector(RandomNumbers random) {
        Vector v = VECTORS.get(random.random().nextInt(VECTORS.size()));
        Vector turned = random.oneIn(6) ? v : Axes.PERMUTATIONS.get(random.random().nextInt(5)).apply(v);
        return new Vector(random.sign() * turned.x(), random.sign() * turned.y(), random.sign() * turned.z());
    }

    /** A whole vector at a right angle to another, without an error. */
    static Vector perpendicularTo(Vector whole, RandomNumbers random) {
        Vector perpendicular = whole.cross(random.wholes(9));
        return perpendicular.isZero() ? perpendicularTo(whole, random) : perpendicular;
    }
}
