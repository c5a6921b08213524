package raytracing.shadow;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.Meshes;
import raytracing.SceneText;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.surface.Departure;
import raytracing.surface.Hit;
import raytracing.surface.HitRecord;
import raytracing.surface.PointError;
import raytracing.surface.RayRecord;
import raytracing.trace.PreparedScene;
import raytracing.trace.Queries;
import raytracing.trace.RayQuery;
import raytracing.trace.ShadowMode;

/** Shafts from points close to one another share what is beside them all, and nothing else comes of it. */
class NearbyShaftsTest {
    private static final int ROOT = 4;

    /** From 1 along the diagonal to its part along x, and along z. */
    private static final double DIAGONAL = Math.sqrt(0.5);

    private static final String HEAD = """
        cam 0 0 -5 0 0 0 0 1 0 1 1
        set 0 0 0 1 1
        mtl 1 1 1 0 0 0 0 0 0 1 0
        mtl 1 1 1 0 0 0 0 0 0 1 0.7
        mtl 1 1 1 0 0 0 0 0 0 1 0.3
        """;

    private int compared;
    private double leastShare = ROOT * ROOT;

    private static PreparedScene prepared(String surfaces) {
        return Queries.prepared(SceneText.scene(HEAD + surfaces), ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
    }

    private static Hit floorPoint(double x, double z) {
        return new HitRecord(0, 0, new Vector(x, 0, z), 0x1p-48, new Vector(0, 1, 0), Departure.OUTWARD).toHit();
    }

    private static double share(ShaftQuery query, Hit hit, Vector light, double width, long key) {
        query.aim(hit, 0, light.x(), light.y(), light.z(), PointError.written(light), width);
        if (!query.isSettled()) {
            return query.sumOverCells(ROOT, key);
        }
        double sum = 0;                                // one by one: so both are rounded alike
        for (int i = 0; i < ROOT * ROOT; i++) {
            sum += query.settledTransmittance();
        }
        return sum;
    }

    /** Many rays into a small part of a scene, as those of a tile: the same query answers as a new one for each point. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-9, 1, 1e6})
    void aQueryThatRemembersAnswersAsANewOne(double scale) {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 150; i++) {
            PreparedScene scene = prepared(crowd(random, scale));
            Vector light = vector(random, 6 * scale);
            double width = random.nextDouble(0.05, 2) * scale;
            compareTile(scene, vector(random, 4 * scale), vector(random, 1), light, width, random);
        }
        assertTrue(compared > 3000, () -> compared + " compared");
    }

    /** The same among triangles and small meshes. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-9, 1, 1e6})
    void aQueryThatRemembersAnswersAsANewOneAmongTriangles(double scale) {
        SplittableRandom random = new SplittableRandom(3);
        RandomTriangles triangles = new RandomTriangles(random, 3);
        for (int i = 0; i < 250; i++) {
            PreparedScene scene = prepared(triangles.crowd(random.nextInt(2, 9), 4 * scale));
            Vector light = vector(random, 6 * scale);
            double width = random.nextDouble(0.05, 2) * scale;
            compareTile(scene, vector(random, 4 * scale), vector(random, 1), light, width, random);
        }
        assertTrue(compared > 3000, () -> compared + " compared");
    }

    private void compareTile(PreparedScene scene, Vector eye, Vector view, Vector light, double width, SplittableRandom random) {
        ShaftQuery remembering = new ShaftQuery(scene, ShaftQuery.Use.LINES, 1);
        RayQuery ray = new RayQuery(scene);
        for (int k = 0; k < 40; k++) {
            Queries.start(ray, new RayRecord(eye, new Vector(view.x() + random.nextDouble(0.05),
                view.y() + random.nextDouble(0.05), view.z() + random.nextDouble(0.05))));
            while (ray.advance()) {
                if (light.minus(Queries.hit(ray).point()).length() > 1e-3 * width) {
                    long key = random.nextLong();
                    ShaftQuery fresh = new ShaftQuery(scene, ShaftQuery.Use.LINES, 1);
                    assertEquals(share(fresh, ray.hit(), light, width, key), share(remembering, ray.hit(), light, width, key),
                        () -> HitRecord.of(ray.hit(), 0) + " to " + light + ", width " + width);
                    compared++;
                }
            }
        }
    }

    private static String crowd(SplittableRandom random, double scale) {
        String[] codes = {"sph", "sph", "box", "pln"};
        StringBuilder lines = new StringBuilder();
        for (int i = random.nextInt(2, 9); i > 0; i--) {
            String code = codes[random.nextInt(codes.length)];
            Vector place = vector(random, code.equals("pln") ? 1 : 4 * scale);
            lines.append(code).append(' ').append(place.x()).append(' ').append(place.y()).append(' ').append(place.z())
                .append(' ').append(random.nextDouble(0.2, 2) * scale).append(' ').append(random.nextInt(1, 4)).append('\n');
        }
        return lines.toString();
    }

    private static Vector vector(SplittableRandom random, double size) {
        return new Vector(random.nextDouble(-size, size), random.nextDouble(-size, size), random.nextDouble(-size, size));
    }

    private void assertRemembered(ShaftQuery query, PreparedScene scene, Hit hit, Vector light, long key) {
        double expected = share(new ShaftQuery(scene, ShaftQuery.Use.LINES, 1), hit, light, 2, key);
        assertEquals(expected, share(query, hit, light, 2, key));
        leastShare = Math.min(leastShare, expected);
    }

    /** From the middle of a neighbourhood to beyond its border. */
    private void assertRememberedAlongTheDiagonal(PreparedScene scene, SplittableRandom random) {
        ShaftQuery query = new ShaftQuery(scene, ShaftQuery.Use.LINES, 1);
        for (double way = 0; way <= 0.62; way += 0.02) {
            assertRemembered(query, scene, floorPoint(DIAGONAL * way, DIAGONAL * way), new Vector(0, 10, 0),
                random.nextLong());
        }
    }

    /** A ball that a shaft from the border of the neighbourhood meets, and no shaft from its middle does. */
    @ParameterizedTest
    @ValueSource(doubles = {-0.5, -0.1, -1e-3, -1e-12, 0, 1e-12})
    void aBallBesideOneShaftThatTouchesTheNextIsFound(double beyond) {
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < 300; i++) {
            double along = random.nextDouble(0.001, 0.3);
            double radius = random.nextDouble(0.01, 1);
            // the line from (0.62, 0) to (1.41, 10), a corner of the light, in the plane x = z; the ball is outside it
            double aside = 0.62 + 0.79 * along + radius * (1 + beyond);
            PreparedScene scene = prepared("pln 0 1 0 0 1\nsph " + DIAGONAL * aside + " " + 10 * along + " " + DIAGONAL * aside
                + " " + radius + " 1");
            assertRememberedAlongTheDiagonal(scene, random);
        }
        assertTrue(leastShare < ROOT * ROOT || beyond > -0.4);
    }

