package raytracing.numerics;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.BiFunction;
import java.util.function.BiPredicate;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import raytracing.surface.Surface;

/** Laws of triangles that need no oracle: space has no preferred side, axis or unit, and a triangle no first corner. */
class TriangleSymmetryTest {
    private static final long SEED = 83;
    private static final int SIZE = 2_000;

    /** Both answers may be off by so much. */
    private static final double MOST_ERROR = 2 * TriangleVerdict.MOST_ERROR * 0x1p-53;

    private static void assertLaw(TriangleFamily family, BiFunction<TriangleQuery, Integer, TriangleQuery> change,
                                  BiPredicate<Double, Double> law) {
        List<TriangleQuery> queries = family.queries(SEED, SIZE);
        Failures.assertNone(IntStream.range(0, SIZE)
            .filter(i -> !law.test(queries.get(i).found(), change.apply(queries.get(i), i).found()))
            .mapToObj(i -> queries.get(i).found() + " is " + change.apply(queries.get(i), i).found() + " of " + i + ": "
                + queries.get(i)));
    }

    private static boolean isClose(double t, double other) {
        return t == other || t < Surface.MISS && other < Surface.MISS
            && Math.abs(t - other) <= MOST_ERROR * t + Double.MIN_NORMAL;
    }

    @ParameterizedTest
    @EnumSource
    void aMirrorChangesNothing(TriangleFamily family) {
        assertLaw(family, (query, i) -> query.inAxes(Axes.MIRRORS.get(i % Axes.MIRRORS.size())), Double::equals);
    }

    @ParameterizedTest
    @EnumSource
    void theOrderOfTheAxesChangesNoDecision(TriangleFamily family) {
        assertLaw(family, (query, i) -> query.inAxes(Axes.PERMUTATIONS.get(i % Axes.PERMUTATIONS.size())),
            TriangleSymmetryTest::isClose);
    }

    @ParameterizedTest
    @EnumSource
    void theOrderOfTheCornersChangesNoDecision(TriangleFamily family) {
        assertLaw(family, (query, i) -> query.renamed(1 + i % 5), TriangleSymmetryTest::isClose);
    }

    /** Powers of two, so that no digit is lost; the speed only grows, as some directions have subnormal parts. */
    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = {"ANY_UNIT", "ENDS"})
    void unitsChangeNothing(TriangleFamily family) {
        List<TriangleQuery> queries = family.queries(SEED, SIZE);
        Failures.assertNone(IntStream.range(0, SIZE).filter(i -> {
            double lengths = i % 2 == 0 ? 0x1p40 : 0x1p-40;
            double speed = Math.scalb(1, i % 31);
            double t = queries.get(i).inUnits(lengths, speed).found();
            return t != Math.min(Double.MAX_VALUE, queries.get(i).found() * lengths / speed)
                && !(t == Surface.MISS && queries.get(i).found() == Surface.MISS);
        }).mapToObj(i -> queries.get(i).toString()));
    }

    /** Where a miss is a miss in any case, a law would say nothing. */
    @ParameterizedTest
    @EnumSource
    void aFaceIsMetFromBothSides(TriangleFamily family) {
        assertTrue(family.queries(SEED, SIZE).stream().filter(query -> ExactTriangle.of(query.triangle())
            .side(ExactPoint.of(query.origin())) > 0 && query.found() < Surface.MISS).count() > SIZE / 50);
        assertTrue(family.queries(SEED, SIZE).stream().filter(query -> ExactTriangle.of(query.triangle())
            .side(ExactPoint.of(query.origin())) < 0 && query.found() < Surface.MISS).count() > SIZE / 50);
    }
}
