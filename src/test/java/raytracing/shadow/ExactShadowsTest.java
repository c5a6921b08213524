package raytracing.shadow;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.Meshes;
import raytracing.SceneText;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.surface.Hit;
import raytracing.surface.HitRecord;
import raytracing.surface.PointError;
import raytracing.surface.RayRecord;
import raytracing.surface.Triangle;
import raytracing.trace.PreparedScene;
import raytracing.trace.Queries;
import raytracing.trace.RayQuery;
import raytracing.trace.ShadowMode;

/**
 * Shares of a light that are known on paper, laws that every share obeys, and the exercise's own method with very many
 * shadow rays.
 */
class ExactShadowsTest {
    /** Of shares; what is known in closed form differs by rounding only. */
    private static final double ROUNDING = 1e-13;

    private static final String HEAD = """
        cam 0 0 -5 0 0 0 0 1 0 1 1
        set 0 0 0 1 1
        mtl 1 1 1 0 0 0 0 0 0 1 0
        mtl 1 1 1 0 0 0 0 0 0 1 0.25
        mtl 1 1 1 0 0 0 0 0 0 1 0.5
        """;

    /** A point of the floor y = 0, seen from above. */
    private static final RayRecord DOWN = new RayRecord(new Vector(0, 0.125, 0), new Vector(0, -1, 0));

