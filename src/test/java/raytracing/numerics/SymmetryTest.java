package raytracing.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/**
 * Laws that need no oracle: space has no preferred side, axis or unit, so these changes of a query change no bit of
 * its answer. Each law is put to more than a million rays, most of them hard.
 */
class SymmetryTest {
    private static final long SEED = 11;
    private static final int SIZE = 50_000;

    /** The largest error of a crossing. */
    private static final int MOST_ULPS = 16;

    /** One change of a query; which one of its kind is up to the query's number. */
    @FunctionalInterface
    private interface Change {
        Query of(Query query, int number);
    }

    /** What such a change multiplies the crossing by: a power of two, so that no digit is lost. */
    @FunctionalInterface
    private interface Factor {
        double of(int number);
    }

    private static void assertLaw(Family family, Change change, Factor factor) {
        Formula ours = family.shape().ours().formula();
        Queries queries = family.queries(SEED, SIZE);
        int[] broken = IntStream.range(0, queries.size())
            .filter(i -> ours.firstCrossing(change.of(queries.get(i), i))
                != inRange(ours.firstCrossing(queries.get(i)), factor.of(i)))
            .toArray();
        assertEquals(0, broken.length, () -> "queries that break the law; first: " + queries.get(broken[0])
            + ", answer " + ours.firstCrossing(queries.get(broken[0])) + ", changed "
            + ours.firstCrossing(change.of(queries.get(broken[0]), broken[0])));
    }

    /** A crossing in other units: the outermost double stands for all beyond it. */
    private static double inRange(double crossing, double factor) {
        return crossing < Formula.MISS ? Math.min(factor * crossing, Double.MAX_VALUE) : crossing;
    }

    private static void assertLaw(Family family, Change change) {
        assertLaw(family, change, number -> 1);
    }

    /** All three axes mirrored at once put ray and surface on the other side of the world. */
    @ParameterizedTest(name = "{0}")
    @MethodSource(AllFamilies.NAMED)
    void aMirrorChangesNothing(Family family) {
        assertLaw(family, (query, i) -> query.inAxes(Axes.MIRRORS.get(i % Axes.MIRRORS.size())));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource(AllFamilies.NAMED)
    void theOrderOfTheAxesChangesNoDecision(Family family) {
        Formula ours = family.shape().ours().formula();
        Queries queries = family.queries(SEED, SIZE);
        for (int i = 0; i < queries.size(); i++) {
            Query query = queries.get(i);
            Query renamed = query.inAxes(Axes.PERMUTATIONS.get(i % Axes.PERMUTATIONS.size()));
            double t = ours.firstCrossing(query);
            double other = ours.firstCrossing(renamed);
            assertTrue(t == other || Math.abs(t - other) <= 2 * MOST_ULPS * Math.ulp(t),
                () -> query + " has " + t + ", " + renamed + " has " + other);
        }
    }

    /**
     * Lengths by one power of two and the ray's speed by another. The speed only grows: some directions have parts so
     * small already that halving would round them. A plane's normal has its own unit, which its offset shares.
     */
    @ParameterizedTest(name = "{0}")
    @MethodSource(AllFamilies.NAMED)
    void unitsChangeNothing(Family family) {
        assertLaw(family,
            (query, i) -> inUnits(family.shape(), query, lengths(i), speed(i)), i -> lengths(i) / speed(i));
    }

    private static double lengths(int number) {
        return number % 2 == 0 ? 0x1p40 : 0x1p-40;
    }

    private static double speed(int number) {
        return Math.scalb(1, number % 31);
    }

    private static Query inUnits(Shape shape, Query query, double lengths, double speed) {
        Vector origin = query.origin().times(lengths);
        Vector direction = query.direction().times(speed);
        if (shape == Shape.PLANE) {
            double normals = 0x1p20;
            return new Query(origin, direction, query.vector().times(normals), query.scalar() * lengths * normals);
        }
        return new Query(origin, direction, query.vector().times(lengths), query.scalar() * lengths);
    }

    @ParameterizedTest
    @EnumSource
    void aPlaneHasTwoSidesAndNoFront(PlaneFamily family) {
        assertLaw(family,
            (query, i) -> new Query(query.origin(), query.direction(), Vectors.negated(query.vector()), -query.scalar()));
    }

    @ParameterizedTest
    @EnumSource
    void aPlaneOnTheOtherSideOfTheWorldIsAsFarAway(PlaneFamily family) {
        assertLaw(family,
            (query, i) -> new Query(Vectors.negated(query.origin()), Vectors.negated(query.direction()), query.vector(),
                -query.scalar()));
    }
}
