package raytracing.numerics;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.surface.RayRecord;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;
import raytracing.trace.PreparedScene;
import raytracing.trace.Queries;
import raytracing.trace.RayQuery;
import raytracing.trace.ShadowMode;

/**
 * Light on a mesh close to its edges and corners, where a rounded point lies on more than one triangle: what the unrounded
 * point sees lights it, and nothing else does. Points are up to an eighth of an edge away from an edge, or on it.
 */
class FoldTest {
    private static final long SEED = 89;
    private static final int CASES = 4_000;

    /** Of any angle here, in radians: so clearly it is not 0. */
    private static final double CLEAR = 0.1;

    /**
     * A ray from a viewer to a mesh, and a light.
     *
     * @param isLit what is known of it, if the ray meets the first triangle
     */
    private record Case(List<Surface> mesh, Vector viewer, Vector target, Vector light, boolean isLit) {
        /** What is wrong, if anything is; nothing also if another triangle hides the first. */
        Optional<String> fault() {
            Vector direction = target.minus(viewer);
            PreparedScene scene = new Encounter(viewer, direction, mesh).prepared(ShadowMode.ALL_SURFACES_STOP_LIGHT);
            RayQuery walk = new RayQuery(scene);
            Queries.start(walk, new RayRecord(viewer, direction));
            if (!walk.advance() || walk.surface() != 0) {
                return Optional.empty();
            }
            boolean isLitByUs = Joint.reachedBy(walk).transmittance(scene, light) > 0;
            Optional<Boolean> isLitExactly = isLitExactly(direction);
            return isLitByUs == isLit && isLitExactly.orElse(isLit) == isLit ? Optional.empty()
                : Optional.of("lit: " + isLit + ", by the product " + isLitByUs + ", exactly " + isLitExactly + ": " + this);
        }

        /** For the real point of the ray, unless it lies on another triangle's plane; all lengths times the crossing's q. */
        private Optional<Boolean> isLitExactly(Vector direction) {
            ExactCrossing crossing = ExactCrossing.first(mesh.get(0), viewer, direction).orElseThrow();
            ExactNumber q = crossing.q();
            ExactPoint point = ExactPoint.of(viewer).times(q).plus(ExactPoint.of(direction).times(crossing.p()));
            List<ExactTriangle> others = mesh.stream().skip(1).map(surface -> ExactTriangle.of((Triangle) surface))
                .map(other -> new ExactTriangle(other.a().times(q), other.u().times(q), other.v().times(q))).toList();
            return others.stream().anyMatch(other -> other.side(point) == 0) ? Optional.empty()
                : Optional.of(others.stream().noneMatch(other -> other.isCrossed(point, ExactPoint.of(light).times(q))));
        }

        boolean isJudged() {
            return ExactCrossing.first(mesh.get(0), viewer, target.minus(viewer)).isPresent();
        }
    }

    /** An edge: a point in the middle of it, its direction, and two directions across it and each other. */
    private record Edge(RandomNumbers random, Vector middle, Vector along, Vector across, Vector up, double size) {
        static Edge of(RandomNumbers random, double size, double away) {
            Vector along = random.direction();
            Vector across = random.perpendicularTo(along);
            Vector place = random.oneIn(3) ? Vector.ZERO : random.vector(away * size);
            return new Edge(random, place, along, across, along.cross(across), size);
        }

        Vector at(double x, double distance, double angle) {
            Vector point = Vectors.plus(middle, size * x, along);
            Vector aside = Vectors.plus(point, size * distance * Math.cos(angle), across);
            return Vectors.plus(aside, size * distance * Math.sin(angle), up);
        }

        /** In the plane of an angle, corners in any order. */
        Triangle triangle(double angle) {
            return new TriangleQuery(middle, along, at(-2, 0, 0), at(2, 0, 0), at(random.between(-1, 1), 2, angle))
                .renamed(random.random().nextInt(6)).triangle();
        }

        Vector somewhere(double angle) {
            return at(random.between(-1, 1), random.between(1, 4), angle);
        }
    }

    /** From 0 to an eighth. */
    private static double closeness(RandomNumbers random) {
        return random.oneIn(4) ? 0 : random.magnitude(-60, -3);
    }

    private static Case fold(RandomNumbers random, double size, double away, double angle, double viewer, double light,
                             boolean isLit) {
        Edge edge = Edge.of(random, size, away);
        return new Case(List.of(edge.triangle(0), edge.triangle(angle)), edge.somewhere(viewer),
            edge.at(random.between(-1, 1), closeness(random), 0), edge.somewhere(light), isLit);
    }

    /**
     * The second triangle is below the plane of the first. A point on a sharper edge than 60 degrees may be so near to both
     * triangles, and still within them, that only sides of their planes are told; there viewer and light see the same sides.
     */
    private static Case convex(RandomNumbers random, double size, double away) {
        double angle = random.between(Math.PI + CLEAR, 2 * Math.PI - CLEAR);
        double viewer = random.between(CLEAR, Math.PI - CLEAR);
        double light = random.between(CLEAR, Math.PI - CLEAR);
        boolean isSharp = angle > 5.0 / 3 * Math.PI;
        return isSharp && viewer < angle - Math.PI != light < angle - Math.PI ? convex(random, size, away)
            : fold(random, size, away, angle, viewer, light, true);
    }

