package raytracing.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.DoubleBinaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.math.ScrambledNet;

/** Made-up pixels whose means are known: the unit square, with light from 0 to 1 as a function of the place. */
class PixelMeanTest {
    private static final int KEYS = 24;

    private final ScrambledNet net = new ScrambledNet();
    private final PixelMean mean = new PixelMean();
    private double trueSquares;
    private double probableSquares;
    private int count;
    private int beyondTwice;

    /** Adds the true and the probable error of a pixel with so many rays. */
    private void add(DoubleBinaryOperator light, double truth, int rays, long key) {
        net.begin(key);
        mean.clear();
        mean.plan(rays);
        for (int i = 0; i < rays; i++) {
            net.moveTo(i);
            double value = light.applyAsDouble(net.x(), net.y());
            mean.add(value, value / 2, 0);
        }
        double error = PixelMean.STEPS * Math.abs(mean.red() - truth);
        trueSquares += error * error;
        probableSquares += mean.error() * mean.error();
        count++;
        double missed = PixelMean.STEPS / (3 * rays);        // an area so small may lie between all rays
        beyondTwice += error > 2 * mean.error() + missed ? 1 : 0;
    }

    private double ratio() {
        return Math.sqrt(probableSquares / trueSquares);
    }

    /** Share of the unit square where the height a x + b y - c is above 0: the sum over its corners, each with its sign. */
    private static double shareAbove(double a, double b, double c) {
        return (half(a + b - c) - half(a - c) - half(b - c) + half(-c)) / (a * b);
    }

    private static double half(double height) {
        return height > 0 ? height * height / 2 : 0;
    }

    /**
     * Every angle but those along the axes, every offset. Measured: ratios of 1.1 to 1.4, and up to 5.1 % beyond twice the
     * error.
     */
    @ParameterizedTest(name = "{0} rays")
    @ValueSource(ints = {16, 64, 256, 1024})
    void atAHalfPlaneTheProbableErrorIsTheTrueOne(int rays) {
        for (int angle = 0; angle < 24; angle++) {
            double a = Math.cos(0.1 + angle * Math.PI / 12);
            double b = Math.sin(0.1 + angle * Math.PI / 12);
            for (int offset = 1; offset < 12; offset++) {
                double c = Math.min(0, a) + Math.min(0, b) + offset / 12.0 * (Math.abs(a) + Math.abs(b));
                for (int key = 0; key < KEYS / 4; key++) {
                    add((x, y) -> a * x + b * y > c ? 1 : 0, shareAbove(a, b, c), rays, key + 100L * offset);
                }
            }
        }
        assertTrue(ratio() > 0.7 && ratio() < 2, "probable over true error " + ratio());
        assertTrue(beyondTwice < 0.06 * count, beyondTwice + " of " + count + " beyond twice the probable error");
    }

    /** A dark line of a tenth of a pixel in the middle, of any angle up to 45 degrees, as long as the pixel is high. */
    @ParameterizedTest(name = "{0} rays")
    @ValueSource(ints = {64, 256, 1024})
    void atAThinLineToo(int rays) {
        for (int lean = 0; lean < 20; lean++) {
            double slope = lean / 50.0;
            for (int key = 0; key < KEYS; key++) {
                add((x, y) -> Math.abs(x - 0.5 - slope * (y - 0.5)) < 0.05 ? 0 : 1, 0.9, rays, key);
            }
        }
        assertTrue(ratio() > 0.5 && ratio() < 2, "probable over true error " + ratio());
    }

    /** A disc of a hundredth of the pixel's area, anywhere in it, among so many rays that one of them surely hits it. */
    @ParameterizedTest(name = "{0} rays")
    @ValueSource(ints = {1024, 4096})
    void atADotOfAHundredthToo(int rays) {
        double radius = Math.sqrt(0.01 / Math.PI);
        for (int key = 0; key < 10 * KEYS; key++) {
            double cx = radius + (1 - 2 * radius) * (key % 15 + 0.5) / 15;
            double cy = radius + (1 - 2 * radius) * (key / 15 + 0.5) / 16;
            add((x, y) -> Math.hypot(x - cx, y - cy) < radius ? 1 : 0, 0.01, rays, key);
        }
        assertTrue(ratio() > 0.5 && ratio() < 2, "probable over true error " + ratio());
    }

    /** A smooth peak, as of a highlight: exp of minus the square of the distance from a corner, in fifths of the pixel. */
    @ParameterizedTest(name = "{0} rays")
    @ValueSource(ints = {4, 16, 64})
    void atAHighlightTheProbableErrorIsNotBelowTheTrueOne(int rays) {
        double side = 0.5 * Math.sqrt(Math.PI) / 5;      // of the whole peak; beyond the pixel lies less than 1e-11 of it
        for (int key = 0; key < 10 * KEYS; key++) {
            add((x, y) -> Math.exp(-25 * (x * x + y * y)), side * side, rays, key);
        }
        assertTrue(ratio() > 0.8, "probable over true error " + ratio());
    }

    /** Noise, as of sampled shadows: each ray is 0 or 1 by itself, so no net helps. */
    @ParameterizedTest(name = "{0} rays")
    @ValueSource(ints = {16, 256})
    void ofNoiseTheProbableErrorIsAtLeastHalfTheTrueOne(int rays) {
        for (int key = 0; key < 40 * KEYS; key++) {
            add((x, y) -> Double.hashCode(x * 1e9 + y) * 0x9e3779b9 < 0 ? 1 : 0, 0.5, rays, key);
        }
        assertTrue(ratio() > 0.6 && ratio() < 1.5, "probable over true error " + ratio());
    }

    @Test
    void equalRaysHaveNoError() {
        add((x, y) -> 0.7, 0.7, 16, 1);
        assertEquals(0, mean.error(), 1e-6);
        assertEquals(0, mean.deviation(), 1e-5);
        assertEquals(0.7, mean.red(), 1e-15);
        assertEquals(0.35, mean.green(), 1e-15);
        assertEquals(0, mean.blue());
    }

    /** Doubling again and again leaves the same as planning for all rays at once. */
    @Test
    void theErrorDoesNotDependOnHowTheRaysWerePlanned() {
        DoubleBinaryOperator light = (x, y) -> x * x < y ? 1 : x;
        add(light, 0, 256, 5);
        double atOnce = mean.error();
        net.begin(5);
        mean.clear();
        for (int planned = PixelMean.FEWEST_RAYS; planned <= 256; planned *= 2) {
            mean.plan(planned);
            for (int i = mean.rays(); i < planned; i++) {
                net.moveTo(i);
                double value = light.applyAsDouble(net.x(), net.y());
                mean.add(value, value / 2, 0);
            }
        }
        assertEquals(atOnce, mean.error(), 1e-9);
    }
}
