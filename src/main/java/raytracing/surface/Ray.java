package raytracing.surface;

import raytracing.math.UnitVector;
import raytracing.math.Vector;

/**
 * A half-line: the points origin + t direction for t of at least 0. Mutable, so that following millions of rays allocates
 * nothing. Not thread-safe.
 */
public final class Ray {
    final RayOrigin origin = new RayOrigin();
    private final UnitVector unit = new UnitVector();
    double dx;
    double dy;
    double dz;

    /** A ray that has not started: it starts at the world's origin and goes nowhere. */
    public Ray() {
    }

    /** Starts at a point that the scene names, such as the camera's position, and goes along a vector but 0, made unit. */
    public void startAt(Vector point, double x, double y, double z) {
        origin.set(point, PointError.written(point));
        unit.set(x, y, z);
        turn(unit.x(), unit.y(), unit.z());
    }

    /**
     * Starts where another ray met a surface, on the side from which that surface was seen. Distances t count in multiples of
     * the direction, which has any length but 0.
     */
    public void leave(RayOrigin from, double directionX, double directionY, double directionZ) {
        origin.set(from);
        turn(directionX, directionY, directionZ);
    }

    private void turn(double directionX, double directionY, double directionZ) {
        dx = directionX;
        dy = directionY;
        dz = directionZ;
    }

    /** The same ray in a world that is so many times as large, a power of two; distances t become as many times larger. */
    Ray scaled(double factor) {
        Ray scaled = new Ray();
        scaled.origin.set(factor * origin.x, factor * origin.y, factor * origin.z, factor * origin.error,
            origin.surface, origin.side);
        scaled.turn(dx, dy, dz);
        return scaled;
    }

    public RayOrigin origin() {
        return origin;
    }

    public double dx() {
        return dx;
    }

    public double dy() {
        return dy;
    }

    public double dz() {
        return dz;
    }

    Vector direction() {
        return new Vector(dx, dy, dz);
    }

    /** Whether this ray starts on a surface and leaves its body. */
    boolean leavesOutward(int number) {
        return origin.surface == number && origin.side == Departure.OUTWARD;
    }
}
