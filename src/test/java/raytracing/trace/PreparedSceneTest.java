package raytracing.trace;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.List;
import java.util.Random;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.SceneText;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.parallel.ForkJoin;
import raytracing.scene.Scene;
import raytracing.surface.Body;
import raytracing.surface.Departure;
import raytracing.surface.HitRecord;
import raytracing.surface.RayRecord;
import raytracing.surface.SegmentRecord;
import raytracing.surface.Surface;
import raytracing.surface.SurfaceQuestions;

class PreparedSceneTest {
    private static final String HEAD = "cam 0 0 -5 0 0 0 0 1 0 1 1\nset 0 0 0 1 1\n";

    /** Material 1 is opaque; 2, 3 and 4 let a half, a quarter and all of the light through. */
    private static final String MATERIALS = """
        mtl 1 1 1 0 0 0 0 0 0 1 0
        mtl 1 1 1 0 0 0 0 0 0 1 0.5
        mtl 1 1 1 0 0 0 0 0 0 1 0.25
        mtl 1 1 1 0 0 0 0 0 0 1 1
        """;

    private static Scene scene(String... surfaces) {
        return SceneText.scene(HEAD + MATERIALS + String.join("\n", surfaces));
    }

    private static PreparedScene prepared(String... surfaces) {
        return Queries.prepared(scene(surfaces), ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
    }

    private static List<HitRecord> walk(PreparedScene prepared, RayRecord ray) {
        RayQuery walk = new RayQuery(prepared);
        List<HitRecord> hits = new ArrayList<>();
        Queries.start(walk, ray);
        while (walk.advance()) {
            hits.add(Queries.hit(walk));
        }
        return hits;
    }

    private static double transmittance(PreparedScene prepared, HitRecord hit, double x, double y, double z) {
        return new SegmentQuery(prepared, 1).transmittance(hit.toHit(), 0, x, y, z, 0);
    }

    private static List<Integer> surfaces(List<HitRecord> hits) {
        return hits.stream().map(HitRecord::surface).toList();
    }

    private static RayRecord ray(double x, double y, double z, double dx, double dy, double dz) {
        return new RayRecord(new Vector(x, y, z), new Vector(dx, dy, dz));
    }

    private static RayRecord rayAmongCrowd(SplittableRandom random) {
        return ray(random.nextDouble(-6, 6), random.nextDouble(-6, 6), random.nextDouble(-6, 6),
            random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
    }

    @Test
    void aRayMeetsEverySurfaceOnceInTheOrderOfDistance() {
        PreparedScene prepared = prepared("sph 0 0 3 1 1", "pln 0 0 1 10 1", "box 0 0 0 2 1", "sph 0 0 3 0.5 1");
        assertEquals(List.of(2, 0, 3, 1), surfaces(walk(prepared, ray(0, 0, -5, 0, 0, 1))));
    }

    @Test
    void aRayFromInsideMeetsTheWallFromInside() {
        HitRecord hit = walk(prepared("sph 0 0 0 2 1"), ray(0, 0, 0, 0, 0, 1)).get(0);
        assertEquals(Departure.INWARD, hit.side());
        assertEquals(new Vector(0, 0, 2), hit.point());
        assertEquals(-1, hit.normal().z());
    }

    @Test
    void coincidentSurfacesComeInTheOrderOfTheScene() {
        String ball = "sph 0 0 0 1 2";
        assertEquals(List.of(0, 1, 2), surfaces(walk(prepared(ball, ball, ball), ray(0, 0, -5, 0, 0, 1))));
        PreparedScene boxBeforePlane = prepared("box 0 0 1 2 1", "pln 0 0 1 0 1");
        assertEquals(List.of(0, 1), surfaces(walk(boxBeforePlane, ray(0, 0, -5, 0, 0, 1))));
        PreparedScene planeBeforeBox = prepared("pln 0 0 1 0 1", "box 0 0 1 2 1");
        assertEquals(List.of(0, 1), surfaces(walk(planeBeforeBox, ray(0, 0, -5, 0, 0, 1))));
    }

    @Test
    void aRayThatMeetsNothingHasNoHit() {
        assertEquals(List.of(), walk(prepared("sph 0 0 0 1 1"), ray(0, 5, -5, 0, 0, 1)));
        assertEquals(List.of(), walk(prepared(), ray(0, 0, 0, 0, 0, 1)));
    }

    /** The arrays give the bits of the objects, on rays of every kind through a crowd of all shapes. */
    @Test
    void theArraysAgreeWithTheObjectsBitForBit() {
        SplittableRandom random = new SplittableRandom(7);
        Scene scene = scene(crowd(random, 60));
        PreparedScene prepared = Queries.prepared(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
        int hits = 0;
        for (int i = 0; i < 3_000; i++) {
            RayRecord ray = rayAmongCrowd(random);
            List<HitRecord> expected = walkObjects(scene.surfaces(), ray);
            List<HitRecord> found = walk(prepared, ray);
            assertEquals(expected, found);
            if (!found.isEmpty()) {
                HitRecord first = found.get(0);
                RayRecord mirrored = first.leaving(Vectors.plus(first.normal(), 0.5, ray.direction()));
                assertEquals(walkObjects(scene.surfaces(), mirrored), walk(prepared, mirrored));
                hits++;
            }
        }
        assertTrue(hits > 2_000, "too few hits to mean anything");
    }

    /** A crossing that was found without lists. */
    private record ObjectHit(double distance, HitRecord hit) {
    }

    private static List<HitRecord> walkObjects(List<Surface> surfaces, RayRecord ray) {
        List<ObjectHit> hits = new ArrayList<>();
        for (int i = 0; i < surfaces.size(); i++) {
            Departure departure = i == ray.surfaceLeft() ? ray.departure() : Departure.ELSEWHERE;
            double crossing = SurfaceQuestions.firstCrossing(surfaces.get(i), ray, departure);
            if (crossing < Surface.MISS) {
                hits.add(new ObjectHit(crossing, HitRecord.at(surfaces.get(i), ray, crossing, i)));
            }
        }
        hits.sort(Comparator.comparingDouble(ObjectHit::distance).thenComparingInt(hit -> hit.hit.surface()));
        return hits.stream().map(ObjectHit::hit).toList();
    }

    /** Transparencies are powers of two, so their products are exact in any order. */
    @Test
    void transmittanceAgreesWithTheObjectsBitForBit() {
        SplittableRandom random = new SplittableRandom(8);
        Scene scene = scene(crowd(random, 12));
        PreparedScene prepared = Queries.prepared(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
        int partial = 0;
        for (int i = 0; i < 5_000; i++) {
            RayRecord ray = rayAmongCrowd(random);
            List<HitRecord> hits = walk(prepared, ray);
            if (!hits.isEmpty()) {
                HitRecord hit = hits.get(0);
                Vector end = new Vector(random.nextDouble(-9, 9), random.nextDouble(-9, 9), random.nextDouble(-9, 9));
                double expected = transmittanceOfObjects(scene, hit, end);
                assertEquals(expected, transmittance(prepared, hit, end.x(), end.y(), end.z()));
                partial += expected > 0 && expected < 1 ? 1 : 0;
            }
        }
        assertTrue(partial > 100, "too few partial shadows to mean anything");
    }

    private static double transmittanceOfObjects(Scene scene, HitRecord hit, Vector end) {
        SegmentRecord segment = new SegmentRecord(hit.point(), hit.pointError(), end, 0);
        Vector d = end.minus(hit.point());
        double product = 1;
        for (int i = 0; i < scene.surfaces().size(); i++) {
            Surface surface = scene.surfaces().get(i);
            Departure departure = i != hit.surface() ? Departure.ELSEWHERE
                : hit.side() == Departure.INWARD ? Departure.INWARD : hit.departureTowards(d.x(), d.y(), d.z());
            if (SurfaceQuestions.crosses(surface, segment, departure)) {
                product *= scene.materials().get(surface.material()).transparency();
            }
        }
        return product;
    }

    private static String[] crowd(SplittableRandom random, int size) {
        String[] lines = new String[size];
        String[] codes = {"sph", "sph", "box", "box", "box", "pln"};
        for (int i = 0; i < size; i++) {
            lines[i] = codes[random.nextInt(codes.length)] + " " + random.nextDouble(-4, 4) + " "
                + random.nextDouble(-4, 4) + " " + random.nextDouble(-4, 4) + " " + random.nextDouble(0.3, 2) + " "
                + random.nextInt(1, 5);
        }
        return lines;
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "nothing in between,              0, 0, 1,     1",
        "an opaque ball,                  0, 0, 9,     0",
        "the light before the ball,       0, 0, 2.9,   1",
        "the light inside the ball,       0, 0, 4,     0",
        "past the ball,                   4, 0, 9,     1",
        "a half and a quarter,            9, 0, 0, 0.125",
        "only the half,                   4, 0, 0,   0.5",
        "inside the quarter,              7, 0, 0, 0.125",
        "clear glass,                     0, 9, 0,     1",
    })
    void lightIsWeakenedOnceByEverySurfaceInBetween(String why, double dx, double dy, double dz, double expected) {
        PreparedScene prepared = prepared("pln 1 1 1 0 1", "sph 0 0 4 1 1", "box 3 0 0 1 2", "sph 7 0 0 1 3",
            "box 0 5 0 2 4");
        HitRecord origin = new HitRecord(0, 0, Vector.ZERO, 0, new Vector(1, 1, 1).unit(), Departure.OUTWARD);
        assertEquals(expected, transmittance(prepared, origin, dx, dy, dz), why);
    }

    @Test
    void opaqueShadowsTakeNoNoticeOfTransparency() {
        PreparedScene prepared = Queries.prepared(scene("pln 0 1 0 0 1", "sph 0 3 0 1 4"),
            ShadowMode.ALL_SURFACES_STOP_LIGHT);
        HitRecord floor = new HitRecord(0, 0, Vector.ZERO, 0, new Vector(0, 1, 0), Departure.OUTWARD);
        assertEquals(0, transmittance(prepared, floor, 0, 9, 0));
        assertEquals(1, transmittance(prepared, floor, 9, 9, 0));
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "the lit side from outside,           OUTWARD,  0,  1,    1",
        "along the wall,                      OUTWARD,  1,  0,    1",
        "a light below the horizon,           OUTWARD,  1, -3,  0.5",
        "a light inside the body,             OUTWARD,  0, -1,    1",
        "from inside to a light inside,       INWARD,   0, -1,    1",
        "from inside to a light behind the far wall, INWARD, 0, -3, 0.5",
    })
    void theOwnBodyShadowsOnlyWhatIsBehindItsFarWall(String why, Departure seenFrom, double dx, double dy,
                                                     double expected) {
        for (String body : new String[] {"sph 0 -1 0 1 2", "box 0 -1 0 2 2"}) {
            Vector normal = new Vector(0, seenFrom == Departure.OUTWARD ? 1 : -1, 0);
            HitRecord top = new HitRecord(0, 1, Vector.ZERO, 0, normal, seenFrom);
            assertEquals(expected, transmittance(prepared(body), top, dx, dy, 0), why);
        }
    }

    /** From the fourth step on, a hierarchy is searched for several surfaces at once; also behind an opaque one. */
    @Test
    void aRayMeetsBallsInBallsInTheSameOrderWithAHierarchy() {
        Random random = new Random(3);
        StringBuilder balls = new StringBuilder();
        for (int i = 0; i < 300; i++) {
            double radius = i % 3 == 0 ? 2 + i / 100 : 1 + 4 * random.nextDouble();   // some coincide
            balls.append("sph 0 0 0 ").append(radius).append(" 1\n");
        }
        Scene scene = scene(balls.toString());
        PreparedScene plain = new PreparedScene(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT,
            EnumSet.noneOf(Shortcut.class), ForkJoin.sequential());
        PreparedScene arranged = Queries.prepared(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
        for (int i = 0; i < 50; i++) {
            RayRecord ray = new RayRecord(new Vector(6 * random.nextGaussian(), 6 * random.nextGaussian(), -6),
                new Vector(random.nextGaussian() / 4, random.nextGaussian() / 4, 1));
            assertEquals(walk(plain, ray), walk(arranged, ray));
        }
        assertEquals(300, walk(arranged, new RayRecord(Vector.ZERO, new Vector(0, 0, 1))).size());
    }

    /** In the order of the hierarchy, which is not that of the scene. */
    @Test
    void packedNumbersAreThoseOfTheBodies() {
        String[] lines = new String[200];
        for (int i = 0; i < lines.length; i++) {
            String place = i * 37 % 101 + " " + i * 53 % 97 + " " + i * 71 % 89;
            lines[i] = (i % 2 == 0 ? "sph " : "box ") + place + " 0." + (1 + i) + " 1";
        }
        PreparedScene prepared = prepared(lines);
        double[] expected = new double[Body.PACKED];
        for (int i = 0; i < 100; i++) {
            ((Body) prepared.surface(prepared.spheres().numbers()[i])).pack(expected, 0);
            assertArrayEquals(expected, Arrays.copyOfRange(prepared.spheres().packed(), Body.PACKED * i, Body.PACKED * (i + 1)));
            assertEquals(prepared.surface(prepared.spheres().numbers()[i]), prepared.spheres().spheres()[i]);
        }
    }
}
