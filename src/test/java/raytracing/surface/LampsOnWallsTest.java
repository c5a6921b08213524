package raytracing.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/**
 * Lines that end on a surface, as far as the end is known, are mostly decided in doubles: the answer is that of exact numbers. The
 * ends lie from well within their error of the surface to well beyond it.
 */
class LampsOnWallsTest {
    private static final int CASES = 20_000;
    private static final int NUMBER = 0;

    private static RayOrigin start(SplittableRandom random) {
        Vector v = SphereTest.randomVector(random, 3);
        RayOrigin point = new RayOrigin();
        point.set(v.x(), v.y(), v.z(), random.nextInt(3) * 0x1p-50, RayOrigin.NO_SURFACE, Departure.ELSEWHERE);
        return point;
    }

    private static Segment segment(RayOrigin start, Vector end) {
        Segment segment = new Segment();
        segment.connect(start, end.x(), end.y(), end.z(), 0x1p-51);
        return segment;
    }

    /** Off by up to three of the errors that an end may have. */
    private static Vector aside(Vector end, double error, SplittableRandom random) {
        return Vectors.plus(end, error, SphereTest.randomVector(random, 3));
    }

    private static void assertSame(boolean exact, boolean found, RayOrigin start, Vector end) {
        assertEquals(exact, found, () -> start.point() + " to " + end);
    }

    @Test
    void aLineToALampOnAPlane() {
        SplittableRandom random = new SplittableRandom(81);
        int crossed = 0;
        for (int i = 0; i < CASES; i++) {
            Vector normal = SphereTest.randomVector(random, 1);
            Vector onPlane = SphereTest.randomVector(random, 1);
            Plane plane = new Plane(normal, normal.dot(onPlane), 0);
            RayOrigin start = start(random);
            Vector end = aside(onPlane, 0x1p-51, random);
            boolean exact = ExactPlane.of(plane).side(start, NUMBER) * ExactPlane.of(plane).side(end, 0x1p-51) < 0;
            assertSame(exact, plane.isCrossed(segment(start, end), NUMBER), start, end);
            crossed += exact ? 1 : 0;
        }
        assertTrue(crossed > CASES / 20, crossed + " crossed");
    }

    @Test
    void aLineToALampOnASphere() {
        SplittableRandom random = new SplittableRandom(82);
        int crossed = 0;
        for (int i = 0; i < CASES; i++) {
            Sphere sphere = new Sphere(SphereTest.randomVector(random, 1), random.nextDouble(0.5, 2), 0);
            Vector onSphere = Vectors.plus(sphere.centre(), sphere.radius(), SphereTest.randomVector(random, 1).unit());
            RayOrigin start = start(random);
            Vector end = aside(onSphere, 0x1p-51, random);
            boolean exact = ExactSphere.of(sphere).isCrossed(segment(start, end), NUMBER);
            assertSame(exact, sphere.isCrossed(segment(start, end), NUMBER), start, end);
            crossed += exact ? 1 : 0;
        }
        assertTrue(crossed > CASES / 20, crossed + " crossed");
    }

    @Test
    void aLineToALampOnABox() {
        SplittableRandom random = new SplittableRandom(83);
        int crossed = 0;
        for (int i = 0; i < CASES; i++) {
            Box box = new Box(SphereTest.randomVector(random, 1), random.nextDouble(0.5, 4), 0);
            double half = box.edge() / 2;
            Vector corner = new Vector(random.nextInt(-1, 2), random.nextInt(-1, 2), 1);
            Vector onFace = Vectors.plus(box.centre(), half, random.nextInt(4) == 0 ? corner
                : new Vector(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextInt(2) * 2 - 1));
            RayOrigin start = start(random);
            Vector end = aside(onFace, 0x1p-51, random);
            boolean exact = ExactBox.of(box).isCrossed(segment(start, end), NUMBER);
            assertSame(exact, box.isCrossed(segment(start, end), NUMBER), start, end);
            crossed += exact ? 1 : 0;
        }
        assertTrue(crossed > CASES / 20, crossed + " crossed");
    }
}
