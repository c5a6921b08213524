package raytracing;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.render.RenderSettings;
import raytracing.scene.Camera;
import raytracing.scene.Light;
import raytracing.scene.Material;
import raytracing.scene.Pinhole;
import raytracing.scene.Scene;
import raytracing.scene.Settings;
import raytracing.shadow.ShadowMethod;

/**
 * No light enters a closed mesh of triangles, and no ray leaves it, not even through an edge or a corner that it meets exactly.
 * So all pictures here are black.
 */
class ClosedMeshesTest {
    private static final int SIZE = 31;
    private static final Color WHITE = new Color(1, 1, 1);
    private static final Color HALF = new Color(0.5, 0.5, 0.5);
    private static final Material MATTE = new Material(WHITE, HALF, Color.BLACK, 2, 0, Color.BLACK);
    private static final Material HALF_A_MIRROR = new Material(WHITE, HALF, HALF, 2, 0, Color.BLACK);

    /** The rounding of a sum of areas. */
    private static final double ROUNDING = 1e-9;

    /**
     * And that of hit points far from the world's origin, 16 u of the way there: next to an edge, the triangle beyond it is
     * seen at an angle that is off by so much over the distance to the edge. A hundredth of what a picture of 8 bits shows.
     */
    private static final double ROUNDING_OF_PLACES = 2e-11;

    private static final double NOTHING = 0;

    /** What remains of a white sky after 12 reflections by half a mirror. */
    private static final double AFTER_12_REFLECTIONS = 1.0 / 4096 + ROUNDING;

    /** Each mesh as it is, tiny, huge, far from the world's origin, and turned. */
    static Stream<ClosedMesh> meshes() {
        return Stream.of(ClosedMesh.tetrahedron(), ClosedMesh.octahedron(), ClosedMesh.cube(), ClosedMesh.ball(0),
            ClosedMesh.ball(2), ClosedMesh.star(1), ClosedMesh.ring(24, 12)).flatMap(mesh -> Stream.of(mesh,
            mesh.moved(" * 1e-9", p -> p.times(1e-9)), mesh.moved(" * 1e9", p -> p.times(1e9)),
            mesh.moved(" a million radii away", p -> Vectors.plus(p, new Vector(1e6, -3e5, 7e5))),
            mesh.moved(" turned", ClosedMesh.turn(1)),
            mesh.moved(" turned, tiny and far", after(ClosedMesh.turn(2),
                p -> Vectors.plus(p, new Vector(-7e5, 1e6, 4e5)).times(1e-9)))));
    }

    static Stream<ClosedMesh> convexMeshes() {
        return meshes().filter(mesh -> !mesh.name().startsWith("star") && !mesh.name().startsWith("ring"));
    }

    private static UnaryOperator<Vector> after(UnaryOperator<Vector> first, UnaryOperator<Vector> second) {
        return p -> second.apply(first.apply(p));
    }

    static Stream<ClosedMesh> largeMeshes() {
        return Stream.of(ClosedMesh.ball(5), ClosedMesh.star(4), ClosedMesh.ring(500, 100),
            ClosedMesh.ball(5).moved(" turned", ClosedMesh.turn(3)));
    }

    @ParameterizedTest
    @MethodSource({"meshes", "largeMeshes"})
    void noLampLightsAMatteMeshFromOutsideAndNoSkyIsSeen(ClosedMesh mesh) {
        assertBlack(mesh, NOTHING, WHITE, 0, MATTE, ShadowMethod.Sampled.withRoot(1));
    }

    @ParameterizedTest
    @MethodSource("meshes")
    void noWideLampLightsAMatteMeshFromOutside(ClosedMesh mesh) {
        assertBlack(mesh, NOTHING, WHITE, 0, MATTE, ShadowMethod.Sampled.withRoot(3));
        double places = mesh.eyes().get(0).largestPart() / mesh.reach();
        assertBlack(mesh, ROUNDING + ROUNDING_OF_PLACES * places, WHITE, 0, MATTE, new ShadowMethod.Exact());
    }

