package raytracing.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/** On which side of a surface a point lies that touches it. */
class RayOriginTest {
    private static final int FLOOR = 0;
    private static final int OTHER = 1;
    private static final double ERROR = 0x1p-49;
    private static final Plane LEVEL = new Plane(new Vector(0, 3, 0), 6, 0);
    private static final Sphere BALL = new Sphere(new Vector(0, 1, 0), 1, 0);
    private static final Box CUBE = new Box(Vector.ZERO, 2, 0);

    private static RayOrigin named(double x, double y, double z) {
        RayOrigin point = new RayOrigin();
        point.set(x, y, z, ERROR, RayOrigin.NO_SURFACE, Departure.ELSEWHERE);
        return point;
    }

    /** Reached on another surface, from a point that the scene names. */
    private static RayOrigin reached(double x, double y, double z, RayOrigin from, double way) {
        RayOrigin point = new RayOrigin();
        point.place(x, y, z, ERROR);
        point.reach(OTHER, Departure.OUTWARD, from, way);
        return point;
    }

    private static RayOrigin reached(double x, double y, double z, RayOrigin from) {
        return reached(x, y, z, from, 1);
    }

    private static Ray ray(RayOrigin from, Vector direction) {
        Ray ray = new Ray();
        ray.leave(from, direction.x(), direction.y(), direction.z());
        return ray;
    }

    @ParameterizedTest
    @CsvSource({"5, 1", "-7, -1", "2.000000000000001, 0", "2, 0"})
    void aPointOnAPlaneLiesOnTheSideFromWhichItWasSeen(double height, int expected) {
        assertEquals(expected, LEVEL.side(reached(4, Math.nextUp(2.0), 1, named(0, height, 0)), FLOOR));
    }

    @Test
    void aPointOffAPlaneLiesWhereItLies() {
        assertEquals(-1, LEVEL.side(reached(4, 1.999, 1, named(0, 5, 0)), FLOOR));
    }

    @Test
    void aNamedPointOnASurfaceHasNoSide() {
        assertEquals(0, LEVEL.side(named(4, 2, 1), FLOOR));
        assertEquals(0, BALL.side(named(0, 2, 0), FLOOR));
        assertEquals(0, CUBE.side(named(1, 0.5, 0.5), FLOOR));
    }

    /** A ray creeps along the floor that it left upwards, to a point that touches the floor, too. */
    @ParameterizedTest
    @CsvSource({"OUTWARD, 1", "INWARD, -1"})
    void theSurfaceThatTheRayLeftIsOnTheSideToWhichItLeft(Departure side, int expected) {
        RayOrigin onFloor = new RayOrigin();
        onFloor.place(0, 2, 0, ERROR);
        onFloor.reach(FLOOR, side, named(-3, 2 + expected, 0), 3);
        assertEquals(expected, LEVEL.side(reached(4, 2, 0, onFloor), FLOOR));
    }

    @Test
    void aWayOfAFewErrorsKeepsThePlaceFromWhichThePointWasSeen() {
        RayOrigin corner = reached(4, 2, 1, named(0, 5, 0));
        RayOrigin onTheOtherWall = reached(4 + 40 * ERROR, 2, 1, corner, 40 * ERROR);
        assertEquals(1, LEVEL.side(onTheOtherWall, FLOOR));
        assertEquals(0, LEVEL.side(reached(5, 2, 1, corner, 1), FLOOR));
    }

    @Test
    void aCopyKnowsFromWhereItWasSeen() {
        RayOrigin copy = new RayOrigin();
        copy.set(reached(4, 2, 1, named(0, 5, 0)));
        assertEquals(1, LEVEL.side(copy, FLOOR));
        assertEquals(OTHER, copy.surface());
    }

    /** Seen through the ball, from before it, from in it, and along a line that touches it. */
    @ParameterizedTest
    @CsvSource({"0, -5, 0, -1", "0, 5, 0, 1", "0, 1.5, 0, -1", "-5, 2, 0, 0", "-5, 2.5, 0, 1"})
    void aPointOnASphereIsOutsideWhereTheLineComesInAndInsideWhereItGoesOut(double x, double y, double z, int expected) {
        assertEquals(expected, BALL.side(reached(0, 2, 0, named(x, y, z)), FLOOR));
    }

    /** Close to where the ball stands on the floor, where the ball is 5e-19 high: the line goes away from its middle,
        and under it. */
    @Test
    void aLineThatPassesUnderABallHasNotBeenInIt() {
        assertEquals(1, BALL.side(reached(-1e-9, 0, 0, named(-5, 6e-9, 0)), FLOOR));
    }

