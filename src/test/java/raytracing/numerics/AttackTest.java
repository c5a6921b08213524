package raytracing.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.surface.Departure;
import raytracing.surface.RayOrigin;
import raytracing.surface.RayRecord;
import raytracing.surface.SurfaceQuestions;

/**
 * More than 200 000 random rays in more than 50 families that look for wrong decisions, each judged by exact
 * arithmetic: crossings of one surface, the order of several along a ray, and what goes on from where surfaces meet.
 */
class AttackTest {
    private static final long SEED = 37;
    private static final int RAYS = 8_000;
    private static final int ORDERS = 4_000;
    private static final int CROWDS = 200;
    private static final int JOINTS = 2_000;

    static Stream<Named<Family>> families() {
        return Stream.of(SphereAttack.FAMILIES, PlaneAttack.FAMILIES, BoxAttack.FAMILIES).flatMap(List::stream)
            .map(family -> Named.of(family.shape() + " " + family.title(), family));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("families")
    void everyCrossingIsTheExactOneButForItsLastDigits(Family family) {
        Shape shape = family.shape();
        Formula ours = shape.ours().formula();
        Failures.assertNone(family.queries(SEED, RAYS).stream().toList().parallelStream()
            .filter(query -> !isRight(shape, shape.exactAnswer(query), ours.firstCrossing(query)))
            .map(query -> "wanted " + shape.exactAnswer(query).wanted() + ", found " + ours.firstCrossing(query) + ": "
                + query));
    }

    /** A family that a simpler formula survives would prove little. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("families")
    void theTextbookFailsEveryFamily(Family family) {
        Shape shape = family.shape();
        Formula textbook = shape.algorithms().get(0).formula();
        assertTrue(family.queries(SEED, RAYS / 8).stream()
            .anyMatch(query -> !isRight(shape, shape.exactAnswer(query), textbook.firstCrossing(query))));
    }

    /** Beyond the normal doubles a crossing cannot keep its digits: there it must be above 0, and no miss. */
    private static boolean isRight(Shape shape, ExactAnswer answer, double found) {
        double wanted = answer.wanted();
        if (wanted < Double.MIN_NORMAL) {
            return found > 0 && found <= 2 * Double.MIN_NORMAL;
        }
        if (wanted < Formula.MISS && wanted > Double.MAX_VALUE / 2) {
            return found >= Double.MAX_VALUE / 4 && found < Formula.MISS;
        }
        return answer.errorInUlps(found) <= shape.allowedUlps();
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("families")
    void surfacesAnswerLikeTheKernels(Family family) {
        Formula ours = family.shape().ours().formula();
        Failures.assertNone(family.queries(SEED, RAYS).stream()
            .filter(query -> SurfaceQuestions.firstCrossing(family.shape().surface(query),
                new RayRecord(query.origin(), 0, query.direction(), RayOrigin.NO_SURFACE, Departure.ELSEWHERE),
                    Departure.ELSEWHERE)
                != ours.firstCrossing(query))
            .map(Query::toString));
    }

    @ParameterizedTest(name = "{0}")
    @EnumSource
    void surfacesComeInTheOrderOfTheirRealCrossings(OrderFamily family) {
        int count = family == OrderFamily.CROWD ? CROWDS : ORDERS;
        Failures.assertNone(family.faults(Encounter::walkedOrder, SEED, count).stream());
    }

    @ParameterizedTest(name = "{0}")
    @EnumSource
    void theTextbookTakesSomeSurfacesOfEveryFamilyInAWrongOrder(OrderFamily family) {
        assertFalse(family.faults(encounter -> encounter.roundedOrder("TEXTBOOK"), SEED, CROWDS).isEmpty());
    }

    @ParameterizedTest(name = "{0}")
    @EnumSource
    void whatARayReachesLiesInFrontOfAllThatItTouches(JointFamily family) {
        List<JointRule.Verdict> verdicts = family.verdicts(SEED, JOINTS);
        assertTrue(verdicts.stream().mapToInt(JointRule.Verdict::asked).sum() > 4 * JOINTS, "too few clear questions");
        Failures.assertNone(verdicts.stream().flatMap(verdict -> verdict.faults().stream()));
    }

    private static void assertFound(double wanted, Shape shape, Query query) {
        assertEquals(wanted, shape.exactAnswer(query).wanted(), "the oracle");
        assertEquals(wanted, shape.ours().formula().firstCrossing(query));
    }

    /** The line passes the world's origin without a rounding, half a radius beside the sphere. */
    @Test
    void aSphereIsMissedFrom10To32Away() {
        Vector origin = new Vector(1.7962615744215671E31, -1.354625218141938E32, 1.0144961202872982E32);
        assertFound(Formula.MISS, Shape.SPHERE, new Query(origin, Vectors.negated(origin),
            new Vector(-0.143742082316189, 0.9237471519376259, -0.7209398003196479), 2.9077969390601143E-5));
    }

    @Test
    void aCrossingOfHugeNumbersIsANumber() {
        Query query = new Query(new Vector(-1, 0.999, 0), new Vector(1e250, 1e250, 0), new Vector(1e60, 1e60, 0), 0);
        double wanted = Shape.PLANE.exactAnswer(query).wanted();
        assertEquals(wanted, Shape.PLANE.ours().formula().firstCrossing(query), 16 * Math.ulp(wanted));
    }
}
