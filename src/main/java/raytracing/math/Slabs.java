package raytracing.math;

/**
 * When a line is inside a cube along the axes: while it is between all three pairs of faces (Kay, Kajiya, Ray Tracing Complex
 * Scenes, SIGGRAPH 1986, section 4). Times count in multiples of the line's direction d.
 */
public final class Slabs {
    private Slabs() {
    }

    /** The way from a point o to a middle c on one axis, counted along the line. */
    public static double ahead(double o, double d, double c) {
        return Math.copySign(1, d) * (c - o);
    }

    /**
     * When the line passes the last of the near faces.
     *
     * @param mx way to the cube's middle along the x axis, as {@link #ahead} gives it
     * @param half half the cube's edge
     * @param ix one over the size of the direction's x part; infinite for 0
     * @return NaN if a way is 0 on an axis along which the line does not go
     */
    public static double entry(double mx, double my, double mz, double half, double ix, double iy, double iz) {
        return Math.max((mx - half) * ix, Math.max((my - half) * iy, (mz - half) * iz));
    }

    /** When the line passes the first of the far faces; arguments are those of {@link #entry}. */
    public static double exit(double mx, double my, double mz, double half, double ix, double iy, double iz) {
        return Math.min((mx + half) * ix, Math.min((my + half) * iy, (mz + half) * iz));
    }
}
