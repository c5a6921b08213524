package raytracing.area;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The shadow of one ball on the square from (-1, -1) to (1, 1). */
class BallShadowTest {
    private final ConvexPolygons polygons = new ConvexPolygons();
    private final int square = polygons.addSquare(1);
    private final BallShadow shadow = new BallShadow();

    private double area(double x, double y, double z, double r, double depth) {
        shadow.set(x, y, z, r, 0, depth);
        return shadow.area(polygons, square);
    }

    /** The integral over y of what the ball hides of a line, parted where neighbours meet the shadow in another way. */
    private static double integral(double x, double y, double z, double r, double depth) {
        double size = depth / 4 / (Math.abs(z) + r);        // so small that all of the ball is before the plane
        LightOnLines lines = new LightOnLines(depth, 1);
        LightOnLines.Ball ball = lines.new Ball(x * size, y * size, z * size, r * size, 0);
        LightOnLines.Ball turned = lines.new Ball(y * size, x * size, z * size, r * size, 0);
        double middle = Math.atan2(y, z);
        double opening = Math.asin(r / Math.hypot(y, z));
        double[] ends = DoubleStream.of(middle - opening, middle + opening)
            .filter(angle -> Math.abs(angle) < Math.PI / 2).map(angle -> depth * Math.tan(angle)).toArray();
        double[] between = {-1, -3 * depth, -depth, -depth / 3, 0, depth / 3, depth, 3 * depth, 1};
        double[] places = List.of(ends, turned.changes(-1), turned.changes(1), between).stream()
            .flatMapToDouble(Arrays::stream).filter(place -> Math.abs(place) <= 1).toArray();
        return Quadrature.integral(place -> 2 - lines.lightOfLine(place, List.of(ball)), places);
    }

    /**
     * The apex is outside by so many radii. The nearer it is, the more does the shadow hang on the last bits of the
     * ball, as the root of k does.
     */
    @ParameterizedTest
    @ValueSource(doubles = {3, 1, 0.1, 1e-2, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15})
    void shadowsHaveTheAreaOfTheirIntegral(double outside) {
        SplittableRandom random = new SplittableRandom(1);
        int cut = 0;
        for (int i = 0; i < 30; i++) {
            double x = random.nextDouble(-1, 1);
            double y = random.nextDouble(-1, 1);
            double z = random.nextDouble(-0.5, 1);
            double r = Math.sqrt(x * x + y * y + z * z) / (1 + outside);
            double depth = Math.exp(random.nextDouble(-2, 2));
            double expected = integral(x, y, z, r, depth);
            double accuracy = 1e-12 + 1e-14 / Math.sqrt(outside);
            assertEquals(expected, area(x, y, z, r, depth), accuracy, () -> x + " " + y + " " + z + ", depth " + depth);
            cut += expected > 0 && expected < 4 ? 1 : 0;
        }
        assertTrue(cut > 8, cut + " shadows cut");
    }

    /** The tangent plane there is the border of all that the ball hides. */
    @Test
    void aBallThatTheApexLiesOnHidesHalfOfSpace() {
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < 2_000; i++) {
            polygons.dropTo(square + 1);
            double x = i % 4 == 0 ? 0 : random.nextDouble(-1, 1);
            double y = i % 4 == 1 ? 0 : random.nextDouble(-1, 1);
            double z = i % 4 == 2 ? 0 : random.nextDouble(-1, 1);
            double r = Math.sqrt(x * x + y * y + z * z);
            double depth = Math.exp(random.nextDouble(-2, 2));
            double expected = polygons.area(polygons.cut(square, x, y, z * depth));
            assertEquals(expected, area(x, y, z, r, depth), 1e-6);
        }
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "a disc inside,                   0,     0, 5,  3, 1,   1.7671458676442586",
        "a disc as wide as the square,    0,     0, 5,  3, 1.3333333333333333, 3.141592653589793",
        "a disc that covers the square,   0,     0, 5,  4, 1.25, 4",
        "a parabola,                      1,     0, 1,  1, 1,   1.6666666666666667",
        "the same on the other side,     -1,     0, 1,  1, 1,   1.6666666666666667",
        "the same turned,                 0,    -1, 1,  1, 1,   1.6666666666666667",
        "beside the apex a hyperbola,     2,     0, 0,  1, 0.5, 0.05081859687072654",
        "below the apex,                  0,     0, -5, 3, 1,   0",
    })
    void shadowsSolvedByHand(String why, double x, double y, double z, double r, double depth, double expected) {
        assertEquals(expected, area(x, y, z, r, depth), 3e-15, why);
    }

    /** A small ellipse: the ball's disc over the square of the distance, and once more slanted, in the limit. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-4, 1e-6, 1e-8, 1e-12})
    void tinyBallsFarAwayKeepTheirDigits(double r) {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 200; i++) {
            double x = random.nextDouble(-0.4, 0.4);
            double y = random.nextDouble(-0.4, 0.4);
            double z = random.nextDouble(0.5, 1);
            double expected = Math.PI * r * r * Math.sqrt(x * x + y * y + z * z) / (z * z * z);
            assertEquals(expected, area(x, y, z, r, 1), 20 * (r * r + 1e-16) * expected);
        }
    }

    @Test
    void onlyTheShapeCounts() {
        SplittableRandom random = new SplittableRandom(4);
        for (int i = -500; i <= 500; i++) {
            double x = random.nextDouble(-1, 1);
            double y = random.nextDouble(-1, 1);
            double z = random.nextDouble(0.5, 1);
            double size = Math.scalb(1.0, i);
            assertEquals(area(x, y, z, 0.3, 1), area(size * x, size * y, size * z, size * 0.3, 1));
        }
    }

    /** Of half-angles and the angle between the axes. */
    @Test
    void shadowsAreApartWhenTheirConesAre() {
        SplittableRandom random = new SplittableRandom(5);
        BallShadow other = new BallShadow();
        int apart = 0;
        for (int i = 0; i < 10_000; i++) {
            double angle = random.nextDouble(Math.PI);
            double first = random.nextDouble(Math.PI / 2);
            double second = random.nextDouble(Math.PI / 2);
            double distance = random.nextDouble(1, 9);
            shadow.set(0, 3, 0, 3 * Math.sin(first), 0, 1);
            other.set(0, distance * Math.cos(angle), distance * Math.sin(angle), distance * Math.sin(second), 0, 1);
            if (Math.abs(angle - first - second) > 1e-6) {
                assertEquals(angle > first + second, shadow.isApartFrom(other));
                assertEquals(angle > first + second, other.isApartFrom(shadow));
                apart += angle > first + second ? 1 : 0;
            }
        }
        assertTrue(apart > 1_000 && apart < 9_000, apart + " apart");
    }

    @Test
    void aShadowIsNotApartFromItself() {
        shadow.set(0.1, 0.2, 0.9, 0.01, 0, 1);
        assertFalse(shadow.isApartFrom(shadow));
    }
}
