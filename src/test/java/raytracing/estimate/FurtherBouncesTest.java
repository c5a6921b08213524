package raytracing.estimate;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** Light of endless bounces: b + r b + r r b + ... = b / (1 - r). */
class FurtherBouncesTest {
    @Test
    void aQuarterOfWhatArrivesGoingOnMakesFourThirds() {
        assertEquals(4.0 / 3, FurtherBounces.series(2, 2, 0.5));
    }

    @Test
    void nothingArrivingMakesNothing() {
        assertEquals(0, FurtherBounces.series(0, 0, 0));
    }

    /** Where such a sum is multiplied by what goes on, and that is nothing, there must be no light, not NaN. */
    @Test
    void lightBeyondAllDoublesIsTheLargestThereIs() {
        assertEquals(Double.MAX_VALUE, FurtherBounces.series(Double.MAX_VALUE, 0.5, 0.25));
    }
}
