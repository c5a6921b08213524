package raytracing.geometry;

import raytracing.math.Vector;

/**
 * Where a ray met a surface, in numbers that the next hit overwrites: so that following millions of rays makes no garbage.
 * The kernels write, everybody else reads. One thread.
 */
public final class HitPoint {
    private double x;
    private double y;
    private double z;
    private double error;
    private double normalX;
    private double normalY;
    private double normalZ;
    private Departure side = Departure.ELSEWHERE;

    /**
     * The point, rounded, on the surface as nearly as doubles allow. Beyond them all, where a ray nearly along a plane may
     * meet it, lies the outermost point there is: so rays from there start at a number.
     */
    void place(double pointX, double pointY, double pointZ, double pointError) {
        x = pointX;
        y = pointY;
        z = pointZ;
        error = pointError;
        if (!(Math.abs(x) + Math.abs(y) + Math.abs(z) + error < Double.POSITIVE_INFINITY)) {
            x = finite(x);
            y = finite(y);
            z = finite(z);
            error = finite(error);
        }
    }

    private static double finite(double number) {
        return Math.max(-Double.MAX_VALUE, Math.min(Double.MAX_VALUE, number));
    }

    /** Brings back to size what was described at a fraction of it. */
    void enlarge(double factor) {
        place(factor * x, factor * y, factor * z, factor * error);
    }

    /** A unit normal that points out of the body, turned towards where the ray comes from. */
    void turn(double outwardX, double outwardY, double outwardZ, double dx, double dy, double dz) {
        boolean fromInside = outwardX * dx + outwardY * dy + outwardZ * dz > 0;
        normalX = fromInside ? -outwardX : outwardX;
        normalY = fromInside ? -outwardY : outwardY;
        normalZ = fromInside ? -outwardZ : outwardZ;
        side = fromInside ? Departure.INWARD : Departure.OUTWARD;
    }

    /**
     * The point.
     *
     * @return x part, world axes
     */
    public double x() {
        return x;
    }

    /**
     * The point.
     *
     * @return y part
     */
    public double y() {
        return y;
    }

    /**
     * The point.
     *
     * @return z part
     */
    public double z() {
        return z;
    }

    /**
     * How far the point may be off.
     *
     * @return bound for each part, in scene units
     */
    public double error() {
        return error;
    }

    /**
     * The unit normal, turned towards the ray's origin.
     *
     * @return x part
     */
    public double normalX() {
        return normalX;
    }

    /**
     * The unit normal, turned towards the ray's origin.
     *
     * @return y part
     */
    public double normalY() {
        return normalY;
    }

    /**
     * The unit normal, turned towards the ray's origin.
     *
     * @return z part
     */
    public double normalZ() {
        return normalZ;
    }

    /**
     * How a ray leaves that starts here on the side from which this one came.
     *
     * @return {@link Departure#OUTWARD} or {@link Departure#INWARD}
     */
    public Departure side() {
        return side;
    }

    /**
     * The component along the normal.
     *
     * @param vx any vector, x part
     * @param vy y part
     * @param vz z part
     * @return normal . v
     */
    public double alongNormal(double vx, double vy, double vz) {
        return normalX * vx + normalY * vy + normalZ * vz;
    }

    /**
     * How a straight line from here leaves the surface, by its direction alone.
     *
     * @param dx where the line goes, x part; any length
     * @param dy y part
     * @param dz z part
     * @return into the body, or out of it or along its wall
     */
    public Departure departureTowards(double dx, double dy, double dz) {
        return Departure.towards(side, alongNormal(dx, dy, dz));
    }

    /**
     * Takes the numbers of a hit.
     *
     * @param hit any hit
     */
    public void take(Hit hit) {
        place(hit.point().x(), hit.point().y(), hit.point().z(), hit.pointError());
        normalX = hit.normal().x();
        normalY = hit.normal().y();
        normalZ = hit.normal().z();
        side = hit.side();
    }

    /**
     * Takes the numbers of another hit.
     *
     * @param other any hit
     */
    public void take(HitPoint other) {
        place(other.x, other.y, other.z, other.error);
        normalX = other.normalX;
        normalY = other.normalY;
        normalZ = other.normalZ;
        side = other.side;
    }

    /**
     * These numbers as a value that stays.
     *
     * @param surface number of the surface that was met, counted from 0 in the order of the scene
     * @param material number of its material, counted from 0
     * @param distance the crossing, in multiples of the ray's direction
     * @return the hit
     */
    public Hit toHit(int surface, int material, double distance) {
        return new Hit(surface, material, distance, new Vector(x, y, z), error,
            new Vector(normalX, normalY, normalZ), side);
    }
}
