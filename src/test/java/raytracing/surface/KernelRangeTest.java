package raytracing.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import raytracing.math.Surd;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/**
 * Wherever a kernel answers, exact numbers give the same answer: for numbers from the whole range of doubles, and for
 * points whose error is as large as a surface. How often it answers is the matter of {@link QuickStepTest}.
 */
class KernelRangeTest {
    private static final int CASES = 20_000;

    /** Of all questions, some that must be answered: otherwise this would be a test of nothing. */
    private static final int LEAST_ANSWERS = 300;
    private static final int NUMBER = 0;
    private static final int LEAST_EXPONENT = -1074;
    private static final int MOST_EXPONENT = 1023;

    private enum Shape {
        SPHERE(16) {
            @Override
            Surface surface(Vector vector, double scalar) {
                return new Sphere(vector, Math.abs(scalar), 0);
            }
        },

        PLANE(16) {
            @Override
            Surface surface(Vector vector, double scalar) {
                return new Plane(vector, scalar, 0);
            }
        },

        BOX(2) {
            @Override
            Surface surface(Vector vector, double scalar) {
                return new Box(vector, Math.abs(scalar), 0);
            }
        },

        /** One corner is at the vector; two edges are of the scalar's size, if it is not too small beside the vector. */
        TRIANGLE(4) {
            @Override
            Surface surface(Vector vector, double scalar) {
                Vector next = finite(Vectors.plus(vector, scalar, new Vector(1, 0.25, -0.5)));
                Vector last = finite(Vectors.plus(vector, scalar, new Vector(-0.75, 1, 0.125)));
                return !Triangle.areOnALine(vector, next, last) ? Triangle.of(vector, next, last, 0)
                    : Triangle.of(new Vector(scalar, 0, 0), new Vector(0, scalar, 0), new Vector(0, 0, scalar), 0);
            }
        };

        private final int mostUlps;

        Shape(int mostUlps) {
            this.mostUlps = mostUlps;
        }

        abstract Surface surface(Vector vector, double scalar);

        private static Vector finite(Vector v) {
            return new Vector(finite(v.x()), finite(v.y()), finite(v.z()));
        }

        private static double finite(double number) {
            return Math.max(-Double.MAX_VALUE, Math.min(Double.MAX_VALUE, number));
        }
    }

    /** A ray from o along d, a line from o to q, how far off both ends may be, and a surface. */
    private record Case(Vector o, Vector d, Vector q, double error, double endError, Surface surface) {
    }

    /** What makes the numbers of a case. */
    @FunctionalInterface
    private interface Numbers {
        Case next(SplittableRandom random, Shape shape);
    }

    /** Lengths of one size, now and then of another; the size itself from anywhere in the range. */
    private static Case anywhere(SplittableRandom random, Shape shape) {
        int lengths = random.nextInt(LEAST_EXPONENT, MOST_EXPONENT);
        int speeds = random.nextInt(LEAST_EXPONENT, MOST_EXPONENT);
        int normals = shape == Shape.PLANE ? random.nextInt(LEAST_EXPONENT, MOST_EXPONENT) : lengths;
        int scalars = shape == Shape.PLANE ? lengths + normals : lengths;
        Vector v = vector(random, normals);
        double error = random.nextInt(3) == 0 ? Math.abs(number(random, lengths - random.nextInt(60))) : 0;
        Vector o = vector(random, lengths);
        double halfTheScale = Math.scalb(1, speeds / 2 - lengths / 2);
        Vector towards = v.minus(o).times(halfTheScale).times(halfTheScale);
        Vector d = random.nextBoolean() && isDirection(towards) ? towards : vector(random, speeds);
        return new Case(o, d, vector(random, lengths), error, error,
            shape.surface(v.largestPart() == 0 ? new Vector(1, 0, 0) : v, nonZero(number(random, scalars))));
    }

    private static boolean isDirection(Vector vector) {
        double largest = vector.largestPart();
        return largest > 0 && largest < Double.POSITIVE_INFINITY;
    }

