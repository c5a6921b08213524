package raytracing.render;

/**
 * The same number of rays of the eye for each pixel, or for each at an edge, in a regular grid.
 *
 * <p>Ray (i, j) goes through the cell of column i and row j of the pixel's N x N cells. Along x its place is
 * (N - 1 - j + 1/2) / N of the cell, along y (i + 1/2) / N: so each of N^2 columns and each of N^2 rows holds one place,
 * and an edge along an axis has N^2 + 1 greys. This is multi-jittered sampling (Chiu, Shirley, Wang, Multi-Jittered
 * Sampling, Graphics Gems IV, 1994) without jitter, and with the order of the rows reversed along x: then the places
 * are a square grid, turned by the angle whose tangent is 1 / N, and slanted edges are better too (DECISIONS).
 *
 * @param root N of the N x N rays of a pixel that gets them, at least 1; 1 is the exercise's ray through the centre
 * @param where which pixels get them
 */
public record PixelGrid(int root, Where where) implements PixelSampling {
    /** The exercise's one ray, through the centre of the pixel. */
    public static final PixelGrid ONE_RAY = new PixelGrid(1, Where.EDGES);

    /** Distance of ray (i, j) from the pixel's left edge, in pixels; i and j in [0, N). */
    public double placeX(int i, int j) {
        return (i + (root - 1 - j + 0.5) / root) / root;
    }

    /** Distance of ray (i, j) from the pixel's upper edge, in pixels; i and j in [0, N). */
    public double placeY(int i, int j) {
        return (j + (i + 0.5) / root) / root;
    }

    /** Which pixels get N x N rays; the others keep the one ray through their centre. */
    public enum Where {
        /** Those at edges: of a surface, a shadow, a colour. */
        EDGES,

        /** All: what sampling only the edges is measured against. */
        EVERYWHERE
    }
}
