package raytracing.area;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The area over a chord, against the segments of the curves that everybody knows, and against its own integral. */
class ConicSegmentTest {
    private static final double CLAIMED = 0x1p-47;

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "two straight lines, -1, 1",
        "parabola,            0, 1.3333333333333333",
        "half an ellipse,     1, 1.5707963267948966",
    })
    void segmentsWithAName(String why, double c, double expected) {
        assertEquals(expected, ConicSegment.areaFactor(c), CLAIMED * expected, why);
    }

    /** Of radius 1: the sector less the triangle to its middle, over the triangle to the arc's apex. */
    @ParameterizedTest
    @ValueSource(doubles = {30, 56, 57, 90, 112, 113, 180, 270, 350, 359})
    void arcsOfACircle(double degrees) {
        double angle = Math.toRadians(degrees);
        double quarter = Math.tan(angle / 4);
        double segment = (angle - Math.sin(angle)) / 2;
        double triangle = Math.sin(angle / 2) * 2 * Math.pow(Math.sin(angle / 4), 2);
        assertEquals(segment / triangle, ConicSegment.areaFactor(quarter * quarter), 1e-13 * segment / triangle);
    }

    /** Of x x - y y = 1, up to the chord between (cosh t, -sinh t) and (cosh t, sinh t). */
    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.5, 0.52, 1, 2, 5, 10})
    void arcsOfARectangularHyperbola(double t) {
        double root = Math.tanh(t / 2);
        double segment = Math.sinh(t) * Math.cosh(t) - t;
        double triangle = Math.sinh(t) * (Math.cosh(t) - 1);
        assertEquals(segment / triangle, ConicSegment.areaFactor(-root * root), 2e-13);
    }

    /** Twice the integral of sqrt((1 - y)(1 + c y)) over y in 0..1, where y = 1 - s s and s = 1 - w w tame its ends. */
    private static double integral(double c) {
        return Quadrature.integral(w -> {
            double s = 1 - w * w;
            double squaredRoot = 1 + c * w * w * (1 + s);
            return 8 * w * s * s * Math.sqrt(Math.max(squaredRoot, 0));
        }, 0, 1);
    }

    @Test
    void allShapesHaveTheAreaThatTheirIntegralHas() {
        for (int i = 0; i <= 1_300; i++) {
            double c = Math.pow(10, i / 50.0 - 14) - 1;
            double expected = integral(c);
            assertEquals(expected, ConicSegment.areaFactor(c), CLAIMED * expected, () -> "c = " + c);
        }
    }

    /** Where a formula takes over from another one: of c itself, and of c after the angle was halved once. */
    @ParameterizedTest
    @ValueSource(doubles = {-1 / 16.0, 1 / 16.0, -0.22145328719723184, 0.28444444444444444})
    void theFormulasMeet(double border) {
        for (int ulps = -20; ulps <= 20; ulps++) {
            double c = border + ulps * Math.ulp(border);
            double expected = integral(c);
            assertEquals(expected, ConicSegment.areaFactor(c), CLAIMED * expected);
        }
    }

    @Test
    void aRounderArcHasMoreArea() {
        double last = 1;
        for (int i = 1; i <= 13_000; i++) {
            double found = ConicSegment.areaFactor(Math.pow(10, i / 500.0 - 14) - 1);
            assertTrue(found >= last * (1 - CLAIMED), "step " + i);
            last = found;
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {-1, -1.0000000000000002, -1.5, Double.NEGATIVE_INFINITY, Double.NaN})
    void whatRoundingMadeOfTwoStraightLinesIsATriangle(double c) {
        assertEquals(1, ConicSegment.areaFactor(c));
    }
}