    private static double nonZero(double number) {
        return number == 0 ? Double.MIN_VALUE : number;
    }

    private static Vector vector(SplittableRandom random, int exponent) {
        Vector v = new Vector(number(random, exponent), number(random, exponent), number(random, exponent));
        return v.largestPart() == 0 ? new Vector(0, Double.MIN_VALUE, 0) : v;
    }

    /** Near 2 to this power, or nine times in ten so; sometimes 0, sometimes of any size at all. */
    private static double number(SplittableRandom random, int exponent) {
        int kind = random.nextInt(20);
        int power = kind == 0 ? random.nextInt(LEAST_EXPONENT, MOST_EXPONENT + 1) : exponent + random.nextInt(-2, 3);
        double size = Math.scalb(random.nextDouble(1, 2), Math.min(power, MOST_EXPONENT));
        return kind == 1 ? 0 : random.nextBoolean() ? size : -size;
    }

    /** Points close to a surface at 0, or far from it, with errors from far below its size to as large as it. */
    private static Case vague(SplittableRandom random, Shape shape) {
        double size = random.nextDouble(0.5, 1);
        Vector o = somewhere(random);
        Vector q = random.nextInt(4) == 0 ? Vectors.plus(o, 0x1p-20, somewhere(random)) : somewhere(random);
        double error = Math.scalb(size, random.nextInt(-60, 1));
        double endError = random.nextBoolean() ? error : Math.scalb(size, random.nextInt(-60, 1));
        Vector d = random.nextBoolean() ? q.minus(o) : somewhere(random);
        Vector v = shape == Shape.PLANE ? somewhere(random) : Vector.ZERO;
        return new Case(o, d, q, error, endError, shape.surface(v, shape == Shape.PLANE ? 0x1p-2 : size));
    }

    /** Up to 2 from the middle, or far from it, or a part of it 0 or tiny. */
    private static Vector somewhere(SplittableRandom random) {
        Vector v = SphereTest.randomVector(random, random.nextInt(8) == 0 ? 50 : 1.2);
        double tiny = random.nextBoolean() ? 0 : Math.scalb(1, -random.nextInt(1074));
        return switch (random.nextInt(8)) {
            case 0 -> new Vector(tiny, v.y(), v.z());
            case 1 -> new Vector(v.x(), v.y(), tiny);
            default -> v;
        };
    }

    /** The same ray from the wall of the body, as far as its origin is known. */
    private static Case onWall(SplittableRandom random, Case c) {
        Vector outwards = SphereTest.randomVector(random, 1);
        Vector o = c.surface instanceof Sphere sphere ? Vectors.plus(sphere.centre(), sphere.radius(), outwards.unit())
            : Vectors.plus(((Box) c.surface).centre(), ((Box) c.surface).edge() / 2,
                outwards.times(1 / outwards.largestPart()));
        return new Case(o, c.d, c.q, Math.max(c.error, PointError.written(o)), c.endError, c.surface);
    }

    private static Optional<Surd> exact(Case c, Departure departure) {
        boolean leaves = departure != Departure.ELSEWHERE;
        int surface = leaves ? NUMBER : RayOrigin.NO_SURFACE;
        return c.surface.exactCrossing(new RayRecord(c.o, c.error, c.d, surface, departure).toRay(), NUMBER);
    }

    @ParameterizedTest
    @EnumSource
    void crossingsInTheWholeRange(Shape shape) {
        assertCrossings(shape, 51, KernelRangeTest::anywhere, Departure.ELSEWHERE);
    }

    @ParameterizedTest
    @EnumSource
    void crossingsOfRaysFromVaguePoints(Shape shape) {
        assertCrossings(shape, 52, KernelRangeTest::vague, Departure.ELSEWHERE);
    }