    /** What comes from a light to the first thing that a ray meets. */
    private static double share(String surfaces, RayRecord ray, Vector light, double width) {
        PreparedScene scene = Queries.prepared(SceneText.scene(HEAD + surfaces), ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
        RayQuery walk = new RayQuery(scene);
        Queries.start(walk, ray);
        assertTrue(walk.advance());
        ShaftQuery shaft = new ShaftQuery(scene, ShaftQuery.Use.AREAS, 1);
        shaft.aim(walk.hit(), 0, light.x(), light.y(), light.z(), PointError.written(light), width);
        return shaft.isSettled() ? shaft.settledTransmittance() : new ExactShadows(scene, 1).meanTransmittance(shaft, 1);
    }

    /** The point at 0, the light straight above it at height 4. */
    private static double shareFromAbove(String surfaces, double width) {
        return share("pln 0 1 0 0 1\n" + surfaces, DOWN, new Vector(0, 4, 0), width);
    }

    @Test
    void nothingInTheWayLetsAllLightThrough() {
        assertEquals(1, shareFromAbove("", 2));
    }

    /** The ball's cone has the sine 1/2, so it cuts a disc of radius 4 tan 30 degrees out of the light's plane. */
    @Test
    void aBallInTheMiddleHidesADisc() {
        double radius = 4 / Math.sqrt(3);
        double width = 6;
        assertEquals(1 - Math.PI * radius * radius / (width * width), shareFromAbove("sph 0 1 0 0.5 1", width), ROUNDING);
    }

    @Test
    void aBallLargerThanTheLightHidesItAll() {
        assertEquals(0, shareFromAbove("sph 0 1 0 0.5 1", 1));
    }

    /** The box's lower face is seen at height 1: four times as large in the light's plane. */
    @Test
    void aBoxInTheMiddleHidesASquare() {
        assertEquals(1 - 4 * 4 / 36.0, shareFromAbove("box 0 1.5 0 1 1", 6), ROUNDING);
    }

    /** Its lower face ends at x = 0, in the middle of the light. */
    @Test
    void aBoxBesideTheMiddleHidesHalf() {
        assertEquals(0.5, shareFromAbove("box 2 3 0 4 1", 2), ROUNDING);
    }

    /** The point is at x = 0; on the plane itself, it is behind no part of it. */
    @ParameterizedTest
    @CsvSource({"0, 1", "0.5, 0.75", "-0.75, 0.875", "1, 1", "-1, 1"})
    void aPlaneThroughTheLightHidesWhatIsBeyond(double x, double expected) {
        assertEquals(expected, shareFromAbove("pln 1 0 0 " + x + " 1", 2), ROUNDING);
    }

    /** A corner of the square is cut off: half of the light's half width along both edges. */
    @Test
    void aSlantedPlaneCutsACornerOff() {
        assertEquals(1 - 1 / 32.0, shareFromAbove("pln 1 0 1 1.5 1", 2), ROUNDING);
    }

    /** At height 2, an edge above the point and a third corner: twice as large in the light's plane, a quarter of the square. */
    @Test
    void aTriangleHidesATriangle() {
        assertEquals(1 - 1 / 4.0, shareFromAbove("trg 0 2 -0.5 0 2 0.5 0.5 2 0 1", 2), ROUNDING);
    }

    /** The two halves of a square at height 2, of which one corner is above the point; each may be on either side. */
    @ParameterizedTest
    @ValueSource(strings = {"trg 0 2 0 1 2 0 1 2 1 1\ntrg 0 2 0 1 2 1 0 2 1 1",
        "trg 0 2 0 1 2 1 1 2 0 1\ntrg 0 2 0 1 2 1 0 2 1 1"})
    void twoHalvesOfASquareHideASquare(String halves) {
        assertEquals(1 - 4 / 36.0, shareFromAbove(halves, 6), ROUNDING);
    }

    /**
     * An upright triangle at x = 0.5, 1 wide at height 2 and 0.5 wide where the light's plane cuts it: before the light is its
     * lower part, there a trapezoid from x = 1, 2 wide, to x = 0.5.
     */
    @Test
    void aTriangleThroughTheLightHidesWithWhatIsBeforeIt() {
        assertEquals(1 - 0.5 * (2 + 0.5) * 0.5 / 36, shareFromAbove("trg 0.5 2 -0.5 0.5 2 0.5 0.5 6 0 1", 6), ROUNDING);
    }

    @Test
    void aTriangleBehindThePointOrBehindTheLightHidesNothing() {
        assertEquals(1, shareFromAbove("trg -9 -1 -9 9 -1 -9 0 -1 9 1\ntrg -9 5 -9 9 5 -9 0 5 9 1", 2));
    }

    @Test
    void aTransparentTriangleLetsItsShareThrough() {
        assertEquals(1 - 0.75 / 4, shareFromAbove("trg 0 2 -0.5 0 2 0.5 0.5 2 0 2", 2), ROUNDING);
    }

    @Test
    void twoTransparentTwinsDimTwice() {
        String triangle = "trg 0 2 -0.5 0 2 0.5 0.5 2 0 2\n";
        assertEquals(1 - (1 - 0.0625) / 4, shareFromAbove(triangle + triangle, 2), ROUNDING);
    }

    /**
     * A fold, open to the right: from a point on its lower half, the corner of the upper half is before the light's middle, and
     * both its edges from there go to the left, 9 times as far to the front or the back.
     */
    @Test
    void thePointOnATriangleIsHiddenByItsNeighbour() {
        RayRecord down = new RayRecord(new Vector(1, 0.125, 0), new Vector(0, -1, 0));
        String fold = "trg 0 0 -9 0 0 9 9 0 0 1\ntrg 0 0 -9 0 0 9 1 2 0 1\n";
        assertEquals(0.5 + 1 / 36.0, share(fold, down, new Vector(1, 4, 0), 4), ROUNDING);
    }

    @Test
    void transparentSurfacesLetTheirShareThrough() {
        double open = 1 - 16 / 36.0;
        assertEquals(open + 0.25 * (1 - open), shareFromAbove("box 0 1.5 0 1 2", 6), ROUNDING);
    }

    /** The cone of the upper ball is inside that of the lower. */
    @Test
    void surfacesBehindOneAnotherMultiply() {
        double large = Math.PI * 16 / 3 / 36;
        double small = Math.PI * 16 * 0.01 / (9 - 0.01) / 36;
        assertEquals(1 - large + 0.25 * (large - small) + 0.25 * 0.5 * small,
            shareFromAbove("sph 0 1 0 0.5 2\nsph 0 3 0 0.1 3", 6), ROUNDING);
    }

    @Test
    void theSameOpaqueBallTwiceHidesNoMore() {
        String ball = "sph 0.2 1 0.1 0.5 1\n";
        assertEquals(shareFromAbove(ball, 6), shareFromAbove(ball + ball, 6), ROUNDING);
    }

    /** Both shadows lie inside the light and are apart. */
    @Test
    void ballsSideBySideAddUp() {
        double left = 1 - shareFromAbove("sph -0.4 2 0 0.2 1", 6);
        double right = 1 - shareFromAbove("sph 0.5 2 0.1 0.3 1", 6);
        assertEquals(1 - left - right, shareFromAbove("sph -0.4 2 0 0.2 1\nsph 0.5 2 0.1 0.3 1", 6), ROUNDING);
    }

    /**
     * Two balls that mirror each other in x = 0 and overlap there. A box that hides x &lt; 0 leaves what one takes of
     * the rest.
     */
    @Test
    void overlappingBallsMeetOnTheLineBetweenThem() {
        String right = "sph 0.25 2 0 0.5 1\n";
        double takenByRight = 0.5 - shareFromAbove(right + "box -4 5 0 8 1", 6);
        assertEquals(1 - 2 * takenByRight, shareFromAbove(right + "sph -0.25 2 0 0.5 1", 6), ROUNDING);
    }

    /** The ball's tangent circle, at height 15 / 4, is in front of the light. */
    @Test
    void aLightThroughTheFarPartOfABallIsHiddenByItsCone() {
        assertEquals(1 - Math.PI * 16 / 15 / 16, shareFromAbove("sph 0 4 0 1 1", 4), ROUNDING);
    }

    /** The light is in front of the tangent circle. */
    @Test
    void aLightThroughTheNearPartOfABallIsHiddenByItsDisc() {
        assertEquals(1 - Math.PI * 0.75 / 16, shareFromAbove("sph 0 4.5 0 1 1", 4), ROUNDING);
    }

    /** Seen from inside the ball, only the disc is not behind its wall. */
    @Test
    void aBallAroundThePointShowsItsDiscOfTheLight() {
        double squaredRadius = 4.5 * 4.5 - 16;
        assertEquals(Math.PI * squaredRadius / 36, shareFromAbove("sph 0 0 0 4.5 1", 6), ROUNDING);
    }

    /** The light is at the height of the point on the ball's equator; the horizon goes through its middle. */
    @Test
    void theOwnHorizonCutsTheLight() {
        RayRecord fromTheSide = new RayRecord(new Vector(3, 0, 0), new Vector(-1, 0, 0));
        assertEquals(0.5, share("sph 0 0 0 1 1", fromTheSide, new Vector(1, 5, 0), 2), ROUNDING);
        assertEquals(0.75, share("sph 0 0 0 1 1", fromTheSide, new Vector(1.5, 5, 0), 2 * Math.sqrt(25.25) / 5), ROUNDING);
    }

    /** A light in the same wall as the point: half of it is behind. */
    @Test
    void theOwnWallCutsTheLight() {
        RayRecord fromTheSide = new RayRecord(new Vector(3, 0, 0), new Vector(-1, 0, 0));
        assertEquals(0.5, share("box 0 0 0 2 1", fromTheSide, new Vector(1, 5, 0), 2), ROUNDING);
    }

    /**
     * The light crosses the wall at right angles; what is behind the wall is inside the box, and nothing is in its way.
     */
    @Test
    void theOwnBodyShowsThePartOfTheLightThatItContains() {
        RayRecord fromTheSide = new RayRecord(new Vector(3, 0, 0), new Vector(-1, 0, 0));
        assertEquals(1, share("box 0 0 0 2 1", fromTheSide, new Vector(1, 0.5, 0), 0.5), ROUNDING);
    }

    /** As before, but a quarter of the light, a half of its half, reaches out of the box through two other walls. */
    @Test
    void theOwnBodyHidesTheLightBeyondItsOtherWalls() {
        RayRecord fromTheSide = new RayRecord(new Vector(3, 0, 0), new Vector(-1, 0, 0));
        assertEquals(0.75, share("box 0 0 0 2 1", fromTheSide, new Vector(1, 0.5, 0), 4), ROUNDING);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void agreesWithTheLimitOfSamplingForOpaqueSurfaces(long seed) {
        assertAgreesWithSampling(new ShadowQueries(seed, 0));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void agreesWithTheLimitOfSamplingForTransparentSurfaces(long seed) {
        assertAgreesWithSampling(new ShadowQueries(seed, 0, 0.7, 0.3, 0.9));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void agreesWithTheLimitOfSamplingForOpaqueTriangles(long seed) {
        assertAgreesWithSampling(ShadowQueries.amongTriangles(seed, 0));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void agreesWithTheLimitOfSamplingForTransparentTriangles(long seed) {
        assertAgreesWithSampling(ShadowQueries.amongTriangles(seed, 0, 0.7, 0.3, 0.9));
    }

    /**
     * 16 runs give a distance in Student's t with 15 degrees of freedom. One of 150 is beyond 7 by chance in 0.06 % of
     * all seeds; the root of their mean square, 1.07 on average, is above 1.3 in less than 0.1 %.
     */
    private static void assertAgreesWithSampling(ShadowQueries queries) {
        int count = 150;
        int root = 40;
        int runs = 16;
        double squares = 0;
        for (int i = 0; i < count; i++) {
            ShadowQueries.Query query = queries.next();
            SamplingLimit limit = SamplingLimit.of(query, root, runs);
            double distance = limit.distance(query.exact(), root, runs);
            assertTrue(distance < 7, () -> query.exact() + " but sampled " + limit + ": " + query);
            squares += distance * distance;
        }
        double rootMeanSquare = Math.sqrt(squares / count);
        assertTrue(rootMeanSquare < 1.3, () -> "distances of " + rootMeanSquare + " standard errors");
    }

    /**
     * Surfaces, eyes and lights at whole numbers, so that walls coincide, balls touch, and lights cut them or lie in
     * their walls. 30 x 30 rays are off by about 30^-1.5 = 0.006 where one border crosses the light, and by less than
     * 0.06 in all.
     */
    @Test
    void surfacesThatTouchAndCoincideHaveTheSharesThatRaysFind() {
        SplittableRandom random = new SplittableRandom(1);
        int open = 0;
        for (int i = 0; i < 3000; i++) {
            open += roundQuestions(roundSurfaces(random), random);
        }
        int questions = open;
        assertTrue(questions > 2000, () -> "hardly a test: " + questions);
    }

    /** The same among triangles with round corners: neighbours in one plane, twins, edges and corners that many share. */
    @Test
    void trianglesThatTouchAndCoincideHaveTheSharesThatRaysFind() {
        SplittableRandom random = new SplittableRandom(2);
        RandomTriangles triangles = new RandomTriangles(random, 3);
        int open = 0;
        for (int i = 0; i < 4500; i++) {
            open += roundQuestions(triangles.grid(random.nextInt(1, 7)), random);
        }
        int questions = open;
        assertTrue(questions > 2000, () -> "hardly a test: " + questions);
    }

    /** From points on the edges and corners of meshes, which touch several of their triangles. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-16, 1e-9})
    void meshesSeenFromTheirEdgesAndCornersHaveTheSharesThatRaysFind(double aside) {
        SplittableRandom random = new SplittableRandom(3);
        RandomTriangles triangles = new RandomTriangles(random, 3);
        int open = 0;
        for (int i = 0; i < 40; i++) {
            String surfaces = triangles.meshes(1);
            PreparedScene scene = Queries.prepared(SceneText.scene(HEAD + surfaces), ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
            RayQuery walk = new RayQuery(scene);
            for (int k = 0; k < 8; k++) {
                Triangle triangle = (Triangle) scene.surface(random.nextInt(20));
                Vector onEdge = Vectors.plus(triangle.a(), random.nextInt(3) / 2.0, triangle.b().minus(triangle.a()));
                Vector eye = roundVector(random, 6);
                Queries.start(walk, new RayRecord(eye,
                    Vectors.plus(onEdge, random.nextDouble(-1, 1) * aside, new Vector(1, 1, 1)).minus(eye)));
                Vector light = roundVector(random, 4);
                if (walk.advance() && light.minus(Queries.hit(walk).point()).dot(Queries.hit(walk).normal()) > 1e-9) {
                    open += assertAgreesWithRays(scene, walk.hit(), light, random.nextInt(1, 5));
                }
            }
        }
        int questions = open;
        assertTrue(questions > 40, () -> "hardly a test: " + questions);
    }

    /**
     * Two triangles with a common edge, bent outwards or inwards, from points on that edge: where light comes past it depends on
     * the place from which it was seen.
     */
    @Test
    void foldsSeenFromTheirEdgeHaveTheSharesThatRaysFind() {
        SplittableRandom random = new SplittableRandom(4);
        int open = 0;
        for (int i = 0; i < 500; i++) {
            Vector a = randomVector(random, 2);
            Vector b = randomVector(random, 2);
            PreparedScene scene = Queries.prepared(SceneText.scene(HEAD + Meshes.triangle(a, b, randomVector(random, 5), 1)
                + Meshes.triangle(a, b, randomVector(random, 5), 1)), ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
            RayQuery walk = new RayQuery(scene);
            Vector eye = randomVector(random, 6);
            Queries.start(walk, new RayRecord(eye, Vectors.plus(a, random.nextDouble(), b.minus(a)).minus(eye)));
            Vector light = randomVector(random, 8);
            if (walk.advance() && light.minus(Queries.hit(walk).point()).dot(Queries.hit(walk).normal()) > 1e-9) {
                open += assertAgreesWithRays(scene, walk.hit(), light, random.nextDouble(1, 6));
            }
        }
        int questions = open;
        assertTrue(questions > 50, () -> "hardly a test: " + questions);
    }

    private static Vector randomVector(SplittableRandom random, double size) {
        return new Vector(random.nextDouble(-size, size), random.nextDouble(-size, size), random.nextDouble(-size, size));
    }

    private static int roundQuestions(String surfaces, SplittableRandom random) {
        int open = 0;
        PreparedScene scene = Queries.prepared(SceneText.scene(HEAD + surfaces), ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
        RayQuery walk = new RayQuery(scene);
        for (int k = 0; k < 8; k++) {
            Queries.start(walk,
                new RayRecord(roundVector(random, 6), new Vector(random.nextDouble(-1, 1), random.nextInt(-1, 2), 0.5)));
            Vector light = roundVector(random, 4);
            if (!walk.advance()) {
                continue;
            }
            HitRecord hit = Queries.hit(walk);
            if (light.minus(hit.point()).dot(hit.normal()) > 1e-9) {
                open += assertAgreesWithRays(new ShadowQueries.Query(scene, hit, light, random.nextInt(1, 5), surfaces));
            }
        }
        return open;
    }

    private static int assertAgreesWithRays(ShadowQueries.Query query) {
        ShaftQuery shaft = query.shaft(ShaftQuery.Use.LINES);
        if (shaft.isSettled()) {
            return 0;
        }
        assertEquals(shaft.sumOverCells(30, 1) / 900, query.exact(), 0.06, () -> query.toString());
        return 1;
    }

    /** The same for a hit that knows from where it was seen. */
    private static int assertAgreesWithRays(PreparedScene scene, Hit hit, Vector light, double width) {
        ShaftQuery lines = new ShaftQuery(scene, ShaftQuery.Use.LINES, 1);
        lines.aim(hit, 0, light.x(), light.y(), light.z(), PointError.written(light), width);
        ShaftQuery areas = new ShaftQuery(scene, ShaftQuery.Use.AREAS, 1);
        areas.aim(hit, 0, light.x(), light.y(), light.z(), PointError.written(light), width);
        if (lines.isSettled()) {
            return 0;
        }
        assertEquals(lines.sumOverCells(30, 1) / 900, new ExactShadows(scene, 1).meanTransmittance(areas, 1), 0.06,
            () -> HitRecord.of(hit, 0) + " to " + light + ", width " + width);
        return 1;
    }

    private static String roundSurfaces(SplittableRandom random) {
        String[] codes = {"sph", "sph", "box", "box", "pln"};
        StringBuilder lines = new StringBuilder();
        int size = random.nextInt(1, 7);
        for (int i = 0; i < size; i++) {
            Vector place = roundVector(random, 2);
            lines.append(codes[random.nextInt(codes.length)]).append(' ').append(place.x()).append(' ').append(place.y())
                .append(' ').append(place.z()).append(' ').append(random.nextInt(1, 4)).append(' ')
                .append(random.nextInt(1, 4)).append('\n');
        }
        return lines.toString().replaceAll("pln -?0.0 -?0.0 -?0.0", "pln 0 1 0");
    }

    private static Vector roundVector(SplittableRandom random, int size) {
        return new Vector(random.nextInt(-size, size + 1), random.nextInt(-size, size + 1), random.nextInt(-size, size + 1));
    }

    /** The point is on the outside of one box and on the wall of another, around the light: nothing is between them. */
    @Test
    void aWallThatThePointIsOnDoesNotHideTheLightBehindIt() {
        assertEquals(1, shareFromAbove("box 0 4 0 8 1", 2), ROUNDING);
    }

    /** The point is on both balls, or as far inside or outside the second as rounding says, which is all the same. */
    @Test
    void aTwinOfTheOwnBallHidesNoMoreThanTheBallItself() {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 300; i++) {
            Vector direction =
                new Vector(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(0.1, 1)).unit();
            RayRecord ray = new RayRecord(direction.times(3), direction.times(-1));
            String ball = "sph 0 0 0 1 1\n";
            Vector above = Vectors.plus(direction.times(3), new Vector(0.3, 0.2, 0));
            assertEquals(1, share(ball + ball, ray, above, 0.5), ROUNDING);
            Vector low = new Vector(random.nextDouble(-5, 5), random.nextDouble(-5, 5), 4);
            assertEquals(share(ball, ray, low, 6), share(ball + ball, ray, low, 6), ROUNDING);
        }
    }

    /** Only the order of sums changes. */
    @Test
    void theOrderOfTheSurfacesDoesNotMatter() {
        List<String> lines = new ArrayList<>(List.of("sph 0.2 1 0.1 0.4 1", "sph -0.3 2 0 0.5 2", "sph 0.1 2.5 0.4 0.6 3",
            "sph 0 3.8 -0.7 0.5 2", "box 0.9 2 0.9 1 3", "box -1 1.5 -1 1 1", "pln 1 0.1 0.2 1.3 2", "sph 0 0 0 4.3 3"));
        double expected = shareFromAbove(String.join("\n", lines), 3);
        assertTrue(expected > 0.01 && expected < 0.5, () -> "hardly a test: " + expected);
        Random random = new Random(1);
        for (int i = 0; i < 100; i++) {
            Collections.shuffle(lines, random);
            assertEquals(expected, shareFromAbove(String.join("\n", lines), 3), 1e-6);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {-300, -40, -1, 1, 40, 300})
    void multiplyingAllLengthsByAPowerOfTwoChangesNoBit(int exponent) {
        String surfaces = "sph %s %s 0 %s 1\nsph 0 %s 0 %s 2\nbox %s %s 0 %s 2\nsph %s %s 0 %s 3\npln 1 0 0 %s 3\n";
        Object[] lengths = {0.2, 1.0, 0.5, 2.0, 0.25, 0.5, 2.0, 0.75, 0.5, 4.0, 0.75, 0.9};
        Object[] scaled = new Object[lengths.length];
        for (int i = 0; i < lengths.length; i++) {
            scaled[i] = Math.scalb((double) lengths[i], exponent);
        }
        double expected = shareFromAbove(String.format(surfaces, lengths), 3);
        assertTrue(expected > 0.05 && expected < 0.95, () -> "hardly a test: " + expected);
        assertEquals(expected, share("pln 0 1 0 0 1\n" + String.format(surfaces, scaled),
            new RayRecord(new Vector(0, Math.scalb(0.125, exponent), 0), new Vector(0, -1, 0)),
            new Vector(0, Math.scalb(4.0, exponent), 0), Math.scalb(3.0, exponent)));
    }
}
