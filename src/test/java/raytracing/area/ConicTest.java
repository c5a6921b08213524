package raytracing.area;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Areas of conics in polygons, against closed forms and integrals. */
class ConicTest {
    private final ConvexPolygons polygons = new ConvexPolygons();
    private final Conic conic = new Conic();

    /** The figures at their simplest, seen through an affine map: (m00 x + m01 y + e, m10 x + m11 y + f). */
    private record Map(double m00, double m01, double m10, double m11, double e, double f) {
        static Map random(SplittableRandom random) {
            while (true) {
                Map map = new Map(random.nextDouble(-1.5, 1.5), random.nextDouble(-1.5, 1.5),
                    random.nextDouble(-1.5, 1.5), random.nextDouble(-1.5, 1.5),
                    random.nextDouble(-2, 2), random.nextDouble(-2, 2));
                if (Math.abs(map.determinant()) > 0.1) {
                    return map;
                }
            }
        }

        double determinant() {
            return m00 * m11 - m01 * m10;
        }

        double x(double x, double y) {
            return m00 * x + m01 * y + e;
        }

        double y(double x, double y) {
            return m10 * x + m11 * y + f;
        }

        /** Makes the conic the figure whose image is the simple one. */
        void set(Conic conic, CanonicalConic simple) {
            double xx = simple.xx;
            conic.setForm(xx * m00 * m00 - m10 * m10, xx * m00 * m01 - m10 * m11, xx * m01 * m01 - m11 * m11,
                (xx * e + simple.x0) * m00 - f * m10, (xx * e + simple.x0) * m01 - f * m11,
                xx * e * e - f * f + 2 * simple.x0 * e + simple.c);
            if (simple == CanonicalConic.HYPERBOLA) {
                conic.setLine(m00, m01, e);
            } else {
                conic.setLine(0, 0, 1);
            }
            if (simple == CanonicalConic.DISC) {
                conic.setEllipse((m01 * f - m11 * e) / determinant(), (m10 * e - m00 * f) / determinant(),
                    Math.PI / Math.abs(determinant()));
            }
        }

        /** The part of a polygon that is on the inner side of a line in the image. */
        int cut(ConvexPolygons polygons, int polygon, double a, double b, double c) {
            return polygons.cut(polygon, a * m00 + b * m10, a * m01 + b * m11, a * e + b * f + c);
        }

        /** The area of the figure in a polygon. */
        double area(CanonicalConic simple, ConvexPolygons polygons, int polygon) {
            int from = polygons.from(polygon);
            double[] cornersX = new double[polygons.to(polygon) - from];
            double[] cornersY = cornersX.clone();
            for (int i = 0; i < cornersX.length; i++) {
                cornersX[i] = x(polygons.x(from + i), polygons.y(from + i));
                cornersY[i] = y(polygons.x(from + i), polygons.y(from + i));
            }
            return cornersX.length < 3 ? 0 : simple.area(cornersX, cornersY) / Math.abs(determinant());
        }
    }

    private int randomPolygon(SplittableRandom random) {
        double size = Math.exp(random.nextDouble(-2, 1.5));
        int polygon = polygons.addSquare(size);
        for (int i = random.nextInt(5); i > 0; i--) {
            double angle = random.nextDouble(2 * Math.PI);
            polygon = polygons.cut(polygon, Math.cos(angle), Math.sin(angle), random.nextDouble(-0.3, 1) * size);
        }
        return polygon;
    }

    /** So far from (0, 0), the polygon's corners are one point. Pieces of a light are, between triangles that share a corner. */
    @Test
    void aPolygonShrunkToAPointHoldsNoDisc() {
        int polygon = polygons.addRegular(1, 1, 1e-30, 3);
        conic.setDisc(3, 1, 0.5);
        assertEquals(0, conic.area(polygons, polygon));
        assertEquals(Side.BEYOND, conic.side(polygons, polygon));
    }

    /** Errors are below 5e-12 in 400 000 such cases, and mostly below 1e-15. */
    @ParameterizedTest
    @EnumSource(CanonicalConic.class)
    void conicsInPolygonsHaveTheAreaOfTheirIntegral(CanonicalConic simple) {
        SplittableRandom random = new SplittableRandom(1);
        int cut = 0;
        for (int i = 0; i < 1_000; i++) {
            polygons.dropTo(0);
            Map map = Map.random(random);
            map.set(conic, simple);
            int polygon = randomPolygon(random);
            double whole = polygons.area(polygon);
            double expected = map.area(simple, polygons, polygon);
            assertEquals(expected, conic.area(polygons, polygon), 1e-11 * Math.max(whole, 1e-3), map::toString);
            boolean isCut = expected > 1e-9 * whole && expected < (1 - 1e-9) * whole;
            if (isCut) {
                assertEquals(Side.CUT, conic.side(polygons, polygon));
                cut++;
            }
        }
        assertTrue(cut > 300, cut + " figures cut");
    }

