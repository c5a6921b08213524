package raytracing.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.math.Vector;

/** The bounds on the errors of crossings hold under search, too: no climb towards larger errors passes them. */
class ClimbingTest {
    private static final long SEED = 31;
    private static final int STARTS = 1_000;
    private static final int STEPS = 600;
    private static final int HARD_STARTS = 150;
    private static final int HARD_STEPS = 500;

    private static void assertNoHigher(Family family, int starts, int steps) {
        Climb.Summit summit = Climb.highest(family, family.shape().ours().formula(), SEED, starts, steps);
        assertTrue(summit.ulps() <= family.shape().allowedUlps(), summit::toString);
    }

    @ParameterizedTest
    @EnumSource
    void noClimbFromOrdinaryRaysPassesTheBound(Shape shape) {
        assertNoHigher(shape.families().get(0), STARTS, STEPS);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource(AllFamilies.NAMED)
    void noClimbFromAnyFamilyPassesTheBound(Family family) {
        assertNoHigher(family, HARD_STARTS, HARD_STEPS);
    }

    /** A climb that found nothing would prove nothing: here there is something to find, and random rays hardly find it. */
    @ParameterizedTest(name = "{0} {1}")
    @CsvSource({
        "SPHERE, CLOSEST_APPROACH, 1e6",
        "PLANE,  FUSED,            1e7",
        "BOX,    DIVISION,         1e7",
    })
    void climbsFindTheErrorsOfASimplerFormula(Shape shape, String formula, double ulps) {
        Climb.Summit summit = Climb.highest(shape.families().get(0), shape.algorithm(formula).formula(), SEED, 100, 400);
        assertTrue(summit.ulps() >= ulps, summit::toString);
    }

    @Test
    void theSameSeedClimbsTheSameWay() {
        Formula ours = SphereAlgorithm.HALF_B.formula();
        assertEquals(Climb.highest(SphereFamily.ORDINARY, ours, SEED, 20, 200),
            Climb.highest(SphereFamily.ORDINARY, ours, SEED, 20, 200));
    }

    private static void assertWithinTheBound(Shape shape, Query query) {
        double found = shape.ours().formula().firstCrossing(query);
        double error = shape.exactAnswer(query).errorInUlps(found);
        assertTrue(error <= shape.allowedUlps(), () -> "off by " + error + " ulps");
    }

    /** With the product of an earlier day it was off by 113 ulps. */
    @Test
    void aSphereThatAClimbFoundIsWithinTheBound() {
        assertWithinTheBound(Shape.SPHERE, new Query(
            new Vector(3.8462741636451514, -2.998912650889705, 9.311483504764825),
            new Vector(0.6240475526805568, -1.121926301221666, -0.41614502080076055),
            new Vector(7.864280330220385, -3.6234831839807895, 9.98813483205819), 3.509548263163466));
    }

    /** With the product of an earlier day it was off by 36 ulps. */
    @Test
    void aPlaneThatAClimbFoundIsWithinTheBound() {
        assertWithinTheBound(Shape.PLANE, new Query(
            new Vector(4.542570771935049, 0.6891553067454701, -0.13531296777614443),
            new Vector(0.28949751255724876, 0.11330263665963836, -0.44223677095835556),
            new Vector(-0.9746464992903628, 0.0742354887990698, -0.2095105854492047), -4.709015614819295));
    }
}
