package raytracing.geometry;

/**
 * Ray-sphere arithmetic on bare doubles, sphere at the origin. {@link Sphere} and the compiled scene both call it.
 */
public final class SphereKernel {
    private SphereKernel() {
    }

    /**
     * First crossing of the ray o + t d with the sphere of radius r around the origin.
     *
     * <p>Whether there is one is decided at the point of closest approach: the terms of b b - a c cancel when a
     * sphere is small and far (Haines, Guenther, Akenine-Moeller, Precision Improvements for Ray/Sphere
     * Intersection, Ray Tracing Gems, 2019, chapter 7). With q = b + sign(b) sqrt(a h2) the roots are c/q and q/a,
     * so none comes from a difference of nearly equal numbers (Press et al., Numerical Recipes, section 5.6).
     *
     * <p>Error at most 3 ulp for ordinary rays and for spheres that are small, far, or far from the world's origin
     * (measured: 858 rays with exact answers). Digits are lost where a ray grazes, up to 23 bits, and where the origin
     * lies close to the wall compared with the radius, as c cancels there.
     *
     * @param ox origin minus centre, x part; with {@code oy}, {@code oz} finite
     * @param oy y part
     * @param oz z part
     * @param dx direction, x part; with {@code dy}, {@code dz} of any length but 0
     * @param dy y part
     * @param dz z part
     * @param r radius, above 0
     * @return smallest crossing above 0, or {@link Surface#MISS}; never NaN; a touching ray hits
     */
    public static double firstCrossing(double ox, double oy, double oz, double dx, double dy, double dz, double r) {
        double a = dx * dx + dy * dy + dz * dz;
        double b = -(ox * dx + oy * dy + oz * dz);
        double foot = b / a;
        double lx = ox + foot * dx;
        double ly = oy + foot * dy;
        double lz = oz + foot * dz;
        double squaredHalfChord = r * r - (lx * lx + ly * ly + lz * lz);
        if (!(squaredHalfChord >= 0)) {      // this way round, NaN is a miss
            return Surface.MISS;
        }
        double root = Math.sqrt(a * squaredHalfChord);
        double c = ox * ox + oy * oy + oz * oz - r * r;
        if (b > 0) {
            double q = b + root;
            double near = c / q;
            return near > 0 ? near : q / a;
        }
        double far = c / (b - root);         // the near root is behind the origin; so is this one, seen from outside
        return far > 0 ? far : Surface.MISS;
    }

    /**
     * The crossing on the far side, for a ray that starts on the inner wall and goes inwards. As the origin lies on
     * the sphere, c is 0 and the equation loses a root: what remains is exact where the coordinates are not.
     *
     * @param ox origin minus centre, x part
     * @param oy y part
     * @param oz z part
     * @param dx direction, x part; not all three 0
     * @param dy y part
     * @param dz z part
     * @return twice the way to the closest approach, or {@link Surface#MISS} if that lies behind
     */
    public static double acrossFromInnerWall(double ox, double oy, double oz, double dx, double dy, double dz) {
        double a = dx * dx + dy * dy + dz * dz;
        double across = -2 * (ox * dx + oy * dy + oz * dz) / a;
        return across > 0 ? across : Surface.MISS;
    }
}