    @ParameterizedTest
    @EnumSource(names = {"SPHERE", "BOX"})
    void farWallsInTheWholeRange(Shape shape) {
        assertCrossings(shape, 53, (random, asked) -> onWall(random, anywhere(random, asked)), Departure.INWARD);
    }

    @ParameterizedTest
    @EnumSource(names = {"SPHERE", "BOX"})
    void farWallsOfRaysFromVaguePoints(Shape shape) {
        assertCrossings(shape, 54, (random, asked) -> onWall(random, vague(random, asked)), Departure.INWARD);
    }

    private static void assertCrossings(Shape shape, long seed, Numbers numbers, Departure departure) {
        SplittableRandom random = new SplittableRandom(seed);
        int answers = 0;
        for (int i = 0; i < CASES; i++) {
            Case c = numbers.next(random, shape);
            double quick = SurfaceQuestions.quickCrossing(c.surface, new RayRecord(c.o, c.error, c.d, NUMBER, departure),
                departure);
            if (!Double.isNaN(quick)) {
                assertCrossing(shape, c, quick, exact(c, departure));
                answers++;
            }
        }
        assertTrue(answers > LEAST_ANSWERS, answers + " answers");
    }

    private static void assertCrossing(Shape shape, Case c, double quick, Optional<Surd> exact) {
        assertEquals(exact.isPresent(), quick < Surface.MISS, () -> c + ": " + quick);
        exact.ifPresent(crossing -> assertTrue(crossing.signum() > 0 && quick > 0
            && Math.abs(quick - crossing.doubleValue()) <= shape.mostUlps * Math.ulp(crossing.doubleValue()),
            () -> c + ": " + quick + ", exact " + crossing.doubleValue()));
    }

    @ParameterizedTest
    @EnumSource(names = {"SPHERE", "BOX", "TRIANGLE"})
    void plainMissesInTheWholeRange(Shape shape) {
        assertPlainMisses(shape, 55, KernelRangeTest::anywhere);
    }

    @ParameterizedTest
    @EnumSource(names = {"SPHERE", "BOX", "TRIANGLE"})
    void plainMissesOfRaysFromVaguePoints(Shape shape) {
        assertPlainMisses(shape, 56, KernelRangeTest::vague);
    }

    private static void assertPlainMisses(Shape shape, long seed, Numbers numbers) {
        SplittableRandom random = new SplittableRandom(seed);
        int answers = 0;
        for (int i = 0; i < CASES; i++) {
            Case c = numbers.next(random, shape);
            double latest = random.nextBoolean() ? Surface.MISS : Math.abs(number(random, random.nextInt(-2, 3)));
            Ray ray = new RayRecord(c.o, c.error, c.d, RayOrigin.NO_SURFACE, Departure.ELSEWHERE).toRay();
            if (c.surface.firstCrossing(ray, latest) == Surface.MISS) {
                double exact = Surface.distance(exact(c, Departure.ELSEWHERE));
                assertTrue(exact == Surface.MISS || exact > latest, () -> c + ", latest " + latest + ": " + exact);
                answers++;
            }
        }
        assertTrue(answers > LEAST_ANSWERS, answers + " answers");
    }

    @ParameterizedTest
    @EnumSource
    void linesInTheWholeRange(Shape shape) {
        assertLines(shape, 57, KernelRangeTest::anywhere);
    }

    @ParameterizedTest
    @EnumSource
    void linesBetweenVaguePoints(Shape shape) {
        assertLines(shape, 58, KernelRangeTest::vague);
    }

    private static void assertLines(Shape shape, long seed, Numbers numbers) {
        SplittableRandom random = new SplittableRandom(seed);
        int crossed = 0;
        for (int i = 0; i < CASES; i++) {
            Case c = numbers.next(random, shape);
            Segment segment = new SegmentRecord(c.o, c.error, c.q, c.endError).toSegment();
            boolean exact = isCrossedExactly(c.surface, segment);
            assertEquals(exact, c.surface.isCrossed(segment, NUMBER), c::toString);
            crossed += exact ? 1 : 0;
        }
        assertTrue(crossed > LEAST_ANSWERS, crossed + " crossed");
    }

