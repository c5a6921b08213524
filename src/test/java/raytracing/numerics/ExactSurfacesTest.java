package raytracing.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.math.BigDecimal;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import raytracing.math.ExactVector;
import raytracing.math.Vector;
import raytracing.surface.Plane;

/** Who tests the oracles? Cases solved by hand, and tables that somebody else worked out. */
class ExactSurfacesTest {
    /** Rays run along +z from (0, y, z), sphere of radius 1 at the origin. */
    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "through the middle,                        0,                   -5,         4",
        "touching,                                  1,                   -5,         5",
        "an ulp beyond touching,  0x1.0000000000001p0,                   -5,  Infinity",
        "from inside,                             0.6,                  0.5,       0.3",
        "from the wall inwards,                     0,                   -1,         2",
        "from the wall outwards,                    0,                    1,  Infinity",
        "an ulp outside the wall,                   0, -0x1.0000000000001p0,  0x1p-52",
        "from behind,                               0,                    5,  Infinity",
    })
    void spheresSolvedByHand(String why, double y, double z, double expected) {
        Query query = new Query(new Vector(0, y, z), new Vector(0, 0, 1), Vector.ZERO, 1);
        assertEquals(expected, Shape.SPHERE.exactAnswer(query).wanted(), why);
    }

    /** Plane 3 y = 6. */
    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "straight down on it,            5,    -1,                    3",
        "away from it,                   5,     1,             Infinity",
        "along it,                       5,     0,             Infinity",
        "inside it,                      2,     0,             Infinity",
        "starting on it,                 2,    -1,             Infinity",
        "nearly along it,                5, -0x1p-1000, 0x1.8p1001",
    })
    void planesSolvedByHand(String why, double y, double dy, double expected) {
        Query query = new Query(new Vector(7, y, 9), new Vector(1, dy, 0), new Vector(0, 3, 0), 6);
        assertEquals(expected, Shape.PLANE.exactAnswer(query).wanted(), why);
    }

    /** Cube from -1 to 1. */
    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "head-on,                    0,   0,  -5,    0, 0, 1,         4",
        "in the plane of a face,     1,   0,  -5,    0, 0, 1,         4",
        "an ulp beside a face, 0x1.0000000000001p0, 0, -5, 0, 0, 1, Infinity",
        "through an edge,           -3,   0,  -5,    1, 0, 1,         4",
        "through a corner,          -3,  -3,  -3,    1, 1, 1,         2",
        "past an edge,              -3,   0,  -6,    1, 0, 1,  Infinity",
        "from inside,              0.5, 0.5, 0.5,    1, 2, 4,     0.125",
        "from a face inwards,       -1,   0,   0,    1, 0, 0,         2",
        "from a face outwards,       1,   0,   0,    1, 0, 0,  Infinity",
        "a smallest part outwards,   1,   0,  -5, 0x1p-1074, 0, 1, Infinity",
        "a smallest part inwards,    1,   0,  -5, -0x1p-1074, 0, 1,       4",
    })
    void boxesSolvedByHand(String why, double x, double y, double z, double dx, double dy, double dz,
                           double expected) {
        Query query = new Query(new Vector(x, y, z), new Vector(dx, dy, dz), Vector.ZERO, 2);
        assertEquals(expected, Shape.BOX.exactAnswer(query).wanted(), why);
    }

    @ParameterizedTest(name = "a point ({0}, {1}, {2}) from the middle")
    @CsvSource({
        "1.5,   0, 0, 0.5",
        "0.75,  0, 0, 0.25",
        "1,   1.5, 0, 0.5",
        "-1,    0, 0, 2",
    })
    void distancesFromAFaceSolvedByHand(double x, double y, double z, double expected) {
        ExactVector point = ExactVector.of(new Vector(x, y, z));
        assertEquals(expected, ExactBox.distanceToFace(point, new Vector(1, 0, 0), ExactBox.half(2)).doubleValue());
    }

    @ParameterizedTest
    @EnumSource
    void theTablesOfExactAnswersAgreeToTheLastBit(Shape shape) {
        Failures.assertNone(Row.of(shape).stream().filter(Row::isWithoutLimits)
            .filter(row -> !Objects.equals(row.answer(), shape.exactAnswer(row.query())))
            .map(row -> row.id() + ": table " + row.answer() + ", oracle " + shape.exactAnswer(row.query())));
    }

    /** Newton's steps must not lose what the sign of c decided: the ends of a chord are where the sphere is. */
    @Test
    void bothEndsOfAChordAreOnTheSphereToFiftyDigits() {
        Failures.assertNone(SphereFamily.INSIDE.queries(1, 200).stream()
            .filter(query -> ExactSphere.chord(query).stream()
                .anyMatch(chord -> isOff(query, chord.near()) || isOff(query, chord.far())))
            .map(Query::toString));
    }

    private static boolean isOff(Query query, BigDecimal t) {
        ExactVector point = ExactVector.of(query.origin()).plus(t, ExactVector.of(query.direction()));
        return ExactSphere.distance(point, ExactVector.of(query.vector()), new BigDecimal(query.scalar()))
            .doubleValue() > 1e-50;
    }
}
