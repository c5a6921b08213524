package raytracing.area;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.SplittableRandom;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Shadows of all kinds on the square from (-1, -1) to (1, 1), if nothing else is said. */
class ConvexShadowsTest {
    private final ConvexShadows shadows = new ConvexShadows();

    /** A convex figure with straight sides, or all but that on the inner side of the gate. */
    private record Figure(double transmittance, List<LightOnLines.Line> gate, List<LightOnLines.Line> lines) {
        /** Like the outline of a box: up to six sides around a point, which may be outside the square. */
        static Figure random(SplittableRandom random) {
            double x = random.nextDouble(-1, 1);
            double y = random.nextDouble(-1, 1);
            double turn = random.nextDouble(2 * Math.PI);
            int sides = random.nextInt(1, 7);
            List<LightOnLines.Line> lines = new ArrayList<>();
            for (int i = 0; i < sides; i++) {
                double angle = turn + 2 * Math.PI * i / sides + random.nextDouble(-0.3, 0.3);
                lines.add(line(angle, random.nextDouble(0.1, 1) - Math.cos(angle) * x - Math.sin(angle) * y));
            }
            List<LightOnLines.Line> gate = random.nextInt(3) > 0 ? List.of()
                : List.of(line(random.nextDouble(2 * Math.PI), random.nextDouble(-1, 1)));
            return new Figure(random.nextBoolean() ? 0 : random.nextDouble(), gate, lines);
        }

        private static LightOnLines.Line line(double angle, double c) {
            return new LightOnLines.Line(Math.cos(angle), Math.sin(angle), c);
        }

        void addTo(ConvexShadows shadows, double size) {
            if (gate.isEmpty()) {
                shadows.beginFigure(transmittance, 1);
            } else {
                shadows.beginFigure(1, transmittance);
                shadows.addLine(gate.get(0).a(), gate.get(0).b(), size * gate.get(0).c());
                shadows.beginOutline();
            }
            lines.forEach(line -> shadows.addLine(line.a(), line.b(), size * line.c()));
        }

        LightOnLines.Obstacle obstacle() {
            return gate.isEmpty() ? new LightOnLines.Figure(transmittance, 1, lines)
                : new LightOnLines.Gated(gate.get(0), new LightOnLines.Figure(1, transmittance, lines));
        }

        /** By a right angle. */
        Figure turned() {
            return new Figure(transmittance, gate.stream().map(Figure::turned).toList(),
                lines.stream().map(Figure::turned).toList());
        }

        private static LightOnLines.Line turned(LightOnLines.Line line) {
            return new LightOnLines.Line(-line.b(), line.a(), line.c());
        }
    }

    private record Ball(double x, double y, double z, double r, double transmittance) {
        static Ball random(SplittableRandom random) {
            double r = Math.exp(random.nextDouble(-3, -1));
            return new Ball(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(r, 0.9 - r) + 0.1, r,
                random.nextBoolean() ? 0 : random.nextDouble());
        }

        Ball turned() {
            return new Ball(-y, x, z, r, transmittance);
        }

        void addTo(ConvexShadows shadows, double size) {
            shadows.balls().add(size * x, size * y, size * z, size * r, transmittance);
        }
    }

    private static <T> List<T> several(SplittableRandom random, int most, Function<SplittableRandom, T> one) {
        List<T> all = new ArrayList<>();
        for (int i = random.nextInt(most); i >= 0; i--) {
            all.add(one.apply(random));
        }
        return all;
    }

    private double share(List<Figure> figures, List<Ball> balls, double size) {
        shadows.clear(size, size);
        balls.forEach(ball -> ball.addTo(shadows, size));
        figures.forEach(figure -> figure.addTo(shadows, size));
        return shadows.share();
    }

    private static double shareByLines(List<Figure> figures, List<Ball> balls, int count) {
        LightOnLines lines = new LightOnLines(1, 1);
        List<LightOnLines.Obstacle> obstacles = new ArrayList<>();
        figures.forEach(figure -> obstacles.add(figure.obstacle()));
        balls.forEach(ball -> obstacles.add(lines.new Ball(ball.x, ball.y, ball.z, ball.r, ball.transmittance)));
        return lines.share(count, obstacles);
    }

