package raytracing.geometry;

import raytracing.math.Vector;

/**
 * A point at which a ray or a line starts, in numbers that the next point overwrites, and what tells on which side of a
 * surface it lies. A rounded point may touch several surfaces: the one that a ray has reached, and others in a corner of a
 * room. It lies in front of all of them, on the side from which it was seen; so no light comes through where two
 * surfaces meet. A point that the scene names was seen from nowhere else, and has no side of a surface that it touches.
 *
 * <p>One thread.
 */
public final class Standpoint {
    /**
     * A way of at most so many errors of its start does not leave the point: the sides at its end are those at its start.
     * Between the error itself and this, a short ray could end on a second surface while it still touches the first.
     */
    private static final double STILL_THERE = 64;

    private double x;
    private double y;
    private double z;
    private double error;
    private int surface = Ray.NO_SURFACE;
    private Departure side = Departure.ELSEWHERE;

    private double seenFromX;
    private double seenFromY;
    private double seenFromZ;
    private double seenFromError;
    private int surfaceSeenFrom = Ray.NO_SURFACE;
    private Departure sideSeenFrom = Departure.ELSEWHERE;

    /** The origin of the world, on no surface. */
    public Standpoint() {
    }

    /**
     * Takes a point that was not reached by a ray, such as the camera.
     *
     * @param pointX x part, world axes
     * @param pointY y part
     * @param pointZ z part
     * @param pointError how far each part may be off
     * @param surfaceThere number of the surface that the point is on, or {@link Ray#NO_SURFACE}
     * @param sideThere how a ray leaves that surface; {@link Departure#ELSEWHERE} if there is none
     */
    public void start(double pointX, double pointY, double pointZ, double pointError, int surfaceThere,
                      Departure sideThere) {
        place(pointX, pointY, pointZ, pointError);
        surface = surfaceThere;
        side = sideThere;
        seeFrom(this);
    }

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

    private void seeFrom(Standpoint place) {
        seenFromX = place.x;
        seenFromY = place.y;
        seenFromZ = place.z;
        seenFromError = place.error;
        surfaceSeenFrom = place.surface;
        sideSeenFrom = place.side;
    }

    /**
     * Notes how this point was reached.
     *
     * @param surfaceReached number of the surface that it is on
     * @param sideReached the side of that surface from which the ray came
     * @param origin where the ray started
     * @param way how far this point is from there, in largest parts
     */
    void reach(int surfaceReached, Departure sideReached, Standpoint origin, double way) {
        surface = surfaceReached;
        side = sideReached;
        if (way <= STILL_THERE * origin.error) {
            takeView(origin);
        } else {
            seeFrom(origin);
        }
    }

    /**
     * Takes over all that is known of another point.
     *
     * @param other any point
     */
    public void take(Standpoint other) {
        x = other.x;
        y = other.y;
        z = other.z;
        error = other.error;
        surface = other.surface;
        side = other.side;
        takeView(other);
    }

    private void takeView(Standpoint other) {
        seenFromX = other.seenFromX;
        seenFromY = other.seenFromY;
        seenFromZ = other.seenFromZ;
        seenFromError = other.seenFromError;
        surfaceSeenFrom = other.surfaceSeenFrom;
        sideSeenFrom = other.sideSeenFrom;
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
     * The surface that the point is on.
     *
     * @return its number, or {@link Ray#NO_SURFACE}
     */
    public int surface() {
        return surface;
    }

    /**
     * How a ray leaves that surface that starts here on the side from which the point was seen.
     *
     * @return {@link Departure#ELSEWHERE} if there is no such surface
     */
    public Departure side() {
        return side;
    }

    /** The point as a vector. */
    Vector point() {
        return new Vector(x, y, z);
    }

    /** Where it was seen from: the start of the ray that reached it, or the point itself. */
    Vector seenFrom() {
        return new Vector(seenFromX, seenFromY, seenFromZ);
    }

    /** How far each part of that place may be off. */
    double seenFromError() {
        return seenFromError;
    }

    /** How that place lies to a surface by the way in which the ray left it; ELSEWHERE if it left another one. */
    Departure sideSeenFrom(int number) {
        return number == surfaceSeenFrom ? sideSeenFrom : Departure.ELSEWHERE;
    }
}
