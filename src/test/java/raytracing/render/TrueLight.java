package raytracing.render;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import raytracing.color.Color;
import raytracing.color.MutableColor;
import raytracing.film.Film;
import raytracing.math.CounterRandom;
import raytracing.math.ScrambledNet;
import raytracing.shade.Shader;

/**
 * What pixels truly show, as nearly as many rays can tell: means over the pixel's square of what each ray shows, cut off at
 * 1. The rays go through a {@link ScrambledNet} of another seed than that of any picture. Immutable.
 */
public final class TrueLight {
    /** Which pixels are looked at. */
    public interface Choice {
        /** All of them. */
        Choice ALL = (x, y) -> true;

        boolean contains(int x, int y);
    }

    static final double STEPS = 255;
    private static final long SEED = RenderSettings.DEFAULT_SEED + 1776;
    private static final int CHANNELS = 3;
    private static final int QUARTERS = 4;

    /** Rays that differ by no more than this in every channel are called equal: half a step. */
    private static final double EQUAL = 0.5 / STEPS;

    /**
     * Variance of the mean of all rays over that of the means of their quarters. Each quarter is a net too. At an edge the
     * variance of a net of n points falls as n^-1.5, so that a quarter has 8 times that of the whole.
     */
    private static final double OF_QUARTERS = 0.125;

    private final int width;
    private final int height;
    private final int points;
    private final double[] means;
    private final double[] variances;
    private final boolean[] areVaried;

    private TrueLight(int width, int height, int points) {
        this.width = width;
        this.height = height;
        this.points = points;
        means = new double[CHANNELS * width * height];
        variances = new double[CHANNELS * width * height];
        areVaried = new boolean[width * height];
    }

    /** Of the chosen pixels of a whole picture, on all processors; the number of points is a power of two, at least 4. */
    public static TrueLight of(Renderer renderer, int points, Choice choice) {
        TrueLight truth = new TrueLight(renderer.settings().width(), renderer.settings().height(), points);
        AtomicInteger nextRow = new AtomicInteger();
        IntStream.range(0, Runtime.getRuntime().availableProcessors()).parallel().forEach(worker -> {
            Rays rays = truth.new Rays(renderer);
            for (int y = nextRow.getAndIncrement(); y < truth.height; y = nextRow.getAndIncrement()) {
                for (int x = 0; x < truth.width; x++) {
                    if (choice.contains(x, y)) {
                        rays.follow(x, y);
                    }
                }
            }
        });
        return truth;
    }

    public int width() {
        return width;
    }

    public int height() {
        return height;
    }

    /** Whether this pixel was chosen and its rays are not all equal to half a step: only there can a mean be wrong. */
    public boolean isVaried(int x, int y) {
        return areVaried[y * width + x];
    }

    /**
     * The square of the error of a pixel's light in the worst channel, in squared steps. The variance of the truth itself is
     * subtracted, so it may be below 0.
     */
    public double squaredError(int x, int y, Color light) {
        int i = CHANNELS * (y * width + x);
        return Math.max(squaredError(i, light.red()),
            Math.max(squaredError(i + 1, light.green()), squaredError(i + 2, light.blue())));
    }

    private double squaredError(int i, double light) {
        double difference = Film.shown(light) - means[i];
        return STEPS * STEPS * (difference * difference - variances[i]);
    }

    /** Follows the rays of one pixel after the other. */
    private final class Rays {
        private final Renderer renderer;
        private final Shader shader;
        private final ScrambledNet net = new ScrambledNet();
        private final double[] sums = new double[QUARTERS * CHANNELS];
        private final double[] least = new double[CHANNELS];
        private final double[] most = new double[CHANNELS];

        Rays(Renderer renderer) {
            this.renderer = renderer;
            shader = new Shader(renderer.scene(), renderer.surfaces(), renderer.settings().shadowMethod(),
                renderer.ambientLight());
        }

        void follow(int x, int y) {
            Arrays.fill(sums, 0);
            Arrays.fill(least, Double.POSITIVE_INFINITY);
            Arrays.fill(most, Double.NEGATIVE_INFINITY);
            long key = CounterRandom.bits(CounterRandom.bits(SEED, x), y);
            net.begin(key);
            for (int i = 0; i < points; i++) {
                net.moveTo(i);
                MutableColor light =
                    shader.light(renderer.cameraRays(), x + net.x(), y + net.y(), CounterRandom.bits(key, i));
                int quarter = QUARTERS * i / points;
                add(quarter, 0, Film.shown(light.red()));
                add(quarter, 1, Film.shown(light.green()));
                add(quarter, 2, Film.shown(light.blue()));
            }
            for (int channel = 0; channel < CHANNELS; channel++) {
                finish(y * width + x, channel);
            }
        }

        private void add(int quarter, int channel, double light) {
            sums[CHANNELS * quarter + channel] += light;
            least[channel] = Math.min(least[channel], light);
            most[channel] = Math.max(most[channel], light);
        }

        private void finish(int pixel, int channel) {
            double mean = 0;
            for (int quarter = 0; quarter < QUARTERS; quarter++) {
                mean += sums[CHANNELS * quarter + channel] / points;
            }
            double spread = 0;
            for (int quarter = 0; quarter < QUARTERS; quarter++) {
                double difference = QUARTERS * sums[CHANNELS * quarter + channel] / points - mean;
                spread += difference * difference;
            }
            means[CHANNELS * pixel + channel] = mean;
            variances[CHANNELS * pixel + channel] = OF_QUARTERS * spread / (QUARTERS - 1);
            areVaried[pixel] |= most[channel] - least[channel] > EQUAL;
        }
    }
}