    private static boolean isCrossedExactly(Surface surface, Segment segment) {
        if (surface instanceof Plane plane) {
            ExactPlane exact = ExactPlane.of(plane);
            return exact.side(segment.start(), NUMBER) * exact.side(segment.end(), segment.endError) < 0;
        }
        if (surface instanceof Triangle triangle) {
            return ExactTriangle.of(triangle).isCrossed(segment, NUMBER);
        }
        return surface instanceof Sphere sphere ? ExactSphere.of(sphere).isCrossed(segment, NUMBER)
            : ExactBox.of((Box) surface).isCrossed(segment, NUMBER);
    }

    @ParameterizedTest
    @EnumSource(names = {"SPHERE", "BOX"})
    void endsOutsideInTheWholeRange(Shape shape) {
        assertEndsOutside(shape, 59, KernelRangeTest::anywhere);
    }

    @ParameterizedTest
    @EnumSource(names = {"SPHERE", "BOX"})
    void vagueEndsOutside(Shape shape) {
        assertEndsOutside(shape, 60, KernelRangeTest::vague);
    }

    private static void assertEndsOutside(Shape shape, long seed, Numbers numbers) {
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < CASES; i++) {
            Case c = numbers.next(random, shape);
            int side = c.surface instanceof Sphere sphere ? ExactSphere.of(sphere).side(c.q, c.endError)
                : ExactBox.of((Box) c.surface).side(c.q, c.endError);
            assertEquals(side > 0, ((Body) c.surface).isLeft(new SegmentRecord(c.o, c.error, c.q, c.endError).toSegment()),
                c::toString);
        }
    }

    /**
     * Rays whose crossings once were 113 and 36 units in the last place off, not a number, or wrong; or easily could
     * be.
     */
    @ParameterizedTest
    @CsvSource({
        "SPHERE, 3.8462741636451514, -2.998912650889705, 9.311483504764825, "
            + "0.6240475526805568, -1.121926301221666, -0.41614502080076055, "
            + "7.864280330220385, -3.6234831839807895, 9.98813483205819, 3.509548263163466",
        "PLANE, 4.542570771935049, 0.6891553067454701, -0.13531296777614443, "
            + "0.28949751255724876, 0.11330263665963836, -0.44223677095835556, "
            + "-0.9746464992903628, 0.0742354887990698, -0.2095105854492047, -4.709015614819295",
        "PLANE, -1, 0.999, 0, 1e250, 1e250, 0, 1e60, 1e60, 0, 0",
        "SPHERE, 1.7962615744215671E31, -1.354625218141938E32, 1.0144961202872982E32, "
            + "-1.7962615744215671E31, 1.354625218141938E32, -1.0144961202872982E32, "
            + "-0.143742082316189, 0.9237471519376259, -0.7209398003196479, 2.9077969390601143E-5",
        "SPHERE, 3e-90, 0, 1e-91, 1e179, 0, 0, 0, 0, 0, 1e-90",
        "SPHERE, 1e160, 0, 0, -1e-70, 0, 0, 0, 0, 0, 1e150",
    })
    void raysThatOnceWentWrong(Shape shape, double ox, double oy, double oz, double dx, double dy, double dz,
                               double x, double y, double z, double scalar) {
        Vector o = new Vector(ox, oy, oz);
        Case c = new Case(o, new Vector(dx, dy, dz), o, 0, 0, shape.surface(new Vector(x, y, z), scalar));
        Optional<Surd> exact = exact(c, Departure.ELSEWHERE);
        RayRecord ray = new RayRecord(c.o, 0, c.d, RayOrigin.NO_SURFACE, Departure.ELSEWHERE);
        double found = SurfaceQuestions.firstCrossing(c.surface, ray, Departure.ELSEWHERE);
        assertCrossing(shape, c, found, exact);
    }
}
