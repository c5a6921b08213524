package raytracing.numerics;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.math.Basis;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.surface.Departure;
import raytracing.surface.RayOrigin;
import raytracing.surface.RayRecord;
import raytracing.surface.SegmentRecord;
import raytracing.surface.Surface;
import raytracing.surface.SurfaceQuestions;
import raytracing.surface.Triangle;

/**
 * Between triangles that share a corner or an edge nothing passes: what is aimed at the shared place, exactly or but for
 * roundings, meets at least one of them, from either side.
 */
class WatertightTest {
    private static final long SEED = 79;
    private static final int FANS = 3_000;

    /**
     * Triangles around a corner, without a gap as seen along a line to a point of a shared edge.
     *
     * @param from a point on the line, far before the fan
     * @param target about where the line meets an edge or the corner
     */
    private record Fan(List<Triangle> triangles, Vector from, Vector target) {
        boolean isMet(Vector start, Vector direction) {
            RayRecord ray = new RayRecord(start, 0, direction, RayOrigin.NO_SURFACE, Departure.ELSEWHERE);
            return triangles.stream()
                .anyMatch(triangle -> SurfaceQuestions.firstCrossing(triangle, ray, Departure.ELSEWHERE) < Surface.MISS);
        }

        boolean isCrossed(Vector start, Vector end) {
            SegmentRecord line = new SegmentRecord(start, 0, end, 0);
            return triangles.stream().anyMatch(triangle -> SurfaceQuestions.crosses(triangle, line, Departure.ELSEWHERE));
        }

        /** From both sides, by rays and by lines. */
        boolean isTight() {
            Vector way = target.minus(from);
            Vector behind = Vectors.plus(target, way);
            Vector back = target.minus(behind);
            return isMet(from, way) && isMet(behind, back) && isCrossed(from, behind) && isCrossed(behind, from);
        }
    }

    private record Frame(Vector middle, Vector u, Vector v, Vector w, double size) {
        Vector at(double x, double y, double z) {
            return Vectors.plus(Vectors.plus(Vectors.plus(middle, size * x, u), size * y, v), size * z, w);
        }

        /** To numbers with few digits. */
        Vector rounded(Vector point) {
            double unit = Math.ulp(size) * 0x1p46;
            return new Vector(Math.rint(point.x() / unit) * unit, Math.rint(point.y() / unit) * unit,
                Math.rint(point.z() / unit) * unit);
        }
    }

    private static Frame frame(RandomNumbers random, double size, double away) {
        Basis basis = new Basis();
        Vector axis = random.direction();
        basis.turnTo(axis.x(), axis.y(), axis.z());
        return new Frame(random.vector(away * size), new Vector(basis.ux(), basis.uy(), basis.uz()),
            new Vector(basis.vx(), basis.vy(), basis.vz()), axis, size);
    }

    /** Seen along the third axis the corners go around the middle, each by less than half a turn. */
    private static List<Vector> ring(RandomNumbers random, Frame frame, boolean isRound) {
        int corners = random.random().nextInt(3, 9);
        List<Vector> ring = new ArrayList<>();
        for (int i = 0; i < corners; i++) {
            double angle = 2 * Math.PI * (i + random.between(-0.2, 0.2)) / corners;
            double radius = random.between(0.5, 2);
            Vector place = frame.at(radius * Math.cos(angle), radius * Math.sin(angle), random.between(-2, 2));
            ring.add(isRound ? frame.rounded(place) : place);
        }
        return ring;
    }

    private static Fan fan(RandomNumbers random, double size, double away) {
        Frame frame = frame(random, size, away);
        boolean isRound = random.oneIn(4);
        Vector top = frame.at(0, 0, random.between(-1, 1));
        Vector middle = isRound ? frame.rounded(top) : top;
        List<Vector> ring = ring(random, frame, isRound);
        List<Triangle> triangles = IntStream.range(0, ring.size())
            .mapToObj(i -> turned(random, middle, ring.get(i), ring.get((i + 1) % ring.size()))).toList();
        Vector spoke = ring.get(random.random().nextInt(ring.size()));
        Vector target = random.oneIn(3) ? middle
            : Vectors.plus(middle, random.oneIn(2) ? 0.25 : random.between(0, 0.4), spoke.minus(middle));
        Vector along = frame.at(random.between(-0.02, 0.02), random.between(-0.02, 0.02), 4).minus(frame.middle());
        return new Fan(triangles, target.minus(along), target);
    }

    /** Its corners in any order. */
    private static Triangle turned(RandomNumbers random, Vector a, Vector b, Vector c) {
        return new TriangleQuery(Vector.ZERO, Vector.ZERO, a, b, c).renamed(random.random().nextInt(6)).triangle();
    }

    private static Stream<Fan> fans(double size, double away) {
        RandomNumbers random = new RandomNumbers(new SplittableRandom(SEED));
        return Stream.generate(() -> fan(random, size, away)).limit(FANS);
    }

    private static void assertTight(double size, double away) {
        Failures.assertNone(fans(size, away).toList().parallelStream().filter(fan -> !fan.isTight()).map(Fan::toString));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-150, 1e-100, 1e-9, 1, 1e9, 1e100, 1e150})
    void nothingPassesBetweenTrianglesOfAFan(double size) {
        assertTight(size, 1);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e3, 1e6, 1e9})
    void nothingPassesBetweenThemFarFromTheWorldsOrigin(double away) {
        assertTight(1, away);
        assertTight(1e-9, away);
    }

    /** A fan whose line misses some of the triangles: else it would not matter whether the others are met. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-150, 1, 1e150})
    void atEdgesTheLineMeetsOneOrBothNeighbours(double size) {
        long alone = fans(size, 1).filter(fan -> fan.triangles.stream().filter(triangle -> ExactTriangle.of(triangle)
            .firstCrossing(fan.from, fan.target.minus(fan.from)).isPresent()).count() == 1).count();
        assertTrue(alone > FANS / 4 && alone < FANS, alone + " lines meet one triangle");
    }
}
