package raytracing.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BasisTest {
    private static final double EIGHT_ULP = 8 * Math.ulp(1.0);

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "straight up,                         0,        1,       0",
        "straight down,                       0,       -1,       0",
        "level along x,                       1,        0,       0",
        "level along z,                       0,        0,      -1",
        "a hair below level,                  1,   -1e-17,       0",
        "a hair from straight down,       1e-10,       -1,       0",
        "further than squares from down,  3e-160,      -1, -4e-160",
        "the border to straight down,  0x1p-450,       -1,       0",
    })
    void axesAreUnitAndPerpendicular(String why, double x, double y, double z) {
        assertOrthonormal(Vectors.around(new Vector(x, y, z)));
    }

    @Test
    void axesAroundRandomDirectionsAreUnitAndPerpendicular() {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 100_000; i++) {
            assertOrthonormal(Vectors.around(randomUnit(random)));
        }
    }

    @Test
    void axesAroundUpAreTheAxesOfTheWorld() {
        Vectors.Axes basis = Vectors.around(new Vector(0, 1, 0));
        assertEquals(new Vector(0, 0, 1), Vectors.plus(basis.u(), Vector.ZERO));
        assertEquals(new Vector(1, 0, 0), Vectors.plus(basis.v(), Vector.ZERO));
    }

    /** For two unit vectors at least a right angle from -y, the rotations differ by little more than the vectors. */
    @Test
    void theSquareOfALightTurnsSmoothlyThroughTheHorizon() {
        double step = 1e-9;
        for (int i = 0; i < 360; i++) {
            double angle = Math.toRadians(i);
            Vectors.Axes above = Vectors.around(new Vector(Math.cos(angle), step, Math.sin(angle)).unit());
            Vectors.Axes below = Vectors.around(new Vector(Math.cos(angle), -step, Math.sin(angle)).unit());
            assertTrue(above.u().minus(below.u()).length() < 5 * step);
            assertTrue(above.v().minus(below.v()).length() < 5 * step);
        }
    }

    static Vector randomUnit(SplittableRandom random) {
        while (true) {
            Vector v = new Vector(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
            if (v.length() > 1e-3 && v.length() <= 1) {
                return v.unit();
            }
        }
    }

    private static void assertOrthonormal(Vectors.Axes basis) {
        assertEquals(1, basis.u().length(), EIGHT_ULP);
        assertEquals(1, basis.v().length(), EIGHT_ULP);
        assertEquals(0, basis.u().dot(basis.v()), EIGHT_ULP);
        assertEquals(0, basis.u().dot(basis.w()), EIGHT_ULP);
        assertEquals(0, basis.v().dot(basis.w()), EIGHT_ULP);
        assertEquals(0, basis.u().cross(basis.v()).minus(basis.w()).length(), 2 * EIGHT_ULP);
    }
}
