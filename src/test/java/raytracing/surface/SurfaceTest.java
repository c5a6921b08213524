package raytracing.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/** What holds for every kind of surface, or for two of them. */
class SurfaceTest {
    private static final Vector CENTRE = new Vector(100, -70, 30);

    static Stream<Surface> surfaces() {
        return Stream.of(new Sphere(CENTRE, 5, 0), new Box(CENTRE, 10, 0), new Plane(new Vector(1, 2, -3), -130, 0));
    }

    static Stream<Body> bodies() {
        return Stream.of(new Sphere(CENTRE, 5, 0), new Box(CENTRE, 10, 0));
    }

    /** The same way in a quarter of the time. */
    @ParameterizedTest
    @MethodSource("surfaces")
    void theErrorOfAHitDoesNotDependOnTheLengthOfTheDirection(Surface surface) {
        Vector origin = new Vector(90, -50, 45);
        Vector direction = Vectors.plus(CENTRE, new Vector(0.5, -1, 0.25)).minus(origin);
        assertEquals(distance(surface, origin, direction) / 4, distance(surface, origin, direction.times(4)));
        assertEquals(hit(surface, origin, direction).pointError(), hit(surface, origin, direction.times(4)).pointError());
    }

    private static double distance(Surface surface, Vector origin, Vector direction) {
        return SurfaceQuestions.firstCrossing(surface, new RayRecord(origin, direction), Departure.ELSEWHERE);
    }

    private static HitRecord hit(Surface surface, Vector origin, Vector direction) {
        return HitRecord.at(surface, new RayRecord(origin, direction), distance(surface, origin, direction), 0);
    }

    /** A ball of radius 2, its middle 8 or 6 away from that of a body that reaches 5 along each axis. */
    @ParameterizedTest
    @CsvSource({"1, 0, 0", "-1, 0, 0", "0, 1, 0", "0, -1, 0", "0, 0, 1", "0, 0, -1"})
    void aBallIsApartFromABodyThatItDoesNotReach(double x, double y, double z) {
        Vector far = Vectors.plus(CENTRE, 8, new Vector(x, y, z));
        Vector near = Vectors.plus(CENTRE, 6, new Vector(x, y, z));
        bodies().forEach(body -> {
            assertTrue(body.isApartFrom(far.x(), far.y(), far.z(), 2));
            assertFalse(body.isApartFrom(near.x(), near.y(), near.z(), 2));
        });
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 6, true", "0, 0, 4, false", "3, 3, 4.5, true"})
    void aBallIsLeftBeforeAnEndThatIsOutside(double x, double y, double z, boolean expected) {
        Vector end = Vectors.plus(CENTRE, new Vector(x, y, z));
        assertEquals(expected, new Sphere(CENTRE, 5, 0).isLeft(new SegmentRecord(CENTRE, 0, end, 1e-13).toSegment()));
    }

    /** Seen from far away, o + t d is off by more than a unit in the last place of the point itself. */
    @Test
    void aHitLiesOnThePlaneHoweverFarTheRayCame() {
        SplittableRandom random = new SplittableRandom(52);
        for (int i = 0; i < 1_000; i++) {
            Vector normal = SphereTest.randomVector(random, 1);
            Plane plane = new Plane(normal, random.nextDouble(-1, 1), 0);
            Vector target = SphereTest.randomVector(random, 2);
            Vector origin = Vectors.plus(target, random.nextDouble(1e8, 1e9),
                Vectors.plus(normal, SphereTest.randomVector(random, 0.1)));
            HitRecord hit = hit(plane, origin, target.minus(origin));
            double gap = (normal.dot(hit.point()) - plane.offset()) / normal.length();
            assertEquals(0, gap, 8 * Math.ulp(hit.point().largestPart() + Math.abs(plane.offset()) / normal.length()));
        }
    }

    /** The faces that a ray enters and leaves by an edge or a corner; of two or three, the first of x, y, z. */
    @ParameterizedTest
    @CsvSource({
        "1, 1, 0,  1, 0, 0", "-1, 1, 0,  -1, 0, 0", "1, 0, -1,  1, 0, 0", "0, 1, 1,  0, 1, 0", "0, -1, 1,  0, -1, 0",
        "1, 1, 1,  1, 0, 0",
    })
    void onAnEdgeTheFirstOfItsFacesIsSeen(double x, double y, double z, double nx, double ny, double nz) {
        Box cube = new Box(Vector.ZERO, 2, 0);
        Vector direction = new Vector(x, y, z);
        Vector leavesBy = new Vector(nx, ny, nz);
        assertEquals(Vectors.plus(Vectors.negated(leavesBy), Vector.ZERO),
            OutwardNormal.of(cube, new RayRecord(direction.times(-3), direction), 2));
        assertEquals(leavesBy, OutwardNormal.of(cube, new RayRecord(Vector.ZERO, direction), 1));
    }

    @Test
    void aCopyOfAHitIsAsTheHit() {
        HitRecord hit = new HitRecord(7, 8, new Vector(1, 2, 3), 0.5, new Vector(0.36, 0.48, 0.8), Departure.INWARD);
        Hit copy = new Hit();
        copy.set(hit.toHit());
        assertEquals(hit, HitRecord.of(copy, 8));
    }
}
