package raytracing.shadow;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.BiFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.Meshes;
import raytracing.SceneText;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.parallel.ForkJoin;
import raytracing.surface.Departure;
import raytracing.surface.Hit;
import raytracing.surface.HitRecord;
import raytracing.surface.PointError;
import raytracing.surface.RayRecord;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;
import raytracing.trace.PreparedScene;
import raytracing.trace.Queries;
import raytracing.trace.RayQuery;
import raytracing.trace.SegmentQuery;
import raytracing.trace.ShadowMode;
import raytracing.trace.Shortcut;

/** Whatever a shaft knows beforehand, its lines get the answers that each of them would get alone, bit for bit. */
class ShaftQueryTest {
    private static final String HEAD = """
        cam 0 0 -5 0 0 0 0 1 0 1 1
        set 0 0 0 1 1
        mtl 1 1 1 0 0 0 0 0 0 1 0
        mtl 1 1 1 0 0 0 0 0 0 1 0.7
        mtl 1 1 1 0 0 0 0 0 0 1 0.3
        mtl 1 1 1 0 0 0 0 0 0 1 0.9
        """;

    private static final String HUGE_TRIANGLE = "trg -9 5 -9 9 5 -9 0 5 9 1";

    /** How often each kind of shaft came up in a test: a test of settled shafts alone, or of none, shows nothing. */
    private int settled;
    private int open;
    private int partlyCovered;

    private static PreparedScene prepared(String surfaces, EnumSet<Shortcut> shortcuts) {
        return new PreparedScene(SceneText.scene(HEAD + surfaces), ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT, shortcuts,
            ForkJoin.sequential());
    }

    private static String crowd(SplittableRandom random, int size, int materials, double spread) {
        String[] codes = {"sph", "sph", "box", "pln"};
        StringBuilder lines = new StringBuilder();
        for (int i = 0; i < size; i++) {
            lines.append(codes[random.nextInt(codes.length)]).append(' ').append(random.nextDouble(-spread, spread))
                .append(' ').append(random.nextDouble(-spread, spread)).append(' ')
                .append(random.nextDouble(-spread, spread)).append(' ').append(random.nextDouble(0.2, 2)).append(' ')
                .append(random.nextInt(1, materials + 1)).append('\n');
        }
        return lines.toString();
    }

    /** Surfaces with round numbers, which touch, coincide and have lights and points exactly on them. */
    private static String grid(SplittableRandom random, int size, int materials) {
        String[] codes = {"sph", "sph", "box", "box", "pln"};
        StringBuilder lines = new StringBuilder();
        for (int i = 0; i < size; i++) {
            lines.append(codes[random.nextInt(codes.length)]);
            for (int k = 0; k < 3; k++) {
                lines.append(' ').append(random.nextInt(-2, 3));
            }
            lines.append(' ').append(random.nextInt(1, 4)).append(' ').append(random.nextInt(1, materials + 1)).append('\n');
        }
        return lines.toString().replaceAll("pln 0 0 0", "pln 0 1 0");
    }

    private static Vector vector(SplittableRandom random, double size) {
        return new Vector(random.nextDouble(-size, size), random.nextDouble(-size, size), random.nextDouble(-size, size));
    }

    private static Vector rounded(Vector v) {
        return new Vector(Math.rint(v.x()), Math.rint(v.y()), Math.rint(v.z()));
    }

    private void assertSameBits(PreparedScene scene, Hit point, Vector light, double width, SplittableRandom random) {
        ShaftQuery query = new ShaftQuery(scene, ShaftQuery.Use.LINES, 1);
        SegmentQuery line = new SegmentQuery(scene, 1);
        double error = PointError.written(light);
        query.aim(point, 0, light.x(), light.y(), light.z(), error, width);
        double first = -1;
        boolean isPartlyCovered = false;
        for (int i = 0; i < 20; i++) {
            // the corners and the middles of the edges, which no random sample meets, then random points
            double x = i < 9 ? (i / 3 - 1) * width / 2 : random.nextDouble(-width, width) / 2;
            double y = i < 9 ? (i % 3 - 1) * width / 2 : random.nextDouble(-width, width) / 2;
            double found = query.isSettled() ? query.settledTransmittance() : ShadowQueries.transmittance(query, x, y);
            Shaft shaft = query.shaft;
            double expected = line.transmittance(point, 0, shaft.endX(x, y), shaft.endY(x, y), shaft.endZ(x, y), error);
            assertEquals(expected, found, () -> HitRecord.of(point, 0) + " to " + light + ", width " + width);
            isPartlyCovered |= first >= 0 && expected != first;
            first = expected;
        }
        settled += query.isSettled() ? 1 : 0;
        open += query.isSettled() ? 0 : 1;
        partlyCovered += isPartlyCovered ? 1 : 0;
    }

