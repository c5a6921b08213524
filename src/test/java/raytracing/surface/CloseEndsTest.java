package raytracing.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.math.ExactVector;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/**
 * Points and lines that doubles cannot judge, for they are within a few units in the last place of a surface, against exact
 * arithmetic. The points count as exact: their own error is 0. Lengths are multiplied by powers of two up to where
 * squares leave the range.
 */
class CloseEndsTest {
    private static final int CASES = 2_000;

    /** Moved along each axis by up to 2 units in its last place, or along the line from the middle by up to a third. */
    private static Vector near(Vector point, Vector centre, SplittableRandom random) {
        if (random.nextInt(4) == 0) {
            return Vectors.plus(point, random.nextDouble(-0.3, 0.3), point.minus(centre));
        }
        return new Vector(point.x() + random.nextInt(-2, 3) * Math.ulp(point.x()),
            point.y() + random.nextInt(-2, 3) * Math.ulp(point.y()), point.z() + random.nextInt(-2, 3) * Math.ulp(point.z()));
    }

    /** A segment that ends there. */
    private static Segment to(Vector end) {
        return new SegmentRecord(Vector.ZERO, 0, end, 0).toSegment();
    }

    private static Vector onSphere(Sphere sphere, SplittableRandom random) {
        return Vectors.plus(sphere.centre(), sphere.radius(), SphereTest.randomVector(random, 1).unit());
    }

    private static Sphere sphere(SplittableRandom random, double lengths) {
        return new Sphere(SphereTest.randomVector(random, 1).times(lengths), random.nextDouble(0.5, 2) * lengths, 0);
    }

    private static BigDecimal power(ExactVector fromCentre, Sphere sphere) {
        return fromCentre.dot(fromCentre).subtract(new BigDecimal(sphere.radius()).pow(2));
    }

    private static ExactVector fromCentre(Vector point, Vector centre) {
        return ExactVector.of(point).minus(ExactVector.of(centre));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 0x1p440, 0x1p-460})
    void whetherAPointIsOutsideASphereIsKnownExactly(double lengths) {
        SplittableRandom random = new SplittableRandom(61);
        int outside = 0;
        for (int i = 0; i < CASES; i++) {
            Sphere sphere = sphere(random, lengths);
            Vector p = near(onSphere(sphere, random), sphere.centre(), random);
            boolean expected = power(fromCentre(p, sphere.centre()), sphere).signum() > 0;
            assertEquals(expected, sphere.isLeft(to(p)), () -> p + " and " + sphere);
            outside += expected ? 1 : 0;
        }
        assertTrue(outside > CASES / 4 && outside < CASES * 3 / 4, outside + " outside");
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 0x1p440, 0x1p-460})
    void whetherALineCrossesASphereIsKnownExactly(double lengths) {
        SplittableRandom random = new SplittableRandom(62);
        int crossed = 0;
        for (int i = 0; i < CASES; i++) {
            Sphere sphere = sphere(random, lengths);
            Vector p = near(onSphere(sphere, random), sphere.centre(), random);
            Vector q = near(onSphere(sphere, random), sphere.centre(), random);
            boolean expected = crosses(fromCentre(p, sphere.centre()), fromCentre(q, sphere.centre()), sphere);
            assertEquals(expected, SurfaceQuestions.crosses(sphere, new SegmentRecord(p, 0, q, 0), Departure.ELSEWHERE),
                () -> p + " to " + q + " and " + sphere);
            crossed += expected ? 1 : 0;
        }
        assertTrue(crossed > CASES / 4 && crossed < CASES * 3 / 4, crossed + " crossed");
    }

    /** Of ends on different sides, always; of two outside, where the line between them comes as near as the radius. */
    private static boolean crosses(ExactVector f, ExactVector g, Sphere sphere) {
        int start = power(f, sphere).signum();
        int end = power(g, sphere).signum();
        assertTrue(start != 0 && end != 0, "no random point is on the sphere exactly");
        if (start < 0 || end < 0) {
            return start != end;
        }
        ExactVector d = g.minus(f);
        BigDecimal a = d.dot(d);
        BigDecimal b = f.dot(d).negate();
        return b.signum() > 0 && b.compareTo(a) < 0
            && b.multiply(b).compareTo(a.multiply(power(f, sphere))) >= 0;
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 0x1p440, 0x1p-460})
    void whetherALineCrossesAPlaneIsKnownExactly(double lengths) {
        SplittableRandom random = new SplittableRandom(63);
        int crossed = 0;
        double normals = lengths == 1 ? 1 : 1 / Math.sqrt(lengths);
        for (int i = 0; i < CASES; i++) {
            Plane plane = new Plane(SphereTest.randomVector(random, 1).times(normals),
                random.nextInt(3) == 0 ? 0 : random.nextDouble(-1, 1) * normals * lengths, 0);
            Vector p = near(onPlane(plane, lengths, random), Vector.ZERO, random);
            Vector q = near(onPlane(plane, lengths, random), Vector.ZERO, random);
            boolean expected = gap(plane, p).signum() * gap(plane, q).signum() < 0;
            assertEquals(expected, SurfaceQuestions.crosses(plane, new SegmentRecord(p, 0, q, 0), Departure.ELSEWHERE),
                () -> p + " to " + q + " and " + plane);
            crossed += expected ? 1 : 0;
        }
        assertTrue(crossed > CASES / 4 && crossed < CASES * 3 / 4, crossed + " crossed");
    }

    private static Vector onPlane(Plane plane, double lengths, SplittableRandom random) {
        Vector n = plane.normal();
        Vector p = SphereTest.randomVector(random, 1).times(lengths);
        if (Math.abs(n.x()) > Math.abs(n.z())) {
            return new Vector((plane.offset() - n.y() * p.y() - n.z() * p.z()) / n.x(), p.y(), p.z());
        }
        return new Vector(p.x(), p.y(), (plane.offset() - n.x() * p.x() - n.y() * p.y()) / n.z());
    }

    private static BigDecimal gap(Plane plane, Vector point) {
        return new BigDecimal(plane.offset()).subtract(ExactVector.of(plane.normal()).dot(ExactVector.of(point)));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 0x1p440, 0x1p-460})
    void whetherAPointIsOutsideABoxIsKnownExactly(double lengths) {
        SplittableRandom random = new SplittableRandom(64);
        int outside = 0;
        for (int i = 0; i < CASES; i++) {
            Box box = new Box(SphereTest.randomVector(random, 1).times(lengths), random.nextDouble(0.5, 2) * lengths, 0);
            double half = box.edge() / 2;
            Vector onFace = Vectors.plus(box.centre(), half,
                new Vector(random.nextDouble(-1, 1), 1, random.nextDouble(-1, 1)));
            Vector p = near(onFace, box.centre(), random);
            ExactVector from = fromCentre(p, box.centre());
            boolean expected = from.x().abs().max(from.y().abs()).max(from.z().abs())
                .compareTo(new BigDecimal(half)) > 0;
            assertEquals(expected, box.isLeft(to(p)), () -> p + " and " + box);
            outside += expected ? 1 : 0;
        }
        assertTrue(outside > CASES / 4 && outside < CASES * 3 / 4, outside + " outside");
    }
}