    /** On the edge of the faces +x and +y. */
    @ParameterizedTest
    @CsvSource({"5, 5, 1", "5, 0.5, 1", "-5, 5, 1", "0.5, 0.5, -1", "-5, -5, -1", "1, 0.5, 0", "1, 5, 1"})
    void aPointOnAnEdgeIsOutsideIfOneOfTheFacesWasSeenFromInFront(double x, double y, int expected) {
        assertEquals(expected, CUBE.side(reached(1, 1, 0, named(x, y, 0)), FLOOR));
    }

    @Test
    void aRayThatHeadsToTheOtherSideMeetsTheSurfaceAtOnce() {
        Vector inwards = new Vector(0, -1, 0);
        RayOrigin top = reached(0, 2, 0, named(0, 5, 0));
        assertEquals(0, Surface.distance(LEVEL.exactCrossing(ray(top, inwards), FLOOR)));
        assertEquals(0, Surface.distance(BALL.exactCrossing(ray(top, inwards), FLOOR)));
        assertEquals(0, Surface.distance(CUBE.exactCrossing(ray(reached(0, 1, 0, named(0, 5, 0)), inwards), FLOOR)));
        Vector outwards = new Vector(0.5, 1, 0);
        assertTrue(LEVEL.exactCrossing(ray(top, outwards), FLOOR).isEmpty());
        assertTrue(BALL.exactCrossing(ray(top, outwards), FLOOR).isEmpty());
        assertTrue(CUBE.exactCrossing(ray(reached(0, 1, 0, named(0, 5, 0)), outwards), FLOOR).isEmpty());
    }

    /** Seen from inside a body, a ray that heads outwards meets its wall at once, and one that heads inwards its far wall. */
    @Test
    void fromInsideABodyItsWallIsMetAtOnceOrAcross() {
        RayOrigin top = reached(0, 2, 0, named(0, 1, 0));
        assertEquals(0, Surface.distance(BALL.exactCrossing(ray(top, new Vector(0, 1, 0)), FLOOR)));
        assertEquals(2, Surface.distance(BALL.exactCrossing(ray(top, new Vector(0, -1, 0)), FLOOR)));
        RayOrigin face = reached(0, 1, 0, named(0, 0, 0));
        assertEquals(0, Surface.distance(CUBE.exactCrossing(ray(face, new Vector(0, 1, 0)), FLOOR)));
        assertEquals(2, Surface.distance(CUBE.exactCrossing(ray(face, new Vector(0, -1, 0)), FLOOR)));
    }

    /** What is met at once is described at the point itself, with the normal to the side from which the point was seen. */
    @ParameterizedTest
    @CsvSource({"5, 1, OUTWARD", "-5, -1, INWARD"})
    void aHitAtNoDistanceIsThePointItself(double height, double normal, Departure side) {
        RayOrigin point = reached(4, Math.nextUp(2.0), 1, named(0, height, 0));
        Hit found = new Hit();
        LEVEL.describe(ray(point, new Vector(0.6, -0.8 * normal, 0)), FLOOR, 0, found);
        assertEquals(new Vector(4, Math.nextUp(2.0), 1), new Vector(found.x(), found.y(), found.z()));
        assertEquals(ERROR, found.error());
        assertEquals(normal, found.normalY());
        assertEquals(side, found.side());
        assertEquals(normal, LEVEL.side(found.origin(), OTHER));
    }

    /** Of the face through which it came, and of the second one that it touches: both are left behind, or both are met. */
    @ParameterizedTest
    @CsvSource({"0, 5.551115123125783e-17", "1e-15, 0"})
    void aRayFromTheInnerEdgeOfABoxMeetsTheFaceAhead(double error, double expected) {
        Box box = new Box(Vector.ZERO, 1, 0);
        RayRecord ray = new RayRecord(new Vector(Math.nextUp(0.5), Math.nextDown(0.5), 0), error, new Vector(-2, 1, 0), FLOOR,
            Departure.INWARD);
        assertEquals(expected, SurfaceQuestions.firstCrossing(box, ray, Departure.INWARD));
        HitRecord hit = HitRecord.at(box, ray, expected, FLOOR);
        assertEquals(new Vector(0, -1, 0), Vectors.plus(hit.normal(), Vector.ZERO));
        assertEquals(Departure.INWARD, hit.side());
    }
}
