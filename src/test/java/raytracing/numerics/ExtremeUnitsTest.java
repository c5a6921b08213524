package raytracing.numerics;

import java.util.stream.DoubleStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.math.Vector;

/**
 * Where squares of lengths leave the range of doubles, the careful companions answer for the quick steps: decisions stay,
 * and a crossing moves by no more than the errors of both, at most 16 ulps each.
 */
class ExtremeUnitsTest {
    private static final long SEED = 23;
    private static final int SIZE = 2_000;
    private static final double SMALL_LENGTHS = 0x1p-460;
    private static final double LARGE_LENGTHS = 0x1p440;
    private static final int MOST_ULPS = 16;
    private static final double SPEED = 0x1p300;

    /** Far below this, beside the largest, a part of a direction counts as 0 where units are extreme. */
    private static final double SMALLEST_PART = 0x1p-380;

    @ParameterizedTest(name = "{0}")
    @MethodSource(AllFamilies.NAMED)
    void lengthsAsSmallAsTheRangeDecideNothing(Family family) {
        assertUnitsDecideNothing(family, SMALL_LENGTHS, 1, 0x1p-300);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource(AllFamilies.NAMED)
    void lengthsAsLargeAsTheRangeDecideNothing(Family family) {
        assertUnitsDecideNothing(family, LARGE_LENGTHS, 1, 0x1p300);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource(AllFamilies.NAMED)
    void speedsAsLargeAsTheRangeDecideNothing(Family family) {
        assertUnitsDecideNothing(family, 1, SPEED, 1);
    }

    private static void assertUnitsDecideNothing(Family family, double lengths, double speed, double normals) {
        Formula ours = family.shape().ours().formula();
        Failures.assertNone(family.queries(SEED, SIZE).stream()
            .filter(query -> hasNoTinyPart(query.direction()))
            .filter(query -> !isClose(lengths / speed * ours.firstCrossing(query),
                ours.firstCrossing(inUnits(family.shape(), query, lengths, speed, normals))))
            .map(Query::toString));
    }

    private static boolean isClose(double wanted, double found) {
        return wanted == found || Math.abs(found - wanted) <= 2 * MOST_ULPS * Math.ulp(wanted) && found < Formula.MISS;
    }

    private static boolean hasNoTinyPart(Vector d) {
        return DoubleStream.of(d.x(), d.y(), d.z())
            .allMatch(part -> part == 0 || Math.abs(part) > SMALLEST_PART * d.largestPart());
    }

    /** A plane's normal has its own unit, which its offset shares. */
    private static Query inUnits(Shape shape, Query query, double lengths, double speed, double normals) {
        double vectors = shape == Shape.PLANE ? normals : lengths;
        double scalars = shape == Shape.PLANE ? lengths * normals : lengths;
        return new Query(query.origin().times(lengths), query.direction().times(speed), query.vector().times(vectors),
            query.scalar() * scalars);
    }
}
