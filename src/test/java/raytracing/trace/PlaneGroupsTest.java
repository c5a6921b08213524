package raytracing.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.SceneText;
import raytracing.math.Vector;
import raytracing.parallel.ForkJoin;
import raytracing.scene.Scene;
import raytracing.surface.Hit;
import raytracing.surface.Plane;
import raytracing.surface.RayRecord;

/** Planes in groups, beside the same planes asked one by one. */
class PlaneGroupsTest {
    private static final int RAYS = 300;
    private static final String HEAD = """
        cam 0 0 -5 0 0 0 0 1 0 1 1
        set 0 0 0 1 1
        mtl 1 1 1 0 0 0 0 0 0 1 0
        mtl 1 1 1 0 0 0 0 0 0 1 0.5
        """;

    /** Planes of many sizes: through the world's origin and far away, coincident and nearly so, along the axes and aslant. */
    private static Scene scene(int planes, double scale, Random random) {
        StringBuilder lines = new StringBuilder(HEAD);
        for (int i = 0; i < planes; i++) {
            boolean isAlongAxes = random.nextInt(3) == 0;
            int axis = random.nextInt(3);
            double x = isAlongAxes ? axis == 0 ? 1 : 0 : random.nextGaussian();
            double y = isAlongAxes ? axis == 1 ? 1 : 0 : random.nextGaussian();
            double z = isAlongAxes ? axis == 2 ? 1 : 0 : random.nextGaussian();
            double size = Math.scalb(1.0, random.nextInt(6) - 3);
            double offset = isAlongAxes ? random.nextInt(5) - 2 : 3 * random.nextGaussian() * random.nextInt(3);
            lines.append("pln ").append(size * x).append(' ').append(size * y).append(' ').append(size * z).append(' ')
                .append(scale * size * offset).append(' ').append(1 + random.nextInt(2)).append('\n');
        }
        return SceneText.scene(lines.toString());
    }

    private static PreparedScene oneByOne(Scene scene) {
        return new PreparedScene(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT, EnumSet.noneOf(Shortcut.class),
            ForkJoin.sequential());
    }

    private static PreparedScene inGroups(Scene scene) {
        PreparedScene prepared = Queries.prepared(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
        assertTrue(prepared.planes().groups().isPresent());
        return prepared;
    }

    /** From points with whole coordinates rays start on planes and run along them. */
    private static Vector vector(double scale, Random random) {
        return random.nextBoolean()
            ? new Vector(scale * (random.nextInt(5) - 2), scale * (random.nextInt(5) - 2), scale * (1 + random.nextInt(3)))
            : new Vector(scale * random.nextGaussian(), scale * random.nextGaussian(), scale * random.nextGaussian());
    }

    @ParameterizedTest
    @ValueSource(ints = {16, 17, 63, 200, 1000})
    void raysMeetTheSameSurfacesAtTheSamePoints(int planes) {
        Random random = new Random(planes);
        Scene scene = scene(planes, 1, random);
        RayQuery expected = new RayQuery(oneByOne(scene));
        RayQuery actual = new RayQuery(inGroups(scene));
        for (int i = 0; i < RAYS; i++) {
            RayRecord ray = new RayRecord(vector(2, random), vector(1, random));
            Queries.start(expected, ray);
            Queries.start(actual, ray);
            int steps = 0;
            while (expected.advance() && steps++ < 5) {
                assertTrue(actual.advance());
                assertEquals(Queries.hit(expected), Queries.hit(actual));
            }
        }
    }

    /** At the ends of the numbers, too, where squares and products of lengths do not fit into doubles. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-300, 1e-20, 1, 1e20, 1e300})
    void asMuchLightComesThrough(double scale) {
        Random random = new Random(5);
        Scene scene = scene(100, scale, random);
        SegmentQuery expected = new SegmentQuery(oneByOne(scene), 1);
        SegmentQuery actual = new SegmentQuery(inGroups(scene), 1);
        RayQuery rays = new RayQuery(oneByOne(scene));
        int met = 0;
        for (int i = 0; i < RAYS; i++) {
            Queries.start(rays, new RayRecord(vector(2 * scale, random), vector(1, random)));
            if (rays.advance()) {
                met++;
                Hit hit = rays.hit();
                Vector end = vector(2 * scale, random);
                double error = random.nextBoolean() ? 0 : scale * 0x1p-30;
                assertEquals(expected.transmittance(hit, 0, end.x(), end.y(), end.z(), error),
                    actual.transmittance(hit, 0, end.x(), end.y(), end.z(), error));
            }
        }
        assertTrue(met > RAYS / 2, met + " rays met a plane");
    }

    /** Planes of the same direction, or all the same, cannot be told apart by a turn. */
    @Test
    void equalPlanesAreFoundInTheOrderOfTheScene() {
        Scene scene = SceneText.scene(HEAD + "pln 0 0 1 3 2\n".repeat(40));
        RayQuery query = new RayQuery(inGroups(scene));
        Queries.start(query, new RayRecord(Vector.ZERO, new Vector(0, 0, 1)));
        List<Integer> met = new ArrayList<>();
        while (query.advance()) {
            met.add(Queries.hit(query).surface());
        }
        assertEquals(IntStream.range(0, 40).boxed().toList(), met);
    }

    /** Twice as many planes around a room cost a short line inside hardly more. */
    @Test
    void aLineLeavesOutThePlanesThatItDoesNotReach() {
        int few = mostVisited(5_000);
        int many = mostVisited(20_000);
        assertTrue(few < 5_000 / 20 && many < 20_000 / 40, few + " and " + many + " planes");
    }

    /** Planes in the leaves that lines from the middle half way to the walls visit, at most. */
    private static int mostVisited(int count) {
        Random random = new Random(1);
        Plane[] planes = new Plane[count];
        for (int i = 0; i < count; i++) {
            Vector outwards = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
            planes[i] = new Plane(outwards, outwards.length() * (10 + random.nextDouble()), 0);
        }
        PlaneGroups groups = PlaneGroups.of(planes, new int[count]);
        int most = 0;
        for (int i = 0; i < 100; i++) {
            Vector way = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
            double part = 5 / way.length();
            int visited = 0;
            long place = PlaneGroups.START;
            do {
                place = groups.next(place, 0, 0, 0, 0x1p-40, part * way.x(), part * way.y(), part * way.z(), 0, 1);
                visited += place == PlaneGroups.END ? 0 : groups.to(place) - groups.from(place);
            } while (place != PlaneGroups.END);
            most = Math.max(most, visited);
        }
        return most;
    }
}
