package raytracing.area;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Balls that the plane of the square cuts, or that the apex is in; the square goes from (-1, -1) to (1, 1). */
class DiscShadowsTest {
    /**
     * A polygon takes a disc's place where shadows overlap. What that may cost, as a share of the square: a few
     * crossings came to 4e-5 at most in 100 000 cases, twins to 3.7e-4.
     */
    private static final double WHERE_OUTLINES_CROSS = 0x1p-14;
    private static final double WHERE_OUTLINES_COINCIDE = 0x1p-11;

    private final ConvexShadows shadows = new ConvexShadows();

    private record Ball(double x, double y, double z, double r, double transmittance) {
        double discRadius(double depth) {
            return Math.sqrt(Math.max((r - z + depth) * (r + z - depth), 0));
        }

        boolean hasApexInside() {
            return x * x + y * y + z * z < r * r;
        }

        /** All lengths are multiples of the size. */
        void addTo(ConvexShadows shadows, double depth, double size) {
            double discRadius = size * discRadius(depth);
            if (hasApexInside()) {
                shadows.discs().addAround(size * x, size * y, discRadius, transmittance, 0, 0, 1);
            } else if (z + r < depth) {
                shadows.balls().add(size * x, size * y, size * z, size * r, transmittance);
            } else {
                shadows.discs().addThroughPlane(size * x, size * y, size * z, size * r, discRadius, transmittance);
            }
        }

        /** Anywhere around the apex and the plane, but not with the apex just on it. */
        static Ball random(SplittableRandom random, double depth, double transmittance) {
            while (true) {
                double r = Math.exp(random.nextDouble(-3, 1.5));
                Ball ball = new Ball(random.nextDouble(-2, 2), random.nextDouble(-2, 2),
                    random.nextDouble(-r, depth + r), r, transmittance);
                boolean isSeen = !ball.hasApexInside() || ball.discRadius(depth) > 0;
                double gap = Math.sqrt(ball.x * ball.x + ball.y * ball.y + ball.z * ball.z) / r - 1;
                if (isSeen && Math.abs(gap) > 1e-4) {
                    return ball;
                }
            }
        }
    }

    private double share(double depth, List<Ball> balls) {
        return share(depth, balls, 1);
    }

    private double share(double depth, List<Ball> balls, double size) {
        shadows.clear(size * depth, size);
        balls.forEach(ball -> ball.addTo(shadows, depth, size));
        return shadows.share();
    }

    private static double shareByLines(double depth, List<Ball> balls, int count) {
        LightOnLines lines = new LightOnLines(depth, 1);
        List<LightOnLines.Obstacle> obstacles = new ArrayList<>();
        for (Ball ball : balls) {
            obstacles.add(lines.new Ball(ball.x, ball.y, ball.z, ball.r, ball.transmittance));
        }
        return lines.share(count, obstacles);
    }

