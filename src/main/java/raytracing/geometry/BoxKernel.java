package raytracing.geometry;

/**
 * Ray-box arithmetic on bare doubles, cube centred at the origin, by slabs: the ray is inside the cube while it is
 * between all three pairs of faces (Kay, Kajiya, Ray Tracing Complex Scenes, SIGGRAPH 1986, section 4).
 * {@link Box} and the compiled scene both call it.
 *
 * <p>Divisions, not products with a rounded reciprocal, and ordered comparisons, not {@code Math.min}: both keep a
 * ray on an edge from slipping between two boxes that share it.
 */
public final class BoxKernel {
    private BoxKernel() {
    }

    /**
     * First crossing of the ray o + t d with the cube of half edge h around the origin.
     *
     * <p>Error at most 1 ulp (measured: 1092 rays with exact answers), but for an origin close to the deciding face
     * compared with the edge, as their difference cancels. Rays within a rounding of an edge may be decided either way.
     *
     * @param ox origin minus centre, x part
     * @param oy y part
     * @param oz z part
     * @param dx direction, x part; not all three 0
     * @param dy y part
     * @param dz z part
     * @param h half the edge, above 0
     * @return smallest crossing above 0, or {@link Surface#MISS}; never NaN; a touching ray hits
     */
    public static double firstCrossing(double ox, double oy, double oz, double dx, double dy, double dz, double h) {
        if (missesSlab(ox, dx, h) || missesSlab(oy, dy, h) || missesSlab(oz, dz, h)) {
            return Surface.MISS;
        }
        double enter = later(enter(ox, dx, h), later(enter(oy, dy, h), enter(oz, dz, h)));
        double exit = exit(ox, oy, oz, dx, dy, dz, h);
        if (!(enter <= exit)) {
            return Surface.MISS;
        }
        if (enter > 0) {
            return enter;
        }
        return exit > 0 ? exit : Surface.MISS;
    }

    /**
     * The crossing on the far side, for a ray that starts on the inner wall and goes inwards. Nothing asks whether
     * the rounded origin is inside: it is, by what is known of it.
     *
     * @param ox origin minus centre, x part
     * @param oy y part
     * @param oz z part
     * @param dx direction, x part; not all three 0
     * @param dy y part
     * @param dz z part
     * @param h half the edge, above 0
     * @return where the ray leaves the cube, or {@link Surface#MISS} if that is not ahead
     */
    public static double acrossFromInnerWall(double ox, double oy, double oz,
                                             double dx, double dy, double dz, double h) {
        double exit = exit(ox, oy, oz, dx, dy, dz, h);
        return exit > 0 ? exit : Surface.MISS;
    }

    /**
     * Whether a ray crosses a face's plane at exactly this distance, in the arithmetic of the crossings above.
     *
     * @param face coordinate of the face on its axis, relative to the centre
     * @param o origin minus centre on that axis
     * @param d direction on that axis
     * @param distance a result of the crossings above
     * @return true for the face that decided the result
     */
    static boolean crosses(double face, double o, double d, double distance) {
        return d != 0 && (face - o) / d == distance;
    }

    private static boolean missesSlab(double o, double d, double h) {
        return d == 0 && !(-h <= o && o <= h);
    }

    private static double enter(double o, double d, double h) {
        return d == 0 ? Double.NEGATIVE_INFINITY : ((d > 0 ? -h : h) - o) / d;
    }

    private static double exit(double o, double d, double h) {
        return d == 0 ? Double.POSITIVE_INFINITY : ((d > 0 ? h : -h) - o) / d;
    }

    private static double exit(double ox, double oy, double oz, double dx, double dy, double dz, double h) {
        return earlier(exit(ox, dx, h), earlier(exit(oy, dy, h), exit(oz, dz, h)));
    }

    private static double later(double s, double t) {
        return s > t ? s : t;
    }

    private static double earlier(double s, double t) {
        return s < t ? s : t;
    }
}
