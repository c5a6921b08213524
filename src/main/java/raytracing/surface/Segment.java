package raytracing.surface;

import raytracing.math.Vector;

/**
 * The open straight line between two points: start + t direction for t from 0 to 1, both excluded. Mutable, so that testing
 * millions of shadow rays allocates nothing. Not thread-safe.
 */
public final class Segment {
    RayOrigin start = new RayOrigin();
    double endX;
    double endY;
    double endZ;
    double endError;
    double dx;
    double dy;
    double dz;

    /** The larger of the errors of the two ends. */
    double error;

    /** A segment without length at the world's origin. */
    public Segment() {
    }

    /**
     * Connects two points.
     *
     * @param from the start, which must stay as it is while this segment is used
     * @param x the end, world axes
     * @param pointError how far each coordinate of the end may be off
     */
    public void connect(RayOrigin from, double x, double y, double z, double pointError) {
        start = from;
        endX = x;
        endY = y;
        endZ = z;
        endError = pointError;
        dx = x - from.x;
        dy = y - from.y;
        dz = z - from.z;
        error = Math.max(from.error, pointError);
    }

    public RayOrigin start() {
        return start;
    }

    /** Along x, from the start to the end. */
    public double dx() {
        return dx;
    }

    public double dy() {
        return dy;
    }

    public double dz() {
        return dz;
    }

    /** How far each coordinate of either end may be off. */
    public double error() {
        return error;
    }

    Vector end() {
        return new Vector(endX, endY, endZ);
    }
}
