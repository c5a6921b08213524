package raytracing.render;

/**
 * As many rays for each pixel as its error needs, up to {@link PixelMean#MOST_RAYS}: those of its own {@code ScrambledNet},
 * 4, 8, 16 and so on, until their mean is probably within the limit.
 *
 * <p>A pixel's true value is the mean over its square of what its rays show, each ray's light cut off at 1. Its error is the
 * largest difference from that in any channel, before the value is rounded to 8 bits.
 *
 * @param steps the limit in steps of 1/255, from {@link #LEAST} to {@link #MOST}
 */
public record ErrorLimit(double steps) implements PixelSampling {
    public static final double LEAST = 0.25;
    public static final double MOST = 64;
}