    /** The polygon ends so far beyond a tangent of the figure, on one side of it or on the other. */
    @ParameterizedTest
    @ValueSource(doubles = {0.1, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 1e-17, 0, -1e-17, -1e-15, -1e-12, -1e-9, -1e-6, -1e-3,
        -0.1})
    void sidesThatBarelyTouch(double beyond) {
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < 60; i++) {
            polygons.dropTo(0);
            CanonicalConic simple = CanonicalConic.values()[i % 3];
            Map map = Map.random(random);
            map.set(conic, simple);
            CanonicalConic.Tangent touched = simple.tangent(random.nextDouble(-1, 1));
            double side = random.nextBoolean() ? 1 : -1;
            int polygon = cutBeyond(map, polygons.addSquare(8), touched, beyond, side, 0);
            assertSameArea(map, simple, polygon);
        }
    }

    /**
     * As above, but two sides meet at the touch, at all sorts of angles. What crosses there has a chord as short as
     * rounding, in no sure direction.
     */
    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1e-9, 1e-15, 1e-16, 0, -1e-16, -1e-15, -1e-9, -1e-3})
    void cornersThatBarelyTouch(double beyond) {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 120; i++) {
            polygons.dropTo(0);
            CanonicalConic simple = CanonicalConic.values()[i % 3];
            Map map = Map.random(random);
            map.set(conic, simple);
            CanonicalConic.Tangent touched = simple.tangent(random.nextDouble(-1, 1));
            double side = random.nextBoolean() ? 1 : -1;
            double turn = Math.pow(10, random.nextDouble(-17, 0));
            int polygon = cutBeyond(map, polygons.addSquare(8), touched, beyond, side, turn);
            assertSameArea(map, simple, cutBeyond(map, polygon, touched, beyond, side, -random.nextDouble() * turn));
        }
    }

    private int cutBeyond(Map map, int polygon, CanonicalConic.Tangent touched, double beyond, double side,
                          double turn) {
        double a = touched.outX() * Math.cos(turn) - touched.outY() * Math.sin(turn);
        double b = touched.outY() * Math.cos(turn) + touched.outX() * Math.sin(turn);
        return map.cut(polygons, polygon, -side * a, -side * b, side * (a * touched.x() + b * touched.y() + beyond));
    }

    private void assertSameArea(Map map, CanonicalConic simple, int polygon) {
        double expected = map.area(simple, polygons, polygon);
        double accuracy = 1e-12 * Math.max(polygons.area(polygon), 1);
        assertEquals(expected, conic.area(polygons, polygon), accuracy, map::toString);
    }

    /** Lines through one point of a disc's outline: rounding once made all of the disc out of the touch of a corner. */
    @Test
    void aCornerOnADiscDoesNotHaveTheDiscInIt() {
        SplittableRandom random = new SplittableRandom(4);
        for (int i = 0; i < 20_000; i++) {
            polygons.dropTo(0);
            double x = random.nextDouble(-1, 1);
            double y = random.nextDouble(-1, 1);
            double angle = random.nextDouble(2 * Math.PI);
            double wider = random.nextDouble(0, 1.5);
            double narrower = random.nextDouble(0, 1.5);
            conic.setDisc(x, y, 1);
            double cornerX = x + Math.cos(angle);
            double cornerY = y + Math.sin(angle);
            int polygon = cutThrough(polygons.addSquare(8), cornerX, cornerY, angle + wider);
            polygon = cutThrough(polygon, cornerX, cornerY, angle - narrower);
            assertEquals(0, conic.area(polygons, polygon), 1e-13);
        }
    }

    private int cutThrough(int polygon, double x, double y, double angle) {
        double a = Math.cos(angle);
        double b = Math.sin(angle);
        return polygons.cut(polygon, a, b, -a * x - b * y);
    }

    /** In the square from (-1, -1) to (1, 1). */
    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "inside,                 0.1,  0.2, 0.5,  CUT,    0.78539816339744831",
        "as wide as the square,  0,    0,   1,    CUT,    3.14159265358979323",
        "all over the square,    0.2,  0.1, 3,    WITHIN, 4",
        "through all corners,    0,    0,   1.4142135623730951, WITHIN, 4",
        "over all four sides,    0,    0,   1.25, CUT,    3.8868565912760253",
        "half across a side,     1,    0,   0.5,  CUT,    0.39269908169872415",
        "a quarter in a corner,  1,   -1,   0.5,  CUT,    0.19634954084936207",
        "round two corners,      2,    0,   1.5,  CUT,    0.75992121526056917",
        "beside it,              2,    0,   0.5,  BEYOND, 0",
        "touching from outside,  2,    0,   1,    BEYOND, 0",
        "touching from inside,   0.5,  0,   0.5,  CUT,    0.78539816339744831",
        "far beyond a corner,    2,    2,   1.25, BEYOND, 0",
        "a point,                0,    0,   0,    BEYOND, 0",
    })
    void discsInASquare(String why, double x, double y, double radius, Side side, double expected) {
        conic.setDisc(x, y, radius);
        int square = polygons.addSquare(1);
        assertEquals(expected, conic.area(polygons, square), 2e-15, why);
        assertEquals(side, conic.side(polygons, square), why);
    }

    /** Up to x = 1, a parabola is two thirds of the rectangle around it. */
    @Test
    void aParabolaHasTwoThirdsOfItsRectangle() {
        conic.setForm(0, 0, -1, 0.5, 0, 0);
        conic.setLine(0, 0, 1);
        assertEquals(4 / 3.0, conic.area(polygons, polygons.addSquare(1)), 1e-15);
    }

    /** x x - y y &gt;= 1 has two branches, in the square to 2 of the area x sqrt(x x - 1) - arcosh x each. */
    @ParameterizedTest
    @ValueSource(doubles = {1, -1})
    void aHyperbolaIsOneOfItsBranches(double side) {
        conic.setForm(1, 0, -1, 0, 0, -1);
        conic.setLine(side, 0, 0);
        double expected = 2 * Math.sqrt(3) - Math.log(2 + Math.sqrt(3));
        assertEquals(expected, conic.area(polygons, polygons.addSquare(2)), 4e-15);
    }

    /** There is only the other branch. */
    @Test
    void nothingOfABranchIsBeyondTheLineBetweenThem() {
        conic.setForm(1, 0, -1, 0, 0, -1);
        conic.setLine(1, 0, 0);
        int half = polygons.cut(polygons.addSquare(3), -1, 0, 0);
        assertEquals(0, conic.area(polygons, half));
        assertEquals(Side.BEYOND, conic.side(polygons, half));
    }

    /** Everything beyond x = 1/4, when the branches close on a double line. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-6, 1e-12, 1e-20, 0})
    void aHyperbolaThatIsNearlyADoubleLineHasOneSideOfIt(double gap) {
        conic.setForm(1, 0, -gap, -0.25, 0, 0.0625 - gap);
        conic.setLine(1, 0, -0.25);
        assertEquals(1.5, conic.area(polygons, polygons.addSquare(1)), 3 * Math.sqrt(gap) + 4e-8);
    }

    @ParameterizedTest
    @EnumSource(CanonicalConic.class)
    void theAreasInBothPartsOfACutAddUp(CanonicalConic simple) {
        SplittableRandom random = new SplittableRandom(5);
        for (int i = 0; i < 5_000; i++) {
            polygons.dropTo(0);
            Map.random(random).set(conic, simple);
            int polygon = polygons.addSquare(2);
            double angle = random.nextDouble(2 * Math.PI);
            double a = Math.cos(angle);
            double b = Math.sin(angle);
            double c = random.nextDouble(-2, 2);
            double parts = conic.area(polygons, polygons.cut(polygon, a, b, c))
                + conic.area(polygons, polygons.cut(polygon, -a, -b, -c));
            assertEquals(conic.area(polygons, polygon), parts, 1e-12);
        }
    }

    /** Q may have any unit. */
    @ParameterizedTest
    @ValueSource(doubles = {0x1p-200, 0x1p-9, 2, 0x1p200})
    void powersOfTwoInQLeaveTheSameBits(double unit) {
        SplittableRandom random = new SplittableRandom(6);
        int square = polygons.addSquare(1);
        int crossed = 0;
        for (int i = 0; i < 1_000; i++) {
            double xy = random.nextDouble(-0.9, 0.9);
            double x0 = random.nextDouble(-1, 1);
            double y0 = random.nextDouble(-1, 1);
            conic.setLine(0, 0, 1);
            conic.setForm(-1, xy, -1, x0, y0, 0.1);
            double expected = conic.area(polygons, square);
            conic.setForm(-unit, unit * xy, -unit, unit * x0, unit * y0, unit * 0.1);
            assertEquals(expected, conic.area(polygons, square));
            crossed += expected > 0 ? 1 : 0;
        }
        assertTrue(crossed > 500, crossed + " outlines crossed");
    }
}