    /** The second triangle is above the plane of the first, and the light in front of both. */
    private static Case concave(RandomNumbers random, double size, double away) {
        double angle = random.between(3 * CLEAR, Math.PI - CLEAR);
        return fold(random, size, away, angle, random.between(CLEAR, angle - CLEAR), random.between(CLEAR, angle - CLEAR),
            true);
    }

    /** The light is behind the second triangle. */
    private static Case hidden(RandomNumbers random, double size, double away) {
        double angle = random.between(3 * CLEAR, Math.PI - 3 * CLEAR);
        return fold(random, size, away, angle, random.between(CLEAR, angle - CLEAR),
            random.between(angle + CLEAR, Math.PI - CLEAR), false);
    }

    private static void assertRight(Function<RandomNumbers, Case> recipe) {
        RandomNumbers random = new RandomNumbers(new SplittableRandom(SEED));
        List<Case> cases = Stream.generate(() -> recipe.apply(random)).limit(CASES).toList();
        long judged = cases.stream().filter(Case::isJudged).count();
        assertTrue(judged > CASES / 4, judged + " points judged");
        Failures.assertNone(cases.parallelStream().filter(Case::isJudged).flatMap(one -> one.fault().stream()));
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "1e-9, 1", "1e12, 1", "1, 1e3", "1, 1e6"})
    void aConvexEdgeIsLit(double size, double away) {
        assertRight(random -> convex(random, size, away));
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "1e-9, 1", "1e12, 1", "1, 1e3", "1, 1e6"})
    void aConcaveEdgeIsLitByWhatBothTrianglesSee(double size, double away) {
        assertRight(random -> concave(random, size, away));
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "1e-9, 1", "1e12, 1", "1, 1e3", "1, 1e6"})
    void aConcaveEdgeIsDarkBehindTheOtherTriangle(double size, double away) {
        assertRight(random -> hidden(random, size, away));
    }

    /** Corners about 1 away from a middle. */
    private static List<Vector> tetrahedron(RandomNumbers random, Vector middle, double size) {
        List<Vector> ideal = List.of(new Vector(1, 1, 1), new Vector(1, -1, -1), new Vector(-1, 1, -1), new Vector(-1, -1, 1));
        return ideal.stream().map(corner -> Vectors.plus(middle, size, Vectors.plus(corner, 0.3, random.vector(1)))).toList();
    }

    private static List<Surface> faces(RandomNumbers random, List<Vector> corners) {
        List<Surface> faces = new ArrayList<>();
        for (int[] face : new int[][] {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}) {
            faces.add(new TriangleQuery(Vector.ZERO, Vector.ZERO, corners.get(face[0]), corners.get(face[1]),
                corners.get(face[2])).renamed(random.random().nextInt(6)).triangle());
        }
        return faces;
    }

    /** A point of the first face at a corner, at an edge, or near them. */
    private static Vector nearTheBorder(RandomNumbers random, List<Vector> corners) {
        Vector corner = corners.get(random.random().nextInt(3));
        Vector first = corners.get(random.random().nextInt(3)).minus(corner);
        Vector second = corners.get(random.random().nextInt(3)).minus(corner);
        double far = random.oneIn(2) ? random.between(0, 0.8) : closeness(random);
        return Vectors.plus(Vectors.plus(corner, far, first), closeness(random), second);
    }

    private static Vector around(RandomNumbers random, Vector middle, double size) {
        return Vectors.plus(middle, size * random.between(3, 9), random.direction());
    }

    private static Case fromOutside(RandomNumbers random, double size, double away) {
        Vector middle = random.vector(away * size);
        List<Vector> corners = tetrahedron(random, middle, size);
        List<Surface> faces = faces(random, corners);
        Vector viewer = seeing(random, faces.get(0), middle, size);
        return new Case(faces, viewer, nearTheBorder(random, corners), seeing(random, faces.get(0), middle, size), true);
    }

    /** A point clearly in front of the face, as seen from outside. */
    private static Vector seeing(RandomNumbers random, Surface face, Vector middle, double size) {
        Vector point = around(random, middle, size);
        double height = Sides.height(face, point);
        return Math.signum(height) != Math.signum(Sides.height(face, middle)) && Math.abs(height) > CLEAR * size ? point
            : seeing(random, face, middle, size);
    }

    private static Case fromInside(RandomNumbers random, double size, double away) {
        Vector middle = random.vector(away * size);
        List<Vector> corners = tetrahedron(random, middle, size);
        List<Surface> faces = faces(random, corners);
        Vector light = behind(random, faces.get(0), middle, size);
        return new Case(faces, Vectors.plus(middle, size * 0.1, random.vector(1)), nearTheBorder(random, corners), light,
            false);
    }

    /** Outside the mesh, but on the inner side of the face's plane. */
    private static Vector behind(RandomNumbers random, Surface face, Vector middle, double size) {
        Vector point = around(random, middle, size);
        double height = Sides.height(face, point);
        return Math.signum(height) == Math.signum(Sides.height(face, middle)) && Math.abs(height) > CLEAR * size ? point
            : behind(random, face, middle, size);
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "1e-9, 1", "1e12, 1", "1, 1e3", "1, 1e6"})
    void aConvexMeshFromOutsideIsLitByAllThatIsInFrontOfAFace(double size, double away) {
        assertRight(random -> fromOutside(random, size, away));
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "1e-9, 1", "1e12, 1", "1, 1e3", "1, 1e6"})
    void aConvexMeshFromInsideIsDark(double size, double away) {
        assertRight(random -> fromInside(random, size, away));
    }
}