    @ParameterizedTest
    @MethodSource("meshes")
    void noMirrorShowsALampOrTheSkyOutside(ClosedMesh mesh) {
        assertBlack(mesh, NOTHING, Color.BLACK, 5, HALF_A_MIRROR, ShadowMethod.Sampled.withRoot(1));
        assertBlack(mesh, AFTER_12_REFLECTIONS, WHITE, 12, HALF_A_MIRROR, ShadowMethod.Sampled.withRoot(1));
    }

    /** What faces a point of light on a convex mesh is lit by it, also on an edge beside a face that does not. */
    @ParameterizedTest
    @MethodSource("convexMeshes")
    void noConvexMeshCastsAShadowOnItself(ClosedMesh mesh) {
        for (int i = 0; i < mesh.targets().size(); i++) {
            Vector middle = mesh.eyes().get(0);
            Vector target = mesh.targets().get(i);
            Vector view = middle.minus(target);
            Camera camera = new Camera(Vectors.plus(middle, i % 2 == 0 ? -3 : -20, view), target, upFor(view), 1,
                i % 2 == 0 ? 1 : 0.1, new Pinhole());
            assertArrayEquals(light(mesh, camera, 0), light(mesh, camera, 1), "view " + i);
        }
    }

    /** The picture under lamps outside that are so much darkened by shadows. */
    private static int[] light(ClosedMesh mesh, Camera camera, double shadowIntensity) {
        List<Light> lamps = lampsAround(mesh.eyes().get(0), 4 * mesh.reach()).stream().map(lamp -> new Light(lamp.position(),
            lamp.color(), lamp.specularIntensity(), shadowIntensity, 0)).toList();
        Film film = Steps.renderScene(new Scene(camera, new Settings(HALF, 1, 0, 0), List.of(MATTE), mesh.surfaces(), lamps),
            RenderSettings.DEFAULT.withSize(SIZE, SIZE));
        return IntStream.range(0, SIZE * SIZE).map(i -> film.encoded(i % SIZE, i / SIZE)).toArray();
    }

    private static void assertBlack(ClosedMesh mesh, double mostLight, Color sky, int reflections, Material material,
                                    ShadowMethod method) {
        List<String> lit = new ArrayList<>();
        List<Light> lamps = lampsAround(mesh.eyes().get(0), 4 * mesh.reach());
        List<Vector> targets = mesh.targets();
        for (int i = 0; i < targets.size(); i++) {
            Vector eye = mesh.eyes().get(i % mesh.eyes().size());
            Vector view = targets.get(i).minus(eye);
            Camera camera = new Camera(eye, targets.get(i), upFor(view), 1, i % 2 == 0 ? 3 : 0.5, new Pinhole());
            int count = litPixels(new Scene(camera, new Settings(sky, 1, reflections, 0), List.of(material), mesh.surfaces(),
                lamps), method, mostLight);
            if (count > 0) {
                lit.add(count + " pixels of view " + i);
            }
        }
        assertEquals(List.of(), lit, "lit pixels in " + mesh);
    }

    private static Vector upFor(Vector view) {
        return Math.abs(view.y()) < 0.8 * view.length() ? new Vector(0, 1, 0) : new Vector(1, 0, 0);
    }

    /** On axes and diagonals, and aside. */
    private static List<Light> lampsAround(Vector middle, double far) {
        return Stream.of(new Vector(1, 0, 0), new Vector(0, -1, 0), new Vector(0, 0, 1), new Vector(1, 1, 1),
            new Vector(-1, -1, 1), new Vector(-1, 0.3, -0.8)).map(direction -> new Light(
            Vectors.plus(middle, far, direction), WHITE, 1, 1, far / 3)).toList();
    }

    private static int litPixels(Scene scene, ShadowMethod method, double mostLight) {
        Film film = Steps.renderScene(scene, RenderSettings.DEFAULT.withSize(SIZE, SIZE).withShadowMethod(method));
        int count = 0;
        for (int i = 0; i < SIZE * SIZE; i++) {
            Color color = film.get(i % SIZE, i / SIZE);
            count += color.red() <= mostLight && color.green() <= mostLight && color.blue() <= mostLight ? 0 : 1;
        }
        return count;
    }
}
