package raytracing.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Judgement is fair: what is right counts nothing, what is wrong cannot hide. */
class SampleTest {
    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "the wanted one,              3,                   0",
        "an ulp more,                 0x1.8000000000001p1, 1",
        "two ulps less,               0x1.7fffffffffffep1, 2",
        "the other crossing,          7,                   Infinity",
        "nearer to the other one,     5.5,                 Infinity",
        "behind the origin,          -3,                   Infinity",
        "none at all,                 Infinity,            Infinity",
        "not a number,                NaN,                 Infinity",
    })
    void anErrorIsCountedInUlpsUnlessTheDecisionIsWrong(String found, double t, double error) {
        assertEquals(error, new ExactAnswer(3, 7).errorInUlps(t));
    }

    @ParameterizedTest
    @CsvSource({"Infinity, 0", "3, Infinity", "NaN, Infinity"})
    void whereNothingIsMetOnlyAMissIsRight(double found, double error) {
        assertEquals(error, ExactAnswer.NO_CROSSING.errorInUlps(found));
    }

    @Test
    void theExactFormulaHasNoErrors() {
        Formula exact = (ox, oy, oz, dx, dy, dz, x, y, z, scalar) -> Shape.BOX.exactAnswer(
            Query.of(ox, oy, oz, dx, dy, dz, x, y, z, scalar)).wanted();
        assertEquals(new Sample.Errors(0, 0, 0), BoxFamily.OFFSET.sample(1, 500).errorsOf(exact));
    }

    /** It is wrong where there is something to meet, and there is nothing whose digits could be counted. */
    @Test
    void whoMissesEverythingIsWrongAboutEveryHit() {
        Sample sample = SphereFamily.FAR.sample(1, 500);
        Formula blind = (ox, oy, oz, dx, dy, dz, x, y, z, scalar) -> Formula.MISS;
        assertEquals(new Sample.Errors(sample.shareOfHits(), Double.NaN, Double.NaN), sample.errorsOf(blind));
    }
}