    /** Lines are the coarser ones of the two: at 2000 of them, no difference is above 2e-4 in 100 000 such cases. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 6})
    void ballsAnywhereLeaveTheLightThatFineLinesFind(int most) {
        SplittableRandom random = new SplittableRandom(most);
        int partly = 0;
        for (int i = 0; i < 200; i++) {
            double depth = Math.exp(random.nextDouble(-2, 2));
            List<Ball> balls = new ArrayList<>();
            for (int k = random.nextInt(most); k >= 0; k--) {
                balls.add(Ball.random(random, depth, random.nextBoolean() ? 0 : random.nextDouble()));
            }
            double share = share(depth, balls);
            assertEquals(shareByLines(depth, balls, 100), share, 2e-3, balls::toString);
            partly += share > 0 && share < 1 ? 1 : 0;
        }
        assertTrue(partly > 50, partly + " squares partly in shadow");
    }

    /** Far from all other shadows, a disc is closed-form. */
    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "around the apex and all of the square, 0,   0, 4, 5,   4, 0,    1",
        "around the apex to a small disc,      0,   0, 0, 1.25, 1, 0,   0.44178646691106467",
        "around the apex of glass,             0,   0, 0, 1.25, 1, 0.5, 0.7208932334555323",
        "around the apex to half of the disc,  1,   0, 0, 1.25, 1, 0,   0.22089323345553233",
        "in the middle of the plane,           0,   0, 5, 0.5, 5, 0,    0.8016671304551899",
    })
    void discsSolvedByHand(String why, double x, double y, double z, double r, double depth, double passing,
                           double expected) {
        assertEquals(expected, share(depth, List.of(new Ball(x, y, z, r, passing))), 1e-9, why);
    }

    /** Light beyond the tangent plane never meets the ball that the apex lies on. */
    @Test
    void aBallThatTheApexLiesOnCountsOnItsSideOnly() {
        shadows.clear(1, 1);
        shadows.discs().addAround(0.6, 0, 0.6, 0, 0.6, 0, 0.5);
        LightOnLines lines = new LightOnLines(1, 1);
        LightOnLines.Line side = new LightOnLines.Line(0.6, 0, 0.5);
        LightOnLines.Obstacle around = lines.new Ball(0.6, 0, 0.5, Math.sqrt(0.61) * (1 + 1e-15), 0);
        double expected = lines.share(1_000, List.of(new LightOnLines.Gated(side, around)));
        assertEquals(expected, shadows.share(), 1e-4);
        assertTrue(expected > 0.2 && expected < 0.4, expected + " of the light");
    }

    /** Balls in one place, one of them passing first, the other second, are one ball that passes both. */
    @ParameterizedTest
    @CsvSource({"0.5, 0.25", "0, 0.3", "0.3, 0", "1, 0.4", "0, 0"})
    void transmittancesOfBallsInOnePlaceMultiply(double first, double second) {
        SplittableRandom random = new SplittableRandom(7);
        for (int i = 0; i < 200; i++) {
            Ball ball = Ball.random(random, 1, first);
            Ball other = new Ball(ball.x, ball.y, ball.z, ball.r, second);
            Ball both = new Ball(ball.x, ball.y, ball.z, ball.r, first * second);
            double found = share(1, List.of(ball, other));
            assertEquals(share(1, List.of(both)), found, WHERE_OUTLINES_COINCIDE, ball::toString);
        }
    }

    @Test
    void theOrderOfBallsHardlyMatters() {
        SplittableRandom random = new SplittableRandom(8);
        double most = 0;
        for (int i = 0; i < 1_000; i++) {
            double depth = Math.exp(random.nextDouble(-1, 1));
            Ball a = Ball.random(random, depth, random.nextBoolean() ? 0 : random.nextDouble());
            Ball b = Ball.random(random, depth, random.nextBoolean() ? 0 : random.nextDouble());
            Ball c = Ball.random(random, depth, random.nextBoolean() ? 0 : random.nextDouble());
            double expected = share(depth, List.of(a, b, c));
            most = Math.max(most, Math.abs(expected - share(depth, List.of(c, a, b))));
            most = Math.max(most, Math.abs(expected - share(depth, List.of(b, a, c))));
        }
        assertTrue(most < WHERE_OUTLINES_CROSS, most + " apart");
    }

    /** Its shadow is first a cone, then partly a disc, and at last a disc that shrinks. */
    @Test
    void aBallThatSinksThroughThePlaneTakesLessAndLessLight() {
        double last = 0;
        for (int i = 0; i <= 1_000; i++) {
            Ball ball = new Ball(0.3, 0.2, 0.5 + i / 1_000.0, 0.5, 0);
            double share = share(1, List.of(ball));
            assertTrue(share >= last - 1e-14 && (i == 0 || share <= last + 0.01), "step " + i);
            last = share;
        }
        assertEquals(1, last, 1e-12);
    }

    @Test
    void aBallWhoseConeHidesAllBehindItsTangentCircleIsABallLikeAnyOther() {
        shadows.clear(1, 1);
        shadows.balls().add(0, 0, 0.8, 0.25, 0);
        double cone = shadows.share();
        shadows.clear(1, 1);
        shadows.discs().addThroughPlane(0, 0, 0.8, 0.25, 0.15, 0);
        assertEquals(cone, shadows.share(), 1e-15);
    }

    /** Turned and mirrored. */
    @Test
    void allSidesOfTheSquareAreAlike() {
        SplittableRandom random = new SplittableRandom(9);
        for (int i = 0; i < 2_000; i++) {
            Ball ball = Ball.random(random, 1, random.nextDouble());
            double expected = share(1, List.of(ball));
            Ball turned = new Ball(-ball.y, ball.x, ball.z, ball.r, ball.transmittance);
            Ball mirrored = new Ball(-ball.x, ball.y, ball.z, ball.r, ball.transmittance);
            assertEquals(expected, share(1, List.of(turned)), 1e-12);
            assertEquals(expected, share(1, List.of(mirrored)), 1e-12);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {-500, -149, -1, 1, 128, 500})
    void powersOfTwoInAllLengthsLeaveTheSameBits(int exponent) {
        SplittableRandom random = new SplittableRandom(10);
        for (int i = 0; i < 100; i++) {
            List<Ball> balls = List.of(Ball.random(random, 0.7, 0), Ball.random(random, 0.7, 0.5),
                Ball.random(random, 0.7, 0.8));
            assertEquals(share(0.7, balls), share(0.7, balls, Math.scalb(1.0, exponent)), balls::toString);
        }
    }
}
