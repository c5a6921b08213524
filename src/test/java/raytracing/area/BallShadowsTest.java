package raytracing.area;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The light that balls take from the square from (-1, -1) to (1, 1), at distance 1 if nothing else is said. */
class BallShadowsTest {
    private final ConvexPolygons polygons = new ConvexPolygons();
    private final int square = polygons.addSquare(1);
    private final BallShadows shadows = new BallShadows(polygons);

    private enum Matter { OPAQUE, GLASS }

    private record Ball(double x, double y, double z, double r, double transmittance) {
        /** One that does not reach the plane and does not contain the apex; part of it may be behind the apex. */
        static Ball random(SplittableRandom random, double depth, double transmittance) {
            while (true) {
                double r = depth / 2 * Math.exp(random.nextDouble(-4, 0));
                Ball ball = new Ball(random.nextDouble(-1, 1), random.nextDouble(-1, 1),
                    random.nextDouble(-r, depth - r), r, transmittance);
                if (ball.squaredDistance() > 1.0001 * r * r) {
                    return ball;
                }
            }
        }

        Ball at(double newX, double newY) {
            return new Ball(newX, newY, z, r, transmittance);
        }

        double squaredDistance() {
            return x * x + y * y + z * z;
        }
    }

    private double taken(double depth, List<Ball> balls) {
        shadows.clear(depth);
        for (Ball ball : balls) {
            shadows.add(ball.x, ball.y, ball.z, ball.r, ball.transmittance);
        }
        double taken = shadows.takenLight(square);
        assertEquals(1, polygons.count(), "the stack is left as it was");
        return taken;
    }

    private double taken(Ball... balls) {
        return taken(1, List.of(balls));
    }

