package raytracing.numerics;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.surface.Departure;
import raytracing.surface.PointError;
import raytracing.surface.SegmentRecord;
import raytracing.surface.Surface;
import raytracing.surface.SurfaceQuestions;

/** Open lines between two points and triangles. */
class TriangleLinesTest {
    private static final long SEED = 73;
    private static final int SIZE = 5_000;

    /** From a ray's origin to a point on it before, on or behind the triangle, or but for roundings, or very far. */
    private record Between(Vector from, Vector to, TriangleQuery query) {
        static Between of(TriangleQuery query, SplittableRandom random) {
            double found = query.found();
            double t = found < Surface.MISS && random.nextInt(5) > 0 ? found : random.nextDouble(-30, 30);
            double factor = switch (random.nextInt(5)) {
                case 0 -> 1;
                case 2 -> Math.scalb(random.nextDouble(-1, 1), random.nextInt(400));
                case 1 -> 1 + Math.scalb(random.nextDouble(-1, 1), -random.nextInt(54));
                default -> random.nextDouble(0, 4);
            };
            return new Between(query.origin(), Vectors.plus(query.origin(), factor * t, query.direction()), query);
        }

        boolean isValid() {
            return to.largestPart() < Double.POSITIVE_INFINITY;
        }

        boolean isCrossed() {
            return crosses(from, 0, to, 0);
        }

        boolean isCrossedBackwards() {
            return crosses(to, 0, from, 0);
        }

        boolean isCrossedExactly() {
            return ExactTriangle.of(query.triangle()).isCrossed(from, to);
        }

        /** Whether both ends get the same answer if they are points that a scene names. */
        boolean isTheSameFromBothEnds() {
            double fromError = PointError.written(from);
            double toError = PointError.written(to);
            return crosses(from, fromError, to, toError) == crosses(to, toError, from, fromError);
        }

        private boolean crosses(Vector start, double startError, Vector end, double endError) {
            return SurfaceQuestions.crosses(query.triangle(), new SegmentRecord(start, startError, end, endError),
                Departure.ELSEWHERE);
        }
    }

    private static List<Between> lines(TriangleFamily family) {
        List<TriangleQuery> queries = family.queries(SEED, SIZE);
        return IntStream.range(0, SIZE).mapToObj(i -> Between.of(queries.get(i), new SplittableRandom(SEED + i)))
            .filter(Between::isValid).toList();
    }

    @ParameterizedTest
    @EnumSource
    void exactlyTheTrianglesBetweenTheEndsAreCrossed(TriangleFamily family) {
        List<Between> lines = lines(family);
        long crossed = lines.stream().filter(Between::isCrossedExactly).count();
        assertTrue(crossed > SIZE / 50 && crossed < SIZE, crossed + " crossed");
        Failures.assertNone(lines.parallelStream()
            .filter(line -> line.isCrossed() != line.isCrossedExactly() || line.isCrossedBackwards() != line.isCrossed())
            .map(Between::toString));
    }

    @ParameterizedTest
    @EnumSource
    void pointsOfTheSceneGetTheSameAnswerFromBothEnds(TriangleFamily family) {
        Failures.assertNone(lines(family).parallelStream().filter(line -> !line.isTheSameFromBothEnds())
            .map(Between::toString));
    }

    /** A light or a camera on a triangle is neither shadowed by it nor hidden. */
    @ParameterizedTest
    @EnumSource(names = {"ORDINARY", "GRID", "OFFSET", "NEEDLE"})
    void aPointOnATriangleSeesBothSides(TriangleFamily family) {
        Failures.assertNone(family.queries(SEED, SIZE).stream().flatMap(query -> Stream.of(query.a(), query.b(), query.c())
            .map(corner -> new Between(query.origin(), corner, query)))
            .filter(line -> line.crosses(line.from, 0, line.to, PointError.written(line.to))
                || line.crosses(line.to, PointError.written(line.to), line.from, 0))
            .map(Between::toString));
    }
}
