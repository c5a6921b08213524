package raytracing.area;

import raytracing.math.Vector;

/**
 * The shadow that a ball casts from the apex (0, 0, 0) on the plane z = depth: the section of the cone around the ball.
 *
 * <p>With m the ball's centre and e a point of the plane, e is in the shadow if m . e &gt;= sqrt(k) |e|, where
 * k = |m|^2 - r^2. Squared, with |m x e|^2 = |m|^2 |e|^2 - (m . e)^2, this is Q(e) = r^2 |e|^2 - |m x e|^2 &gt;= 0 with
 * m . e &gt; 0. The coefficients of Q are computed from r and the coordinates of m across the axis: differences
 * of |m|^2 and k would lose all digits of a small ball far away.
 */
final class BallShadow extends Conic {
    /** Stands for k = 0 where the apex is on the ball, so that f is finite and can be compared for two such balls too. */
    private static final double LEAST_K = 0x1p-900;

    private double mx;
    private double my;
    private double mz;
    private double radius;
    private double rootK;
    private double transmittance;
    private double depth;

    /**
     * Sets the ball. Only its direction and the ratio of its lengths matter, so the lengths are scaled to about 1.
     *
     * @param x of its centre, relative to the apex
     * @param r its radius; the apex is outside the ball, or on it but for rounding
     * @param passing transmittance of the ball, in [0, 1]
     * @param planeDepth distance of the plane, above 0
     */
    void set(double x, double y, double z, double r, double passing, double planeDepth) {
        double scale = Math.scalb(1.0, -Math.getExponent(Vector.largestPart(x, y, z)));
        mx = scale * x;
        my = scale * y;
        mz = scale * z;
        radius = scale * r;
        transmittance = passing;
        depth = planeDepth;
        double distance = Math.sqrt(mx * mx + my * my + mz * mz);
        rootK = Math.sqrt(Math.max((distance - radius) * (distance + radius), LEAST_K));
        double openness = (radius - mz) * (radius + mz);
        setForm(openness - my * my, mx * my, openness - mx * mx, mx * mz * depth, my * mz * depth,
            (radius * radius - mx * mx - my * my) * (depth * depth));
        setLine(mx, my, mz * depth);
        if (openness < 0 && mz > 0) {
            double stretch = -depth * mz / openness;
            double roundness = depth * radius / -openness;
            setEllipse(mx * stretch, my * stretch, Math.PI * roundness * roundness * rootK * Math.sqrt(-openness));
        }
    }

    double transmittance() {
        return transmittance;
    }

    /** Whether no point is in both shadows: the angle between the cones' axes is at least the sum of their half-angles. */
    boolean isApartFrom(BallShadow other) {
        return mx * other.mx + my * other.my + mz * other.mz <= rootK * other.rootK - radius * other.radius;
    }

    /**
     * Cuts a polygon to where f of this ball, as defined in {@link BallShadows}, is at least that of another. Of two equal
     * balls, the first has the whole polygon. Returns the part's number: the polygon's own if it is all of it, -1 if nothing.
     */
    int cutToCell(ConvexPolygons polygons, int polygon, BallShadow other, boolean isFirst) {
        double a = other.rootK * mx - rootK * other.mx;
        double b = other.rootK * my - rootK * other.my;
        double c = (other.rootK * mz - rootK * other.mz) * depth;
        Side side = isFirst ? polygons.side(polygon, a, b, c) : polygons.side(polygon, -a, -b, -c);
        if (side == Side.CUT) {
            return polygons.cut(polygon, a, b, c);
        }
        return (side == Side.WITHIN) == isFirst ? polygon : -1;
    }
}
