package raytracing.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class FisheyeTest {
    /** The exercise's relation, forwards: radius over screen distance for an angle. */
    private static double radius(double k, double angle) {
        if (k == 0) {
            return angle;
        }
        return k > 0 ? StrictMath.tan(k * angle) / k : StrictMath.sin(k * angle) / k;
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 0.75, 0.5, 0.1, 1e-6, 1e-12, 0, -1e-12, -1e-6, -0.1, -0.5, -0.9, -1})
    void anglesAreThoseOfTheExercise(double k) {
        for (double angle = 0.05; angle < 1.5; angle += 0.05) {
            // Near its rim the sine hardly changes with the angle, so the rounded radius tells it less exactly.
            assertEquals(angle, new Fisheye(k).incidentAngle(radius(k, angle)), 1e-14);
        }
    }

    @Test
    void stereographicAndOrthographicHaveTheirTextbookAngles() {
        assertEquals(Math.PI / 2, new Fisheye(0.5).incidentAngle(2), 1e-15);
        assertEquals(Math.PI / 2, new Fisheye(-1).incidentAngle(1), 1e-15);
        assertEquals(Math.PI / 6, new Fisheye(-1).incidentAngle(0.5), 1e-15);
    }

    @Test
    void theAngleIsSmoothInKThroughZero() {
        for (double radius = 0; radius < 2; radius += 0.01) {
            double atZero = new Fisheye(0).incidentAngle(radius);
            for (double k : new double[] {1e-12, -1e-12, 1e-9, -1e-9, Double.MIN_VALUE, -Double.MIN_VALUE}) {
                double slope = radius * radius * radius / 3 * Math.abs(k);
                assertEquals(atZero, new Fisheye(k).incidentAngle(radius), slope + 1e-15);
            }
        }
    }

    /** Crossing the border to the short cut changes the angle by no more than its neighbours on one side differ. */
    @ParameterizedTest
    @ValueSource(ints = {1, -1})
    void theShortCutForTinyAnglesDoesNotShow(int sign) {
        double k = sign * 0x1p-27;
        double shortCut = new Fisheye(Math.nextDown(Math.abs(k)) * sign).incidentAngle(1);
        double formula = new Fisheye(k).incidentAngle(1);
        assertEquals(shortCut, formula, Math.ulp(1.0));
    }

    @ParameterizedTest
    @CsvSource({"-1, 1.0000001", "-0.5, 2.0000001", "-0.25, 100"})
    void noLightArrivesOutsideTheRimOfNegativeK(double k, double radius) {
        assertTrue(Double.isNaN(new Fisheye(k).incidentAngle(radius)));
    }
}
