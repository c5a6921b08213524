package raytracing.area;

/**
 * The shadow that a ball casts from the apex (0, 0, 0) on the plane z = depth: the section of the cone around the ball.
 * One thread, ball after ball.
 *
 * <p>With m the ball's centre and e a point of the plane, e is in the shadow if m . e &gt;= sqrt(k) |e|, where
 * k = |m|^2 - r^2. Squared, with |m x e|^2 = |m|^2 |e|^2 - (m . e)^2, this is Q(e) = r^2 |e|^2 - |m x e|^2 &gt;= 0 with
 * m . e &gt; 0. The coefficients of Q are worked out from r and the parts of m across the axis: from differences of
 * |m|^2 and k, a small ball far away would keep no digits.
 */
final class BallShadow {
    /** For k where the apex is on the ball, so that of two such balls, too, either f can be the greater. */
    private static final double LEAST_K = 0x1p-900;

    private final Conic conic = new Conic();
    private double mx;
    private double my;
    private double mz;
    private double radius;
    private double rootK;
    private double transmittance;
    private double depth;

    /**
     * The ball. Only its direction and the ratio of its lengths matter, so they are made about as long as 1.
     *
     * @param x its centre, seen from the apex
     * @param y y part
     * @param z z part
     * @param r its radius; the apex is outside or as good as on the ball
     * @param passing share of light that the ball lets through, in [0, 1]
     * @param planeDepth distance of the plane, above 0
     */
    void set(double x, double y, double z, double r, double passing, double planeDepth) {
        double scale = Math.scalb(1.0, -Math.getExponent(Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)))));
        mx = scale * x;
        my = scale * y;
        mz = scale * z;
        radius = scale * r;
        transmittance = passing;
        depth = planeDepth;
        double distance = Math.sqrt(mx * mx + my * my + mz * mz);
        rootK = Math.sqrt(Math.max((distance - radius) * (distance + radius), LEAST_K));
        double openness = (radius - mz) * (radius + mz);
        conic.setForm(openness - my * my, mx * my, openness - mx * mx, mx * mz * depth, my * mz * depth,
            (radius * radius - mx * mx - my * my) * (depth * depth));
        conic.setLine(mx, my, mz * depth);
        if (openness < 0 && mz > 0) {
            double stretch = -depth * mz / openness;
            double roundness = depth * radius / -openness;
            conic.setEllipse(mx * stretch, my * stretch,
                Math.PI * roundness * roundness * rootK * Math.sqrt(-openness));
        }
    }

    /** Share of light that the ball lets through, in [0, 1]. */
    double transmittance() {
        return transmittance;
    }

    /** How a polygon lies to the shadow. */
    Side side(ConvexPolygons polygons, int polygon) {
        return conic.side(polygons, polygon);
    }

    /** How much of a polygon is in the shadow. */
    double area(ConvexPolygons polygons, int polygon) {
        return conic.area(polygons, polygon);
    }

    /** Whether no point is in both shadows: cones around axes at an angle of at least the sum of their half-angles. */
    boolean isApartFrom(BallShadow other) {
        return mx * other.mx + my * other.my + mz * other.mz <= rootK * other.rootK - radius * other.radius;
    }

    /** How a polygon lies to where f of this ball is at least that of another; f is that of {@link BallShadows}. */
    Side sideOfCell(ConvexPolygons polygons, int polygon, BallShadow other) {
        return polygons.side(polygon, cellA(other), cellB(other), cellC(other));
    }

    /** The part of a polygon where f of this ball is at least that of another. */
    int cutToCell(ConvexPolygons polygons, int polygon, BallShadow other) {
        return polygons.cut(polygon, cellA(other), cellB(other), cellC(other));
    }

    private double cellA(BallShadow other) {
        return other.rootK * mx - rootK * other.mx;
    }

    private double cellB(BallShadow other) {
        return other.rootK * my - rootK * other.my;
    }

    private double cellC(BallShadow other) {
        return (other.rootK * mz - rootK * other.mz) * depth;
    }
}
