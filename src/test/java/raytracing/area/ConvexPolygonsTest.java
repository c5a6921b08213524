package raytracing.area;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ConvexPolygonsTest {
    private final ConvexPolygons polygons = new ConvexPolygons();

    /** The square from (-1, -1) to (1, 1), seen from a half-plane. */
    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "through the middle,       1, 0, 0,     CUT,    2",
        "a quarter on the left,    1, 0, -0.5,  CUT,    1",
        "along a diagonal,         1, 1, 0,     CUT,    2",
        "a corner,                 1, 1, -1,    CUT,    0.5",
        "all but a corner,         1, 1, 1,     CUT,    3.5",
        "far away on its side,     1, 2, 9,     WITHIN, 4",
        "far away on the other,    1, 2, -9,    BEYOND, 0",
        "on the far side's border, 0, 1, 1,     WITHIN, 4",
        "on the near border,       0, 1, -1,    BEYOND, 0",
        "on a corner,              1, 1, 2,     WITHIN, 4",
        "on the opposite corner,   1, 1, -2,    BEYOND, 0",
        "the whole plane,          0, 0, 1,     WITHIN, 4",
        "no plane at all,          0, 0, -1,    BEYOND, 0",
    })
    void halfPlanesCutASquare(String why, double a, double b, double c, Side side, double area) {
        int square = polygons.addSquare(1);
        assertEquals(side, polygons.side(square, a, b, c), why);
        assertEquals(area, polygons.area(polygons.cut(square, a, b, c)), why);
        assertEquals(4, polygons.area(square), "it stays");
    }

    @Test
    void theTwoPartsOfACutHaveTheSameCornersOnIt() {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 10_000; i++) {
            polygons.dropTo(0);
            int polygon = randomPolygon(random);
            double angle = random.nextDouble(2 * Math.PI);
            double a = Math.cos(angle);
            double b = Math.sin(angle);
            double c = random.nextDouble(-0.5, 0.5);
            int part = polygons.cut(polygon, a, b, c);
            int rest = polygons.cut(polygon, -a, -b, -c);
            assertEquals(polygons.area(polygon), polygons.area(part) + polygons.area(rest), 2e-15);
            int shared = 0;
            for (int k = polygons.from(part); k < polygons.to(part); k++) {
                shared += isCorner(rest, polygons.x(k), polygons.y(k)) ? 1 : 0;
            }
            assertEquals(polygons.side(polygon, a, b, c) == Side.CUT ? 2 : 0, shared);
        }
    }

    /** The square of width 2, cut by up to four lines that leave its middle. */
    private int randomPolygon(SplittableRandom random) {
        int polygon = polygons.addSquare(1);
        for (int i = random.nextInt(5); i > 0; i--) {
            double angle = random.nextDouble(2 * Math.PI);
            polygon = polygons.cut(polygon, Math.cos(angle), Math.sin(angle), random.nextDouble(0.1, 1));
        }
        return polygon;
    }

    private boolean isCorner(int polygon, double x, double y) {
        for (int i = polygons.from(polygon); i < polygons.to(polygon); i++) {
            if (polygons.x(i) == x && polygons.y(i) == y) {
                return true;
            }
        }
        return false;
    }

    @Test
    void cutsTurnedByARightAngleLeaveTheSameArea() {
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < 1_000; i++) {
            polygons.dropTo(0);
            int polygon = polygons.addSquare(1);
            int turned = polygon;
            for (int k = 0; k < 4; k++) {
                double a = random.nextDouble(-1, 1);
                double b = random.nextDouble(-1, 1);
                double c = random.nextDouble(0, 1);
                polygon = polygons.cut(polygon, a, b, c);
                turned = polygons.cut(turned, -b, a, c);
            }
            assertEquals(polygons.area(polygon), polygons.area(turned), 4e-15);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 4, 16, 64, 1 << 12})
    void regularPolygonsHaveTheAreaOfTheirDisc(int sides) {
        int polygon = polygons.addRegular(3, -2, 0.5, sides);
        assertEquals(sides, polygons.to(polygon) - polygons.from(polygon));
        assertEquals(Math.PI / 4, polygons.area(polygon), 1e-13);
    }

    @Test
    void regularPolygonsHaveAllCornersAsFarFromTheMiddle() {
        int polygon = polygons.addRegular(3, -2, 0.5, 1 << 12);
        double distance = polygons.x(polygons.from(polygon)) - 3;
        for (int i = polygons.from(polygon); i < polygons.to(polygon); i++) {
            assertEquals(distance, Math.hypot(polygons.x(i) - 3, polygons.y(i) + 2), 1e-13);
        }
    }

    /** Of two squares, the common part is a rectangle, once they are moved apart by cuts. */
    @Test
    void rectanglesHaveARectangleInCommon() {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 1_000; i++) {
            polygons.dropTo(0);
            double[] one = {random.nextDouble(), random.nextDouble(), random.nextDouble(), random.nextDouble()};
            double[] two = {random.nextDouble(), random.nextDouble(), random.nextDouble(), random.nextDouble()};
            double width = Math.min(one[0], two[0]) + Math.min(one[1], two[1]);
            double height = Math.min(one[2], two[2]) + Math.min(one[3], two[3]);
            int common = polygons.common(rectangle(one), rectangle(two));
            assertEquals(width * height, polygons.area(common), 1e-15);
        }
    }

    /** How far it reaches from (0, 0): to the left and the right, down and up. */
    private int rectangle(double[] reach) {
        int polygon = polygons.addSquare(2);
        polygon = polygons.cut(polygon, 1, 0, reach[0]);
        polygon = polygons.cut(polygon, -1, 0, reach[1]);
        polygon = polygons.cut(polygon, 0, 1, reach[2]);
        return polygons.cut(polygon, 0, -1, reach[3]);
    }

    @Test
    void polygonsApartHaveNothingInCommon() {
        int left = polygons.cut(polygons.addSquare(1), -1, 0, -0.5);
        int right = polygons.addRegular(1, 0, 0.7, 12);
        assertEquals(0, polygons.area(polygons.common(left, right)));
        assertEquals(0, polygons.area(polygons.common(right, left)));
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "the middle,          0,    0,    true",
        "on a side,           1,    0.5,  true",
        "on a corner,        -1,    1,    true",
        "beside it,           1.01, 0,    false",
        "beyond a corner,     1.01, 1.01, false",
        "in line with a side, 1,    2,    false",
    })
    void pointsOfASquare(String why, double x, double y, boolean isInside) {
        assertEquals(isInside, polygons.contains(polygons.addSquare(1), x, y), why);
    }

    @Test
    void aPolygonOnTopCanBeDroppedAndAnotherTakesItsPlace() {
        int square = polygons.addSquare(1);
        int mark = polygons.count();
        polygons.cut(square, 1, 0, 0);
        polygons.dropTo(mark);
        assertEquals(mark, polygons.count());
        assertEquals(mark, polygons.cut(square, 1, 0, -0.5));
        assertEquals(1, polygons.area(mark));
    }

    @Test
    void theStackGrowsAsItHasTo() {
        for (int i = 0; i < 1_000; i++) {
            assertEquals(i, polygons.addSquare(i + 1));
        }
        for (int i = 0; i < 1_000; i++) {
            assertEquals(4.0 * (i + 1) * (i + 1), polygons.area(i));
        }
    }

    @Test
    void nothingIsLeftOfNothing() {
        int nothing = polygons.cut(polygons.addSquare(1), 0, 0, -1);
        assertEquals(0, polygons.area(nothing));
        assertEquals(0, polygons.area(polygons.cut(nothing, 1, 0, 0)));
        assertTrue(polygons.from(nothing) == polygons.to(nothing));
        assertFalse(polygons.side(nothing, 1, 0, 0) == Side.CUT);
    }
}
