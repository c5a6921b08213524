package raytracing.numerics;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/** The product's crossings against exact arithmetic, on random rays that are hard for one reason each. */
class HardRaysTest {
    private static final long SEED = 7;
    private static final int SIZE = 20_000;

    /**
     * On 20 000 rays of a family the bounds ask for more than 106 bits where an origin lies on a sphere or a plane: there,
     * double-double throughout is off by up to 159 and 29 ulps. Everywhere else it is off by at most 1.
     */
    @ParameterizedTest(name = "{0}")
    @MethodSource(AllFamilies.NAMED)
    void everyCrossingIsTheExactOneButForItsLastDigits(Family family) {
        Formula ours = family.shape().ours().formula();
        Sample sample = family.sample(SEED, SIZE);
        Sample.Errors errors = sample.errorsOf(ours);
        assertTrue(errors.wrongShare() == 0 && errors.worst() <= family.shape().allowedUlps(),
            () -> errors + "; worst: " + sample.worstAnswer(ours));
    }

    /**
     * Centre, radius, direction and the point of contact are whole numbers, so that these rays touch exactly: the
     * radius leads from the centre to the point, at a right angle to the ray.
     */
    @ParameterizedTest(name = "radius ({0} {1} {2}), direction ({3} {4} {5})")
    @CsvSource({
        "3, 4, 0,    4, -3,  0,    5",
        "2, 3, 6,    6, -2, -1,    7",
        "1, 2, 2,    2,  1, -2,    3",
        "4, 4, 7,    1, -1,  0,    9",
        "0, 0, 1,    5, 11,  0,    1",
    })
    void aRayThatTouchesASphereHitsIt(double x, double y, double z, double dx, double dy, double dz, double r) {
        Vector centre = new Vector(100, -200, 300);
        Vector direction = new Vector(dx, dy, dz);
        Query touching = new Query(Vectors.plus(Vectors.plus(centre, new Vector(x, y, z)), -64, direction), direction,
            centre, r);
        Query passing = new Query(touching.origin(), direction, centre, Math.nextDown(r));
        Formula ours = Shape.SPHERE.ours().formula();
        assertTrue(ours.firstCrossing(touching) == 64, touching::toString);
        assertTrue(ours.firstCrossing(passing) == Formula.MISS, passing::toString);
    }
}