    /** A triangle with a corner that a shaft from the border of the neighbourhood meets, and no shaft from its middle does. */
    @ParameterizedTest
    @ValueSource(doubles = {-0.5, -0.1, -1e-3, -1e-12, 0, 1e-12})
    void aTriangleBesideOneShaftWhoseCornerTouchesTheNextIsFound(double beyond) {
        SplittableRandom random = new SplittableRandom(4);
        for (int i = 0; i < 300; i++) {
            double along = random.nextDouble(0.001, 0.3);
            double size = random.nextDouble(0.01, 1);
            // the line from (0.62, 0) to (1.41, 10), a corner of the light, in the plane x = z; the triangle is outside it
            double aside = DIAGONAL * (0.62 + 0.79 * along + beyond * size);
            Vector corner = new Vector(aside, 10 * along, aside);
            PreparedScene scene = prepared("pln 0 1 0 0 1\n" + Meshes.triangle(corner,
                Vectors.plus(corner, size, new Vector(random.nextDouble(0.5, 1), 0.05, 0.2)),
                Vectors.plus(corner, size, new Vector(0.2, random.nextDouble(-0.1, 0.1), random.nextDouble(0.5, 1))), 1));
            assertRememberedAlongTheDiagonal(scene, random);
        }
        assertTrue(leastShare < ROOT * ROOT || beyond > -0.4);
    }

    @Test
    void aPlaneBehindSomeOfThePointsIsFound() {
        PreparedScene scene = prepared("pln 0 1 0 0 1\npln 1 -0.3 0 0.5 1");
        ShaftQuery query = new ShaftQuery(scene, ShaftQuery.Use.LINES, 1);
        for (double x = 0; x < 0.62; x += 0.01) {
            assertRemembered(query, scene, floorPoint(x, 0), new Vector(0, 10, 0), 1);
        }
        assertEquals(0, leastShare);
    }

