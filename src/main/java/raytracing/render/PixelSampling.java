package raytracing.render;

/** How it is decided how many rays of the eye a pixel gets, and where they go through it. */
public sealed interface PixelSampling permits PixelGrid, ErrorLimit {
}
