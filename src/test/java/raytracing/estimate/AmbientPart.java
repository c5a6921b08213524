package raytracing.estimate;

import java.util.Arrays;
import java.util.stream.IntStream;
import raytracing.ambient.AmbientLight;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.render.Renderers;
import raytracing.scene.CameraRays;
import raytracing.scene.Scene;
import raytracing.surface.Ray;
import raytracing.surface.RayRecord;

/**
 * What ambient light adds to a picture, pixel by pixel, and nothing else: drawn by the program, or by brute force.
 *
 * @param light red, green and blue of each pixel, row by row
 */
public record AmbientPart(double[] light) {
    private static final int CHANNELS = 3;

    /** All else that the picture shows. */
    public static AmbientPart drawnWithout(Renderer renderer) {
        Film film = Renderers.film(Renderers.inAmbientLight(renderer, AmbientLight.NONE));
        double[] part = new double[CHANNELS * film.width() * film.height()];
        for (int i = 0; i < part.length; i += CHANNELS) {
            Color color = film.get(i / CHANNELS % film.width(), i / CHANNELS / film.width());
            part[i] = color.red();
            part[i + 1] = color.green();
            part[i + 2] = color.blue();
        }
        return new AmbientPart(part);
    }

    /** What 8-bit channels show of the picture that this and the rest make. */
    public AmbientPart shownOver(AmbientPart rest) {
        return new AmbientPart(IntStream.range(0, light.length).mapToDouble(i -> Math.min(1, light[i] + rest.light[i]))
            .toArray());
    }

    /** Drawn by the program in some ambient light. */
    public static AmbientPart drawn(Renderer renderer, AmbientLight light) {
        Film with = Renderers.film(Renderers.inAmbientLight(renderer, light));
        Film without = Renderers.film(Renderers.inAmbientLight(renderer, AmbientLight.NONE));
        double[] part = new double[CHANNELS * with.width() * with.height()];
        for (int i = 0; i < part.length; i += CHANNELS) {
            int pixel = i / CHANNELS;
            Color a = with.get(pixel % with.width(), pixel / with.width());
            Color b = without.get(pixel % with.width(), pixel / with.width());
            part[i] = a.red() - b.red();
            part[i + 1] = a.green() - b.green();
            part[i + 2] = a.blue() - b.blue();
        }
        return new AmbientPart(part);
    }

    /**
     * The truth, but for the noise of its rays.
     *
     * @param scene all of it
     * @param settings for the size of the picture and the seed
     * @param bounces how often light is scattered at most
     * @param root of the number of rays for each pixel
     */
    public static AmbientPart byBruteForce(Scene scene, RenderSettings settings, int bounces, int root) {
        int width = settings.width();
        CameraRays rays = new CameraRays(scene.camera(), width, settings.height());
        double[] part = new double[CHANNELS * width * settings.height()];
        IntStream.range(0, part.length / CHANNELS).parallel().forEach(pixel -> {
            Ray ray = new Ray();
            if (rays.start(pixel % width + 0.5, pixel / width + 0.5, ray)) {
                BruteForceLight light = new BruteForceLight(scene, bounces, 1_000_003L * settings.seed() + pixel);
                System.arraycopy(light.ambientSeen(RayRecord.of(ray), root), 0, part, CHANNELS * pixel, CHANNELS);
            }
        });
        return new AmbientPart(part);
    }

    /** The mean of each channel over all pixels that show any ambient light. */
    public double[] mean() {
        double[] sum = new double[CHANNELS];
        int count = 0;
        for (int i = 0; i < light.length; i += CHANNELS) {
            if (light[i] + light[i + 1] + light[i + 2] > 0) {
                count++;
                for (int channel = 0; channel < CHANNELS; channel++) {
                    sum[channel] += light[i + channel];
                }
            }
        }
        int pixels = count;
        return Arrays.stream(sum).map(channel -> channel / pixels).toArray();
    }

    /**
     * Root of the mean square of the differences from the truth, which two independent pictures of it give without its
     * own noise: the product of the differences from both has the square as its mean.
     */
    public double errorAgainst(AmbientPart truth, AmbientPart sameTruth) {
        double sum = 0;
        for (int i = 0; i < light.length; i++) {
            sum += (light[i] - truth.light[i]) * (light[i] - sameTruth.light[i]);
        }
        return Math.sqrt(Math.max(0, sum) / light.length);
    }
}
