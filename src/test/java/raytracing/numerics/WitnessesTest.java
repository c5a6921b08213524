package raytracing.numerics;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Comparator;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The tests' own strength: with a simpler formula in the place of ours they fail. Each row says with how many wrong
 * decisions and with which error, at least; that is about half of what was measured.
 */
class WitnessesTest {
    private static final long SEED = 13;
    private static final int SIZE = 3_000;

    @ParameterizedTest(name = "{0} {1}, {2}")
    @CsvSource({
        // shape, formula,        family,         wrong %, ulps
        "SPHERE, TEXTBOOK,         FAR,                  5, 5e7",
        "SPHERE, TEXTBOOK,         TINY,                15, 5e7",
        "SPHERE, TEXTBOOK,         GROUND,               0, 1e14",
        "SPHERE, HALF_B,           GRAZING,              1, 5e7",
        "SPHERE, HALF_B,           INSIDE,               0, 1e11",
        "SPHERE, CLOSEST_APPROACH, GROUND,               0, 1e14",
        "SPHERE, CLOSEST_APPROACH, ON_THE_SURFACE,       4, 1e17",
        "SPHERE, COMPENSATED,      GROUND,               0, 1e5",
        "SPHERE, COMPENSATED,      GRAZING,              0, 3e6",
        "SPHERE, COMPENSATED,      ON_THE_SURFACE,       1, 1e17",
        "PLANE,  TEXTBOOK,         ON_THE_PLANE,        25, 0",
        "PLANE,  TEXTBOOK,         OFFSET,               0, 5e8",
        "PLANE,  TEXTBOOK,         NEAR,                 0, 1e15",
        "PLANE,  FUSED,            ON_THE_PLANE,         8, 1e17",
        "PLANE,  FUSED,            OFFSET,               0, 5e8",
        "BOX,    TEXTBOOK,         IN_A_FACE,           15, 3",
        "BOX,    TEXTBOOK,         TINY_DIRECTION,       3, 10",
        "BOX,    TEXTBOOK,         TINY_AND_FAR,         0, 5e4",
        "BOX,    ORDERED,          IN_A_FACE,           11, 10",
        "BOX,    ORDERED,          CORNER,               1, 5",
        "BOX,    DIVISION,         ON_A_FACE,            9, 1e14",
        "BOX,    DIVISION,         OFFSET,               0, 1e7",
        "BOX,    COMPENSATED,      EDGE,               0.2, 0",
        "BOX,    COMPENSATED,      CORNER,             0.3, 0",
    })
    void aSimplerFormulaFailsHardRays(Shape shape, String formula, String family, double wrongPercent, double ulps) {
        Sample.Errors errors = shape.family(family).sample(SEED, SIZE)
            .errorsOf(shape.algorithm(formula).formula());
        assertTrue(100 * errors.wrongShare() >= wrongPercent, errors::toString);
        assertTrue(ulps == 0 || errors.worst() >= ulps, errors::toString);
    }

    @ParameterizedTest(name = "{0} {1}")
    @CsvSource({
        // shape, formula,        wrong, ulps
        "SPHERE, TEXTBOOK,           50, 1e16",
        "SPHERE, HALF_B,             50, 1e16",
        "SPHERE, CLOSEST_APPROACH,   10, 1e16",
        "SPHERE, COMPENSATED,         1, 1e14",
        "PLANE,  TEXTBOOK,           30, 1e15",
        "PLANE,  FUSED,              10, 1e15",
        "BOX,    TEXTBOOK,           45, 1e7",
        "BOX,    ORDERED,            50, 1e7",
        "BOX,    DIVISION,           50, 1e7",
        "BOX,    COMPENSATED,        15, 1",
    })
    void aSimplerFormulaFailsRowsOfTheTablesOfExactAnswers(Shape shape, String formula, int wrong, double ulps) {
        Formula witness = shape.algorithm(formula).formula();
        List<Double> errors = Row.of(shape).stream().filter(row -> row.startsAtZero() && !row.isOnBoundary())
            .map(row -> row.answer().errorInUlps(row.found(witness))).toList();
        long wrongDecisions = errors.stream().filter(error -> error == ExactAnswer.WRONG_DECISION).count();
        double worst = errors.stream().filter(error -> error < ExactAnswer.WRONG_DECISION)
            .max(Comparator.naturalOrder()).orElseThrow();
        assertTrue(wrongDecisions >= wrong, () -> "only " + wrongDecisions + " wrong decisions");
        assertTrue(worst >= ulps, () -> "only " + worst + " ulps");
    }
}
