package raytracing.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.math.Vector;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;

/** The oracle of order: cases solved by hand, and another oracle that was written apart from it. */
class ExactCrossingTest {
    private static final long SEED = 3;
    private static final int SIZE = 500;

    @ParameterizedTest
    @CsvSource({"0", "-0.0", "1", "-3.5", "0.1", "4.9E-324", "-1.7976931348623157E308", "2.2250738585072014E-308"})
    void aDoubleIsTakenUnchanged(double value) {
        assertEquals(0, new BigDecimal(value).compareTo(ExactNumber.of(value).toDecimal()));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource(AllFamilies.NAMED)
    void bothOraclesFindTheSameCrossings(Family family) {
        Failures.assertNone(family.queries(SEED, SIZE).stream()
            .filter(query -> first(family.shape().surface(query), query.origin(), query.direction())
                .map(crossing -> crossing.value().doubleValue()).orElse(Formula.MISS)
                != family.shape().exactAnswer(query).wanted())
            .map(Query::toString));
    }

    private static Optional<ExactCrossing> first(Surface surface, Vector origin, Vector direction) {
        return ExactCrossing.first(surface, origin, direction);
    }

    private static ExactCrossing alongZ(Surface surface) {
        return first(surface, new Vector(1, 0, 0), new Vector(0, 0, 1)).orElseThrow();
    }

    private static Surface sphere(double x, double z, double r) {
        return new Sphere(new Vector(x, 0, z), r, 0);
    }

    private static Surface plane(double normal, double offset) {
        return new Plane(new Vector(0, 0, normal), offset, 0);
    }

    /** Along x = 1: a sphere of radius 2 around (0, z) is met at z - sqrt(3). */
    @Test
    void equalRootsAreEqual() {
        assertEquals(0, alongZ(sphere(0, 5, 2)).compareTo(alongZ(sphere(2, 5, 2))));
        assertEquals(0, alongZ(sphere(1, 5, 2)).compareTo(alongZ(plane(7, 21))));
        assertEquals(0, alongZ(plane(3, 3)).compareTo(alongZ(new Box(new Vector(0, 0, 2), 2, 0))));
    }

    /** sqrt(3) = 1.7320508075688772 9352...: between two doubles. */
    @Test
    void rootsAreToldFromTheDoublesBesideThem() {
        ExactCrossing irrational = alongZ(sphere(0, 5, 2));
        double below = 5 - Math.nextUp(1.7320508075688772);
        double above = 5 - Math.nextDown(1.7320508075688772);
        assertTrue(irrational.compareTo(alongZ(plane(1, below))) > 0);
        assertTrue(irrational.compareTo(alongZ(plane(1, above))) < 0);
        assertTrue(alongZ(plane(1, below)).compareTo(irrational) < 0);
        assertTrue(alongZ(plane(1, above)).compareTo(irrational) > 0);
    }

    @Test
    void twoRootsAreToldFromEachOther() {
        ExactCrossing first = alongZ(sphere(0, 5, 2));
        assertTrue(first.compareTo(alongZ(sphere(0, 5, Math.nextUp(2)))) > 0);
        assertTrue(first.compareTo(alongZ(sphere(0, 5, Math.nextDown(2)))) < 0);
        assertTrue(first.compareTo(alongZ(new Sphere(new Vector(0, 0x1p-60, 5), 2, 0))) < 0);
        assertTrue(alongZ(new Sphere(new Vector(0, 0x1p-60, 5), 2, 0)).compareTo(first) > 0);
    }
}