    @Test
    void withoutShadowsAllLightComes() {
        assertEquals(1, share(List.of(), List.of(), 1));
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "half of it,       1, 0, 0,    0,   0.5",
        "a quarter,        1, 0, -0.5, 0,   0.75",
        "a corner,         1, 1, -1,   0,   0.875",
        "a corner of glass, 1, 1, -1,   0.5, 0.9375",
        "all of it,        0, 0, 1,    0,   0",
        "all of glass,     0, 0, 1,    0.3, 0.3",
        "nothing,          0, 0, -1,   0,   1",
        "to its border,    1, 0, -1,   0,   1",
    })
    void aHalfPlaneTakesItsPart(String why, double a, double b, double c, double passing, double expected) {
        shadows.clear(1, 1);
        shadows.beginFigure(passing, 1);
        shadows.addLine(a, b, c);
        assertEquals(expected, shadows.share(), 1e-16, why);
    }

    /** The figure is the rectangle 0..1 by -0.5..0.5, a quarter of the square. */
    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "everywhere,         0, 0, 1,   0,   0.25",
        "glass everywhere,   0, 0, 1,   0.5, 0.625",
        "nowhere,            0, 0, -1,  0,   1",
        "on its half,        1, 0, 0,   0,   0.75",
        "on the other half, -1, 0, 0,   0,   0.5",
        "across,             0, 1, 0,   0,   0.625",
        "glass across,       0, 1, 0,   0.5, 0.8125",
    })
    void allButAFigureTakesTheRestOnItsSideOfTheGate(String why, double a, double b, double c, double passing,
                                                     double expected) {
        shadows.clear(1, 1);
        shadows.beginFigure(1, passing);
        shadows.addLine(a, b, c);
        shadows.beginOutline();
        shadows.addLine(1, 0, 0);
        shadows.addLine(0, 1, 0.5);
        shadows.addLine(0, -1, 0.5);
        assertEquals(expected, shadows.share(), 1e-16, why);
    }

    /** Strips along x and along y do not know of each other. */
    @Test
    void sharesOfCrossedStripsMultiply() {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 2_000; i++) {
            double width = random.nextDouble(2);
            double height = random.nextDouble(2);
            double first = random.nextDouble();
            double second = random.nextDouble();
            shadows.clear(1, 1);
            shadows.beginFigure(first, 1);
            shadows.addLine(1, 0, width - 1);
            shadows.beginFigure(second, 1);
            shadows.addLine(0, -1, height - 1);
            assertEquals((1 - (1 - first) * width / 2) * (1 - (1 - second) * height / 2), shadows.share(), 1e-15);
        }
    }

    /** An edge that runs nearly along the lines is off by up to a line's distance. */
    @Test
    void figuresAndBallsLeaveTheLightThatFineLinesFind() {
        SplittableRandom random = new SplittableRandom(2);
        int partly = 0;
        for (int i = 0; i < 120; i++) {
            List<Figure> figures = several(random, 4, Figure::random);
            List<Ball> balls = i % 2 == 0 ? List.of() : several(random, 3, Ball::random);
            double share = share(figures, balls, 1);
            assertEquals(shareByLines(figures, balls, 100), share, 4e-3, () -> figures + " " + balls);
            partly += share > 0 && share < 1 ? 1 : 0;
        }
        assertTrue(partly > 70, partly + " squares partly in shadow");
    }

    @Test
    void theOrderOfFiguresDoesNotMatter() {
        SplittableRandom random = new SplittableRandom(3);
        Random shuffling = new Random(3);
        for (int i = 0; i < 1_000; i++) {
            List<Figure> figures = several(random, 4, Figure::random);
            List<Ball> balls = several(random, 3, Ball::random);
            double expected = share(figures, balls, 1);
            Collections.shuffle(figures, shuffling);
            Collections.shuffle(balls, shuffling);
            assertEquals(expected, share(figures, balls, 1), 1e-12);
        }
    }

    @Test
    void allSidesOfTheSquareAreAlike() {
        SplittableRandom random = new SplittableRandom(4);
        for (int i = 0; i < 1_000; i++) {
            List<Figure> figures = several(random, 4, Figure::random);
            List<Ball> balls = several(random, 3, Ball::random);
            List<Figure> turnedFigures = figures.stream().map(Figure::turned).toList();
            List<Ball> turnedBalls = balls.stream().map(Ball::turned).toList();
            assertEquals(share(figures, balls, 1), share(turnedFigures, turnedBalls, 1), 1e-12);
        }
    }

    @Test
    void aFigureTwiceLetsItsTransmittanceSquaredThrough() {
        SplittableRandom random = new SplittableRandom(5);
        for (int i = 0; i < 1_000; i++) {
            Figure once = Figure.random(random);
            double passing = once.transmittance;
            Figure darker = new Figure(passing * passing, once.gate, once.lines);
            assertEquals(share(List.of(darker), List.of(), 1), share(List.of(once, once), List.of(), 1), 1e-14);
        }
    }

    /** Two walls with a gap of nothing between them let no light through, and two that overlap count once. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-300, 1e-17, 1e-9, 0.25})
    void wallsThatMeetLeaveNoGap(double overlap) {
        SplittableRandom random = new SplittableRandom(6);
        for (int i = 0; i < 300; i++) {
            double angle = random.nextDouble(2 * Math.PI);
            double c = random.nextDouble(-0.5, 0.5);
            shadows.clear(1, 1);
            shadows.beginFigure(0, 1);
            shadows.addLine(Math.cos(angle), Math.sin(angle), c);
            shadows.beginFigure(0, 1);
            shadows.addLine(-Math.cos(angle), -Math.sin(angle), overlap - c);
            assertEquals(0, shadows.share(), 1e-15);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {-500, -149, -1, 1, 128, 500})
    void powersOfTwoInAllLengthsLeaveTheSameBits(int exponent) {
        SplittableRandom random = new SplittableRandom(7);
        double size = Math.scalb(1.0, exponent);
        for (int i = 0; i < 100; i++) {
            List<Figure> figures = several(random, 3, Figure::random);
            List<Ball> balls = several(random, 4, Ball::random);
            double expected = share(figures, balls, 1);
            assertEquals(expected, share(figures, balls, size));
        }
    }

    /** Whatever the lengths. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9})
    void sharesStayBetweenNothingAndAll(double ratio) {
        SplittableRandom random = new SplittableRandom(8);
        for (int i = 0; i < 300; i++) {
            double size = Math.scalb(1.0, random.nextInt(-450, 450));
            shadows.clear(size, ratio * size);
            double reach = Math.max(ratio, 1) * size;
            for (int k = 0; k < 4; k++) {
                double r = reach * Math.exp(random.nextDouble(-20, 0));
                double x = random.nextDouble(-1, 1) * ratio * size;
                double y = random.nextDouble(-1, 1) * ratio * size;
                double z = r + random.nextDouble() * size;
                shadows.balls().add(x, y, z, r, random.nextDouble());
                shadows.discs().addThroughPlane(x, y, size, r / 2, r / 2, random.nextDouble());
                shadows.beginFigure(random.nextDouble(), 1);
                shadows.addLine(random.nextDouble(-1, 1), random.nextDouble(-1, 1),
                    random.nextDouble(-1, 1) * ratio * size);
            }
            double share = shadows.share();
            assertTrue(share >= 0 && share <= 1, share + " of the light");
        }
    }

    /** A quarter of the square, but for the quarter of that. */
    @Test
    void aShadowAroundAFigureMayHaveSeveralBorders() {
        shadows.clear(1, 1);
        shadows.beginFigure(1, 0);
        shadows.addLine(1, 0, 0);
        shadows.addLine(0, 1, 0);
        shadows.beginOutline();
        shadows.addLine(-1, 0, 0.5);
        shadows.addLine(0, -1, 0.5);
        assertEquals(1 - 0.25 + 0.0625, shadows.share(), 1e-16);
    }

    @Test
    void aShadowAroundAFigureMayHaveNoBorder() {
        shadows.clear(1, 1);
        shadows.beginFigure(1, 0.5);
        shadows.beginOutline();
        shadows.addLine(1, 0, 0);
        assertEquals(0.75, shadows.share(), 1e-16);
    }
}
