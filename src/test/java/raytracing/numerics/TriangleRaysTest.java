package raytracing.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Crossings of triangles against exact arithmetic. {@code gradle triangleRays} judges a million of them. */
class TriangleRaysTest {
    private static final long SEED = 71;
    private static final int SIZE = 5_000;

    /** And what doubles are asked for up to some distance they give, or miss what is beyond it. */
    @ParameterizedTest
    @EnumSource
    void everyCrossingIsTheExactOneButForItsLastDigits(TriangleFamily family) {
        TriangleVerdict verdict = TriangleVerdict.of(family, SEED, SIZE);
        Failures.assertNone(verdict.faults().stream());
        assertTrue(verdict.worst() <= TriangleVerdict.MOST_ERROR, () -> "off by " + verdict.worst() + " u");
    }

    @ParameterizedTest
    @EnumSource
    void everyFamilyHasHitsAndMisses(TriangleFamily family) {
        double share = (double) TriangleVerdict.of(family, 1, SIZE / 5).hits() / (SIZE / 5);
        assertTrue(share > 0.1 && share < 0.95, "share of hits " + share);
    }

    @ParameterizedTest
    @EnumSource
    void theSameSeedDrawsTheSameRays(TriangleFamily family) {
        assertEquals(family.queries(1, SIZE / 5), family.queries(1, SIZE / 5));
    }
}