    private static List<Ball> randomBalls(SplittableRandom random, int count, double depth, Matter matter) {
        List<Ball> balls = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            balls.add(Ball.random(random, depth, matter == Matter.OPAQUE ? 0 : random.nextDouble()));
        }
        return balls;
    }

    private void assertLinesAgree(Matter matter) {
        SplittableRandom random = new SplittableRandom(1);
        int partly = 0;
        for (int i = 0; i < 400; i++) {
            double depth = Math.exp(random.nextDouble(-2, 2));
            List<Ball> balls = randomBalls(random, random.nextInt(2, 7), depth, matter);
            LightOnLines lines = new LightOnLines(depth, 1);
            List<LightOnLines.Obstacle> obstacles = new ArrayList<>();
            for (Ball ball : balls) {
                obstacles.add(lines.new Ball(ball.x, ball.y, ball.z, ball.r, ball.transmittance));
            }
            double taken = taken(depth, balls) / 4;
            // the end of a shadow between two of n lines: errors go like n^-1.5, and n^-2 elsewhere
            assertEquals(1 - lines.share(100, obstacles), taken, 2e-3, balls::toString);
            partly += taken > 0 && taken < 1 ? 1 : 0;
        }
        assertTrue(partly > 200, partly + " squares partly in shadow");
    }

    @Test
    void opaqueBallsTakeWhatFineLinesFind() {
        assertLinesAgree(Matter.OPAQUE);
    }

    @Test
    void transparentBallsTakeWhatFineLinesFind() {
        assertLinesAgree(Matter.GLASS);
    }

    @Test
    void theOrderOfBallsDoesNotMatter() {
        SplittableRandom random = new SplittableRandom(2);
        Random shuffling = new Random(2);
        for (int i = 0; i < 2_000; i++) {
            List<Ball> balls = randomBalls(random, random.nextInt(2, 7), 1, Matter.values()[i % 2]);
            double expected = taken(1, balls);
            Collections.shuffle(balls, shuffling);
            assertEquals(expected, taken(1, balls), 2e-12, balls::toString);
        }
    }

    /** Turned by right angles, mirrored, and with the axes exchanged. */
    @Test
    void allSidesOfTheSquareAreAlike() {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 2_000; i++) {
            List<Ball> balls = randomBalls(random, random.nextInt(1, 5), 1, Matter.values()[i % 2]);
            double expected = taken(1, balls);
            assertEquals(expected, taken(1, balls.stream().map(ball -> ball.at(-ball.y, ball.x)).toList()), 2e-12);
            assertEquals(expected, taken(1, balls.stream().map(ball -> ball.at(-ball.x, ball.y)).toList()), 2e-12);
            assertEquals(expected, taken(1, balls.stream().map(ball -> ball.at(ball.y, ball.x)).toList()), 2e-12);
        }
    }

    @Test
    void areasInBothPartsOfACutAddUp() {
        SplittableRandom random = new SplittableRandom(4);
        for (int i = 0; i < 2_000; i++) {
            List<Ball> balls = randomBalls(random, random.nextInt(1, 6), 1, Matter.values()[i % 2]);
            double whole = taken(1, balls);
            double angle = random.nextDouble(2 * Math.PI);
            double a = Math.cos(angle);
            double b = Math.sin(angle);
            double c = random.nextDouble(-1, 1);
            double parts = shadows.takenLight(polygons.cut(square, a, b, c))
                + shadows.takenLight(polygons.cut(square, -a, -b, -c));
            assertEquals(whole, parts, 2e-12);
            polygons.dropTo(square + 1);
        }
    }

    @Test
    void anotherBallNeverGivesLight() {
        SplittableRandom random = new SplittableRandom(5);
        for (int i = 0; i < 500; i++) {
            List<Ball> balls = randomBalls(random, 6, 1, Matter.values()[i % 2]);
            double last = 0;
            for (int count = 1; count <= balls.size(); count++) {
                double taken = taken(1, balls.subList(0, count));
                assertTrue(taken >= last - 2e-12 && taken <= 4 + 2e-12);
                last = taken;
            }
        }
    }

    @Test
    void anOpaqueBallTwiceIsTheBallOnce() {
        Ball ball = new Ball(0.3, -0.2, 0.5, 0.2, 0);
        double once = taken(ball);
        assertTrue(once > 0.5);
        assertEquals(once, taken(ball, ball), 1e-15);
        assertEquals(once, taken(ball, ball, ball, ball), 1e-15);
    }

    /** From the apex they are the same; the way to the centre and the radius have another unit. */
    @Test
    void ballsBehindEachOtherThatLookAlikeAreOneBall() {
        Ball ball = new Ball(0.3, -0.2, 0.5, 0.2, 0);
        assertEquals(taken(ball), taken(ball, new Ball(0.3 * 1.5, -0.2 * 1.5, 0.5 * 1.5, 0.2 * 1.5, 0)), 1e-14);
    }

    @ParameterizedTest
    @CsvSource({"0.5, 0.25", "0.1, 0.7", "0, 0.3", "0.3, 0", "1, 0.4", "1, 1"})
    void transmittancesOfBallsInOnePlaceMultiply(double first, double second) {
        SplittableRandom random = new SplittableRandom(6);
        for (int i = 0; i < 300; i++) {
            Ball ball = Ball.random(random, 1, first);
            Ball other = new Ball(ball.x, ball.y, ball.z, ball.r, second);
            Ball both = new Ball(ball.x, ball.y, ball.z, ball.r, first * second);
            Ball elsewhere = Ball.random(random, 1, random.nextDouble());
            assertEquals(taken(both), taken(ball, other), 1e-14);
            assertEquals(taken(both, elsewhere), taken(ball, elsewhere, other), 2e-12);
        }
    }

    @Test
    void aBallWithinTheShadowOfAnOpaqueOneTakesNothing() {
        Ball large = new Ball(0.2, 0.1, 0.5, 0.4, 0);
        Ball small = new Ball(0.25, 0.1, 0.6, 0.05, 0);
        assertEquals(taken(large), taken(large, small), 1e-14);
        assertEquals(taken(large), taken(small, large), 1e-14);
    }

    /** A half of what the large one leaves. */
    @Test
    void aBallWithinTheShadowOfGlassTakesItsShareOfTheRest() {
        Ball large = new Ball(0.2, 0.1, 0.5, 0.4, 0.75);
        Ball small = new Ball(0.25, 0.1, 0.6, 0.05, 0.5);
        assertEquals(taken(large) + 0.75 * taken(small), taken(large, small), 1e-14);
        assertEquals(taken(large) + 0.75 * taken(small), taken(small, large), 1e-14);
    }

    @Test
    void whatIsApartAddsUp() {
        Ball left = new Ball(-0.5, 0, 0.9, 0.3, 0);
        Ball right = new Ball(0.5, 0.1, 0.9, 0.3, 0.2);
        Ball above = new Ball(0, -0.5, 0.6, 0.1, 0.7);
        assertEquals(taken(left) + taken(right) + taken(above), taken(left, right, above), 1e-14);
    }

    @Test
    void anOpaqueBallOverTheWholeSquareTakesAllOfIt() {
        Ball large = new Ball(0, 0, 0.5, 0.48, 0);
        assertEquals(4, taken(new Ball(0.2, 0, 0.3, 0.1, 0.5), large, new Ball(0, 0.1, 0.2, 0.1, 0)));
    }

    @Test
    void withoutBallsNothingIsTaken() {
        assertEquals(0, taken());
    }

    @Test
    void aBallThatLetsEverythingThroughTakesNothing() {
        assertEquals(0, taken(new Ball(0.1, 0, 0.5, 0.3, 1), new Ball(0, 0.1, 0.5, 0.3, 1)));
    }

    /** Half-planes, from balls that the apex lies on: x &gt;= 0 and y &gt;= 0 leave a quarter of the square. */
    @Test
    void ballsThatTheApexLiesOnOverlapToo() {
        Ball right = new Ball(1, 0, 0, 1, 0);
        Ball above = new Ball(0, 1, 0, 1, 0);
        assertEquals(3, taken(right, above), 1e-7);
        assertEquals(4, taken(right, above, new Ball(-1, -1, 0, Math.sqrt(2), 0)), 1e-7);
        assertEquals(0.5 + 0.75 + 0.875, taken(new Ball(1, 0, 0, 1, 0.5), new Ball(0, 1, 0, 1, 0.25)), 1e-7);
    }

    /** The cells between beads are thin. */
    @ParameterizedTest
    @ValueSource(ints = {2, 5, 20, 60})
    void beadsOnAStringTakeWhatFineLinesFind(int count) {
        List<Ball> beads = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double x = i / (count - 1.0) - 0.5;
            beads.add(new Ball(x, x / 2, 0.5, 0.1, 0));
        }
        LightOnLines lines = new LightOnLines(1, 1);
        List<LightOnLines.Obstacle> obstacles = new ArrayList<>();
        beads.forEach(bead -> obstacles.add(lines.new Ball(bead.x, bead.y, bead.z, bead.r, 0)));
        assertEquals(4 - 4 * lines.share(1_000, obstacles), taken(1, beads), 1e-4);
    }

    @Test
    void aBallForAWhileIsForgotten() {
        Ball stays = new Ball(0.3, -0.2, 0.5, 0.2, 0);
        double once = taken(stays);
        BallShadow guest = new BallShadow();
        guest.set(-0.3, 0.2, 0.5, 0.1, 0, 1);
        assertTrue(shadows.areApartFrom(guest));
        shadows.push(guest);
        assertTrue(shadows.takenLight(square) > once + 0.1);
        shadows.pop();
        assertEquals(once, shadows.takenLight(square));
        shadows.push(guest);
        shadows.add(0, 0.5, 0.5, 0.1, 0);
        shadows.pop();
        shadows.pop();
        assertEquals(once, shadows.takenLight(square));
    }
}