    private void assertBothKindsCameUp(int atLeast) {
        assertTrue(settled >= atLeast && open >= atLeast && partlyCovered >= atLeast / 4,
            () -> settled + " settled, " + open + " open, " + partlyCovered + " partly covered");
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 4})
    void shaftsInACrowd(int materials) {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 300; i++) {
            PreparedScene scene = prepared(crowd(random, random.nextInt(1, 9), materials, 4), EnumSet.allOf(Shortcut.class));
            shafts(scene, random, false);
        }
        assertBothKindsCameUp(200);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 4})
    void shaftsBetweenSurfacesThatTouch(int materials) {
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < 300; i++) {
            PreparedScene scene = prepared(grid(random, random.nextInt(1, 8), materials), EnumSet.allOf(Shortcut.class));
            shafts(scene, random, true);
        }
        assertBothKindsCameUp(100);
    }

    private void shafts(PreparedScene scene, SplittableRandom random, boolean roundLights) {
        RayQuery walk = new RayQuery(scene);
        for (int i = 0; i < 12; i++) {
            Vector eye = roundLights ? rounded(vector(random, 6)) : vector(random, 6);
            Queries.start(walk, new RayRecord(eye, vector(random, 1)));
            Vector light = roundLights ? rounded(vector(random, 4)) : vector(random, 8);
            double width = roundLights ? random.nextInt(1, 5) : random.nextDouble(0.01, 3);
            if (walk.advance() && light.minus(Queries.hit(walk).point()).length() > 1e-9) {
                assertSameBits(scene, walk.hit(), light, width, random);
            }
        }
    }

    private void shaftsAmong(int seed, int materials, int scenes, boolean isOnSurfaces, int atLeast,
                             BiFunction<RandomTriangles, SplittableRandom, String> lines) {
        SplittableRandom random = new SplittableRandom(seed);
        RandomTriangles triangles = new RandomTriangles(random, materials);
        for (int i = 0; i < scenes; i++) {
            shafts(prepared(lines.apply(triangles, random), EnumSet.allOf(Shortcut.class)), random, isOnSurfaces);
        }
        assertBothKindsCameUp(atLeast);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 4})
    void shaftsInACrowdOfTriangles(int materials) {
        shaftsAmong(11, materials, 400, false, 200, (triangles, random) -> triangles.crowd(random.nextInt(1, 12), 4));
    }

    /** Neighbours in one plane, twins, shared edges and corners, lights and points on all of them. */
    @ParameterizedTest
    @ValueSource(ints = {1, 4})
    void shaftsBetweenTrianglesThatTouch(int materials) {
        shaftsAmong(12, materials, 400, true, 100, (triangles, random) -> triangles.grid(random.nextInt(1, 8)));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 4})
    void shaftsBetweenMeshes(int materials) {
        shaftsAmong(13, materials, 80, false, 60, (triangles, random) -> triangles.meshes(1));
    }

    /** Hits on the edges and corners of meshes, which touch several triangles, and very near to them. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-16, 1e-14, 1e-9})
    void shaftsFromEdgesAndCornersOfMeshes(double aside) {
        SplittableRandom random = new SplittableRandom(14);
        RandomTriangles triangles = new RandomTriangles(random, 3);
        for (int i = 0; i < 60; i++) {
            PreparedScene scene = prepared(triangles.meshes(1), EnumSet.allOf(Shortcut.class));
            RayQuery walk = new RayQuery(scene);
            for (int k = 0; k < 12; k++) {
                Triangle triangle = (Triangle) scene.surface(random.nextInt(20));
                Vector onEdge = Vectors.plus(triangle.a(), random.nextInt(3) / 2.0, triangle.b().minus(triangle.a()));
                Vector eye = vector(random, 5);
                Queries.start(walk, new RayRecord(eye, Vectors.plus(onEdge, aside, vector(random, 2)).minus(eye)));
                Vector light = vector(random, 6);
                if (walk.advance() && light.minus(Queries.hit(walk).point()).length() > 1e-9) {
                    assertSameBits(scene, walk.hit(), light, random.nextDouble(0.01, 3), random);
                }
            }
        }
        assertBothKindsCameUp(40);
    }

    /** Far from the world's origin, rounding hides more and more, and the shaft must know how much: points lie on twins. */
    @ParameterizedTest
    @ValueSource(doubles = {1e3, 1e6, 1e9, 1e12})
    void shaftsBetweenTrianglesFarFromTheOriginOfTheWorld(double far) {
        SplittableRandom random = new SplittableRandom(15);
        Vector middle = new Vector(far, -far / 3, far / 7);
        for (int i = 0; i < 400; i++) {
            Vector a = Vectors.plus(middle, vector(random, 1));
            Vector b = Vectors.plus(middle, vector(random, 1));
            Vector c = Vectors.plus(middle, vector(random, 1));
            Vector d = Vectors.plus(middle, vector(random, 2));
            if (Triangle.areOnALine(a, b, c) || Triangle.areOnALine(b, c, d) || Triangle.areOnALine(c, a, d)) {
                continue;
            }
            PreparedScene scene = prepared(Meshes.triangle(a, b, c, 1) + Meshes.triangle(c, a, b, 2)
                + Meshes.triangle(b, c, d, 3) + Meshes.triangle(c, a, d, 1), EnumSet.allOf(Shortcut.class));
            Vector eye = Vectors.plus(vector(random, 3), middle);
            RayQuery walk = new RayQuery(scene);
            Queries.start(walk, new RayRecord(eye, Vectors.plus(middle, vector(random, 0.5)).minus(eye)));
            Vector light = Vectors.plus(vector(random, 5), middle);
            if (walk.advance() && light.minus(Queries.hit(walk).point()).length() > 0.01) {
                assertSameBits(scene, walk.hit(), light, random.nextDouble(0.1, 2), random);
            }
        }
        assertTrue(open > 10, () -> open + " open");
    }

    /** Far from the world's origin, rounding hides more and more, and the shaft must know how much: points lie on twins. */
    @ParameterizedTest
    @ValueSource(doubles = {1e3, 1e6, 1e9, 1e12})
    void shaftsFarFromTheOriginOfTheWorld(double far) {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 400; i++) {
            String ball = "sph " + far + " 0 0 " + random.nextDouble(0.1, 1.5);
            String box = "box " + (far + 1) + " 1 " + random.nextDouble(-1, 1) + " 0.7";
            String surfaces = ball + " 1\n" + ball + " 2\n" + box + " 2\n" + box + " 3\npln 1 0.1 0 " + (far - 1.5)
                + " 3\nsph " + (far + 0.5) + " 2 0.3 0.4 4";
            PreparedScene scene = prepared(surfaces, EnumSet.allOf(Shortcut.class));
            Vector middle = new Vector(far, 0, 0);
            Vector eye = Vectors.plus(vector(random, 3), middle);
            RayQuery walk = new RayQuery(scene);
            Queries.start(walk, new RayRecord(eye, Vectors.plus(middle, vector(random, 1)).minus(eye)));
            Vector light = Vectors.plus(vector(random, 5), middle);
            if (walk.advance() && light.minus(Queries.hit(walk).point()).length() > 0.01) {
                assertSameBits(scene, walk.hit(), light, random.nextDouble(0.1, 2), random);
            }
        }
    }

    /** Spheres that just touch one of the shaft's edges or the middle of a wall from outside, or just do not. */
    @ParameterizedTest
    @ValueSource(doubles = {-1e-3, -1e-9, -1e-13, -1e-15, 0, 1e-15, 1e-13, 1e-9, 1e-3})
    void spheresThatBarelyTouchTheShaft(double beyond) {
        SplittableRandom random = new SplittableRandom(4);
        HitRecord floor = new HitRecord(0, 0, Vector.ZERO, 0x1p-51, new Vector(0, 1, 0), Departure.OUTWARD);
        for (int i = 0; i < 400; i++) {
            Vector light = new Vector(random.nextDouble(-3, 3), 10, random.nextDouble(-3, 3));
            Vectors.Axes square = Vectors.around(light);
            Vector corner = Vectors.plus(square.u().times(random.nextBoolean() ? 1 : -1), random.nextInt(-1, 2), square.v());
            Vector end = Vectors.plus(light, corner);
            Vector touched = end.times(random.nextDouble(0.1, 1));
            Vector along = end.unit();
            Vector aside = Vectors.plus(corner, -corner.dot(along), along).unit();
            double r = random.nextDouble(0.01, 2);
            Vector centre = Vectors.plus(touched, r * (1 + beyond), aside);
            PreparedScene scene = prepared("pln 0 1 0 0 1\nsph " + centre.x() + " " + centre.y() + " " + centre.z() + " "
                + r + " " + (1 + i % 2), EnumSet.allOf(Shortcut.class));
            assertSameBits(scene, floor.toHit(), light, 2, random);
        }
    }

    /** Triangles with an edge along one of the shaft's walls, or a corner on one of its edges, from outside or just within. */
    @ParameterizedTest
    @ValueSource(doubles = {-1e-3, -1e-9, -1e-13, -1e-15, 0, 1e-15, 1e-13, 1e-9, 1e-3})
    void trianglesThatBarelyTouchTheShaft(double beyond) {
        SplittableRandom random = new SplittableRandom(16);
        HitRecord floor = new HitRecord(0, 0, Vector.ZERO, 0x1p-51, new Vector(0, 1, 0), Departure.OUTWARD);
        for (int i = 0; i < 400; i++) {
            Vector light = new Vector(random.nextDouble(-3, 3), 10, random.nextDouble(-3, 3));
            Vectors.Axes square = Vectors.around(light);
            Vector aside = square.u().times(random.nextBoolean() ? 1 : -1);
            double grown = 1 + beyond;
            Vector first = Vectors.plus(light, grown, Vectors.plus(aside, random.nextDouble(-1, 1), square.v()));
            Vector second = Vectors.plus(light, grown, Vectors.plus(aside, random.nextInt(-1, 2), square.v()));
            Vector a = first.times(random.nextDouble(0.1, 1.2));
            Vector b = random.nextBoolean() ? second.times(random.nextDouble(0.1, 1))
                : Vectors.plus(a, random.nextDouble(3), Vectors.plus(aside, vector(random, 1)));
            Vector c = Vectors.plus(a, random.nextDouble(3), Vectors.plus(aside, vector(random, 1)));
            PreparedScene scene = prepared("pln 0 1 0 0 1\n" + Meshes.triangle(a, b, c, 1 + i % 2),
                EnumSet.allOf(Shortcut.class));
            assertSameBits(scene, floor.toHit(), light, 2, random);
        }
        assertTrue(open > (beyond < 1e-9 ? 50 : 5), () -> settled + " settled, " + open + " open");
    }

    /** The switches: with each shortcut left out alone, the answers are the same. */
    @ParameterizedTest
    @EnumSource(Shortcut.class)
    void everyShortcutCanBeLeftOut(Shortcut shortcut) {
        SplittableRandom random = new SplittableRandom(5);
        EnumSet<Shortcut> others = EnumSet.complementOf(EnumSet.of(shortcut));
        for (int i = 0; i < 60; i++) {
            shafts(prepared(crowd(random, 6, 3, 4), others), random, false);
            shafts(prepared(new RandomTriangles(random, 3).crowd(8, 4), others), random, false);
            shafts(prepared(new RandomTriangles(random, 3).grid(4), others), random, true);
        }
        assertTrue(open > 20, () -> open + " open");
    }

    @Test
    void aLightThatNothingTouchesIsSettledWithoutALine() {
        PreparedScene scene = prepared("pln 0 1 0 0 1\nsph 5 5 0 1 1\nbox -5 5 0 2 1\npln 0 1 0 20 1",
            EnumSet.allOf(Shortcut.class));
        assertSettled(1, scene);
    }

    /**
     * One before each wall of the shaft, two behind the light, one of which comes near it further out, one below the floor, one
     * in its plane and near the point, and one in another plane through it.
     */
    @Test
    void trianglesBesideTheLightSettleItWithoutALine() {
        assertSettled(1, prepared("""
            pln 0 1 0 0 1
            trg 2 5 0 9 5 1 9 6 -1 1
            trg -2 5 0 -9 5 1 -9 6 -1 1
            trg 0 5 2 1 5 9 -1 6 9 1
            trg 0 5 -2 1 5 -9 -1 6 -9 1
            trg -9 11 -9 9 11 -9 0 11 9 1
            trg -9 9 -9 -9 9 9 20 13.8 0 1
            trg -9 -1 -9 9 -1 -9 0 -1 9 1
            trg 3 0 -1 -1 0 3 5 0 5 1
            trg 2 5 0 9 5 0 9 6 0 1
            """, EnumSet.allOf(Shortcut.class)));
    }

    @Test
    void glassTrianglesBeforeTheWholeLightSettleItToo() {
        assertSettled(0.7 * 0.3, prepared("pln 0 1 0 0 1\ntrg -9 5 -9 9 5 -9 0 5 9 2\ntrg 0 6 9 -9 6 -9 9 6 -9 3",
            EnumSet.allOf(Shortcut.class)));
    }

    /** With a new kind of surface this fails until a shaft knows it. */
    @Test
    void everyKindOfSurfaceCastsAShadow() {
        Set<Class<?>> kinds = new HashSet<>();
        for (String surface : List.of("sph 0 5 0 2 1", "box 0 5 0 4 1", "pln 0 1 0 5 1", HUGE_TRIANGLE)) {
            PreparedScene scene = prepared("pln 0 1 0 0 1\n" + surface, EnumSet.allOf(Shortcut.class));
            assertSettled(0, scene);
            kinds.add(scene.surface(1).getClass());
        }
        assertEquals(kindsOf(Surface.class), kinds);
    }

    private static Set<Class<?>> kindsOf(Class<?> type) {
        if (!type.isSealed()) {
            return Set.of(type);
        }
        Set<Class<?>> kinds = new HashSet<>();
        for (Class<?> permitted : type.getPermittedSubclasses()) {
            kinds.addAll(kindsOf(permitted));
        }
        return kinds;
    }

    @ParameterizedTest
    @ValueSource(strings = {"sph 0 5 0 2 1", "box 0.1 5 0 4 1", "pln 0.1 1 0 5 1", HUGE_TRIANGLE})
    void aSurfaceBeforeTheWholeLightSettlesItInTheDark(String surface) {
        assertSettled(0, prepared("pln 0 1 0 0 1\n" + surface + "\nsph 0.5 8 0 0.3 2", EnumSet.allOf(Shortcut.class)));
    }

    @Test
    void glassBeforeTheWholeLightSettlesItToo() {
        assertSettled(0.7 * 0.3, prepared("pln 0 1 0 0 1\nsph 0 5 0 2 2\nsph 0 0 0 4 3", EnumSet.allOf(Shortcut.class)));
    }

    private static void assertSettled(double expected, PreparedScene scene) {
        Hit floor = new HitRecord(0, 0, Vector.ZERO, 0x1p-51, new Vector(0, 1, 0), Departure.OUTWARD).toHit();
        ShaftQuery shaft = new ShaftQuery(scene, ShaftQuery.Use.LINES, 1);
        shaft.aim(floor, 0, 0, 10, 0, 0x1p-48, 2);
        assertTrue(shaft.isSettled());
        assertEquals(expected, shaft.settledTransmittance());
    }

    /** So many surfaces in one shaft that its lines are tested against the scene one by one. */
    @Test
    void aShaftFullOfSurfaces() {
        SplittableRandom random = new SplittableRandom(6);
        StringBuilder beads = new StringBuilder("pln 0 1 0 0 1\n");
        for (int i = 0; i < 200; i++) {
            beads.append("sph ").append(random.nextDouble(-1, 1)).append(' ').append(random.nextDouble(1, 9)).append(' ')
                .append(random.nextDouble(-1, 1)).append(" 0.05 ").append(random.nextInt(2, 5)).append('\n');
        }
        HitRecord floor = new HitRecord(0, 0, Vector.ZERO, 0x1p-51, new Vector(0, 1, 0), Departure.OUTWARD);
        for (int i = 0; i < 20; i++) {
            assertSameBits(prepared(beads.toString(), EnumSet.allOf(Shortcut.class)), floor.toHit(), new Vector(0, 10, 0), 2,
                random);
        }
    }

    @Test
    void aShaftFullOfTriangles() {
        SplittableRandom random = new SplittableRandom(17);
        StringBuilder lines = new StringBuilder("pln 0 1 0 0 1\n");
        for (int i = 0; i < 200; i++) {
            Vector a = new Vector(random.nextDouble(-1, 1), random.nextDouble(1, 9), random.nextDouble(-1, 1));
            lines.append(Meshes.triangle(a, Vectors.plus(a, vector(random, 0.2)), Vectors.plus(a, vector(random, 0.2)),
                random.nextInt(2, 5)));
        }
        HitRecord floor = new HitRecord(0, 0, Vector.ZERO, 0x1p-51, new Vector(0, 1, 0), Departure.OUTWARD);
        for (int i = 0; i < 20; i++) {
            assertSameBits(prepared(lines.toString(), EnumSet.allOf(Shortcut.class)), floor.toHit(), new Vector(0, 10, 0), 2,
                random);
        }
        assertTrue(partlyCovered == 20, () -> partlyCovered + " partly covered");
    }
}