    /** From its pole, which sees the whole light, to where all of the light has sunk below the horizon. */
    @ParameterizedTest
    @ValueSource(doubles = {0.002, 0.02, 0.1})
    void aBallHidesTheLightFromItsOwnFarSide(double step) {
        PreparedScene scene = prepared("sph 0 0 0 5 1");
        ShaftQuery query = new ShaftQuery(scene, ShaftQuery.Use.LINES, 1);
        for (double angle = 0; angle < 1.5; angle += step) {
            Vector normal = new Vector(Math.sin(angle), Math.cos(angle), 0);
            Hit hit = new HitRecord(0, 0, normal.times(5), 0x1p-46, normal, Departure.OUTWARD).toHit();
            assertRemembered(query, scene, hit, new Vector(0, 10, 0), 1);
        }
        assertEquals(0, leastShare);
    }

    @Test
    void fromTheSecondPointOnAFreeLightNeedsNoShaft() {
        int settledWithoutAim = 0;
        ShaftQuery query = new ShaftQuery(prepared("pln 0 1 0 0 1\nsph 9 5 0 1 1\nbox -9 5 0 2 1\n"
            + "trg 9 5 0 9 4 2 8 5 0 1"), ShaftQuery.Use.LINES, 1);
        Vector light = new Vector(0, 10, 0);
        for (int i = 0; i < 3; i++) {
            share(query, floorPoint(0.01 * i, 0), light, 1, 1);
            settledWithoutAim += query.shaft.hit.x() == 0.01 * i ? 0 : 1;
        }
        assertEquals(2, settledWithoutAim);
        assertTrue(query.isSettled());
    }

    @ParameterizedTest
    @ValueSource(strings = {"sph 0.5 2 0 0.5 1", "box 0.5 2 0 1 1", "trg 0 2 -1 0 2 1 1 2 0 1"})
    void whatHidTheLightFromAnotherPointIsForgottenWhereItIsFree(String surface) {
        PreparedScene scene = prepared("pln 0 1 0 0 2\npln 0 1 0 -1 1\n" + surface);
        Hit below = new HitRecord(1, 0, new Vector(0, -1, 0), 0x1p-48, new Vector(0, 1, 0), Departure.OUTWARD).toHit();
        ShaftQuery query = new ShaftQuery(scene, ShaftQuery.Use.LINES, 1);
        for (int i = 0; i < 5; i++) {
            assertRemembered(query, scene, floorPoint(-5 + 0.01 * i, 0), new Vector(0, 10, 0), 1);
            assertRemembered(query, scene, below, new Vector(0, 10, 0), 1);
        }
        assertTrue(leastShare < 0.69 * ROOT * ROOT, () -> leastShare + " lines");
    }

    /** 45 of each kind, too few for hierarchies, and together more than exact shadows take on. */
    @Test
    void aCrowdIsTooMuchForTheSecondPointAsForTheFirst() {
        StringBuilder lines = new StringBuilder("pln 0 1 0 0 1\n");
        for (int i = 0; i < 45; i++) {
            String place = (i % 9 - 4) / 20.0 + " 5 " + (i / 9 - 2) / 10.0;
            lines.append("sph ").append(place).append(" 0.01 1\nbox ").append(place).append(" 0.015 1\ntrg ").append(place)
                .append(" 0.01 5.1 0.007 0.33 5 0.21 1\n");
        }
        ShaftQuery query = new ShaftQuery(prepared(lines.toString()), ShaftQuery.Use.AREAS, 1);
        for (int i = 0; i < 3; i++) {
            query.aim(floorPoint(0.01 * i, 0), 0, 0, 10, 0, 0x1p-48, 2);
            assertFalse(query.isSorted());
        }
    }

    @Test
    void aFarPointAnotherSurfaceAndALargerErrorAreNotNear() {
        NearbyShafts shafts = new NearbyShafts();
        shafts.begin(0, floorPoint(0, 0), 0, 10, 0, 0x1p-48, 1);
        assertTrue(shafts.holds(0, floorPoint(0.5, 0)));
        assertFalse(shafts.holds(1, floorPoint(0.5, 0)));
        assertFalse(shafts.holds(0, floorPoint(0.7, 0)));
        assertFalse(shafts.holds(0, new HitRecord(1, 0, Vector.ZERO, 0x1p-48, new Vector(0, 1, 0), Departure.OUTWARD).toHit()));
        assertFalse(shafts.holds(0, new HitRecord(0, 0, Vector.ZERO, 0x1p-40, new Vector(0, 1, 0), Departure.OUTWARD).toHit()));
        shafts.clear();
        assertFalse(shafts.holds(0, floorPoint(0.5, 0)));
    }
}
