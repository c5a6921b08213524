package raytracing.geometry;

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

/** What holds for every kind of surface, or for two of them. */
class SurfaceTest {
    private static final Vector CENTRE = new Vector(100, -70, 30);

    static Stream<Surface> surfaces() {
        return Stream.of(new Sphere(CENTRE, 5, 0), new Box(CENTRE, 10, 0), new Plane(new Vector(1, 2, -3), -130, 0));
    }

    static Stream<Surface> bodies() {
        return Stream.of(new Sphere(CENTRE, 5, 0), new Box(CENTRE, 10, 0));
    }

    /** The same way in a quarter of the time. */
    @ParameterizedTest
    @MethodSource("surfaces")
    void theErrorOfAHitDoesNotDependOnTheLengthOfTheDirection(Surface surface) {
        Vector origin = new Vector(90, -50, 45);
        Vector direction = CENTRE.plus(new Vector(0.5, -1, 0.25)).minus(origin);
        Hit slow = hit(surface, origin, direction);
        Hit fast = hit(surface, origin, direction.times(4));
        assertEquals(slow.distance() / 4, fast.distance());
        assertEquals(slow.pointError(), fast.pointError());
    }

    private static Hit hit(Surface surface, Vector origin, Vector direction) {
        Ray ray = new Ray(origin, direction);
        return surface.hit(ray, SurfaceQuestions.firstCrossing(surface, ray, Departure.ELSEWHERE), 0);
    }

    /** A ball of radius 2, its middle 8 or 6 away from that of a body that reaches 5 along each axis. */
    @ParameterizedTest
    @CsvSource({"1, 0, 0", "-1, 0, 0", "0, 1, 0", "0, -1, 0", "0, 0, 1", "0, 0, -1"})
    void aBallIsApartFromABodyThatItDoesNotReach(double x, double y, double z) {
        Vector far = CENTRE.plus(8, new Vector(x, y, z));
        Vector near = CENTRE.plus(6, new Vector(x, y, z));
        bodies().forEach(body -> {
            assertTrue(body.isApartFrom(far.x(), far.y(), far.z(), 2));
            assertFalse(body.isApartFrom(near.x(), near.y(), near.z(), 2));
        });
    }

    /** A plane has no inside and is nowhere left. */
    @Test
    void aPlaneHasNoBody() {
        Plane plane = new Plane(new Vector(0, 3, 0), 6, 0);
        assertEquals(Surface.MISS, plane.farWall(new Standpoint(), 0, -1, 0));
        assertFalse(plane.isApartFrom(0, 99, 0, 1));
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 6, true", "0, 0, 4, false", "3, 3, 4.5, true"})
    void aBallIsLeftBeforeAnEndThatIsOutside(double x, double y, double z, boolean expected) {
        Vector end = CENTRE.plus(new Vector(x, y, z));
        assertEquals(expected, new Sphere(CENTRE, 5, 0).isLeftBefore(end.x(), end.y(), end.z(), 1e-13));
    }

    /** Seen from far away, o + t d is off by more than a unit in the last place of the point itself. */
    @Test
    void aHitLiesOnThePlaneHoweverFarTheRayCame() {
        SplittableRandom random = new SplittableRandom(52);
        for (int i = 0; i < 1_000; i++) {
            Vector normal = SphereTest.randomVector(random, 1);
            Plane plane = new Plane(normal, random.nextDouble(-1, 1), 0);
            Vector target = SphereTest.randomVector(random, 2);
            Vector origin = target.plus(random.nextDouble(1e8, 1e9), normal.plus(SphereTest.randomVector(random, 0.1)));
            Hit hit = hit(plane, origin, target.minus(origin));
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
        assertEquals(leavesBy.negated().plus(Vector.ZERO),
            OutwardNormal.of(cube, new Ray(direction.times(-3), direction), 2));
        assertEquals(leavesBy, OutwardNormal.of(cube, new Ray(Vector.ZERO, direction), 1));
    }

    @Test
    void aHitPointTakesOverAllOfAnother() {
        HitPoint first = new HitPoint();
        first.take(new Hit(7, 0, 1, new Vector(1, 2, 3), 0.5, new Vector(0.36, 0.48, 0.8), Departure.INWARD));
        HitPoint second = new HitPoint();
        second.take(first);
        assertEquals(new Hit(7, 8, 9, new Vector(1, 2, 3), 0.5, new Vector(0.36, 0.48, 0.8), Departure.INWARD),
            second.toHit(8, 9));
        assertEquals(new Vector(0.36, 0.48, 0.8), new Vector(second.normalX(), second.normalY(), second.normalZ()));
        assertEquals(0.5, second.error());
    }
}
