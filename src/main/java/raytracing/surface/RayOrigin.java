package raytracing.surface;

import raytracing.math.Vector;

/**
 * A point at which a ray or a segment starts, and what tells on which side of a surface it lies. A rounded point may touch
 * several surfaces: the one that a ray has reached, and others in a corner of a room. It lies in front of all of them, on the
 * side from which it was seen; so no light comes through where two surfaces meet. A point that the scene names was seen from
 * nowhere else, and has no side of a surface that it touches.
 *
 * <p>Mutable. Not thread-safe.
 */
public final class RayOrigin {
    /** The number of no surface, below every real one. */
    public static final int NO_SURFACE = -1;

    /**
     * A path of at most so many errors of its start does not leave the point: the sides at its end are those at its start.
     * Between the error itself and this, a short ray could end on a second surface while it still touches the first.
     */
    private static final double STILL_THERE = 64;

    double x;
    double y;
    double z;
    double error;
    int surface = NO_SURFACE;
    Departure side = Departure.ELSEWHERE;

    private double seenFromX;
    private double seenFromY;
    private double seenFromZ;
    private double seenFromError;
    private int surfaceSeenFrom = NO_SURFACE;
    private Departure sideSeenFrom = Departure.ELSEWHERE;

    /** The origin of the world, on no surface. */
    public RayOrigin() {
    }

    /** Becomes a point on no surface. */
    void set(Vector point, double pointError) {
        set(point.x(), point.y(), point.z(), pointError, NO_SURFACE, Departure.ELSEWHERE);
    }

    /** Becomes a point that was not reached by a ray. */
    void set(double pointX, double pointY, double pointZ, double pointError, int surfaceThere, Departure sideThere) {
        place(pointX, pointY, pointZ, pointError);
        surface = surfaceThere;
        side = sideThere;
        seeFrom(this);
    }

    /** Becomes a copy of another point. */
    public void set(RayOrigin other) {
        x = other.x;
        y = other.y;
        z = other.z;
        error = other.error;
        surface = other.surface;
        side = other.side;
        takeView(other);
    }

    /**
     * Sets the point alone. Where a ray nearly along a plane meets it beyond all doubles, the outermost finite point is taken:
     * so rays from there start at a number.
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

    private void seeFrom(RayOrigin place) {
        seenFromX = place.x;
        seenFromY = place.y;
        seenFromZ = place.z;
        seenFromError = place.error;
        surfaceSeenFrom = place.surface;
        sideSeenFrom = place.side;
    }

    private void takeView(RayOrigin other) {
        seenFromX = other.seenFromX;
        seenFromY = other.seenFromY;
        seenFromZ = other.seenFromZ;
        seenFromError = other.seenFromError;
        surfaceSeenFrom = other.surfaceSeenFrom;
        sideSeenFrom = other.sideSeenFrom;
    }

    /**
     * Records how this point was reached.
     *
     * @param surfaceReached number of the surface that it is on
     * @param sideReached the side of that surface from which the ray came
     * @param origin where the ray started
     * @param way how far this point is from there, as the largest of its three coordinates
     */
    void reach(int surfaceReached, Departure sideReached, RayOrigin origin, double way) {
        surface = surfaceReached;
        side = sideReached;
        if (way <= STILL_THERE * origin.error) {
            takeView(origin);
        } else {
            seeFrom(origin);
        }
    }

    public double x() {
        return x;
    }

    public double y() {
        return y;
    }

    public double z() {
        return z;
    }

    /** How far each coordinate may be off, in scene units. */
    public double error() {
        return error;
    }

    /** Number of the surface that the point is on, or {@link #NO_SURFACE}. */
    public int surface() {
        return surface;
    }

    /** How a ray leaves that surface that starts here on the side from which the point was seen. */
    public Departure side() {
        return side;
    }

    Vector point() {
        return new Vector(x, y, z);
    }

    /** Where it was seen from: the start of the ray that reached it, or the point itself. */
    public Vector seenFrom() {
        return new Vector(seenFromX, seenFromY, seenFromZ);
    }

    /** How far each coordinate of that start may be off. */
    double seenFromError() {
        return seenFromError;
    }

    /** How the ray that reached this point left a surface; {@link Departure#ELSEWHERE} if it started on another or none. */
    Departure sideSeenFrom(int number) {
        return number == surfaceSeenFrom ? sideSeenFrom : Departure.ELSEWHERE;
    }
}
