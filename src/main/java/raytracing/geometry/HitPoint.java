package raytracing.geometry;

import raytracing.math.Vector;

/**
 * Where a ray met a surface, in numbers that the next hit overwrites: so that following millions of rays makes no garbage.
 * The kernels write, everybody else reads. One thread.
 */
public final class HitPoint {
    /** Far above the rounding of a unit normal and of a dot product with it. */
    private static final double ROUNDING = 0x1p-44;

    private final Standpoint place = new Standpoint();
    private double normalX;
    private double normalY;
    private double normalZ;

    /** How far the point is from the ray's origin, in largest parts. */
    private double way;

    /** Nothing met yet. */
    public HitPoint() {
    }

    /**
     * Takes a point that is off by a crossing's error.
     *
     * @param origin where the ray starts
     * @param pathLength how far the ray goes from there, in largest parts
     */
    void placeAlong(Standpoint origin, double pathLength, double x, double y, double z) {
        way = pathLength;
        place.place(x, y, z, PointError.ofCrossing(Vector.largestPart(origin.x(), origin.y(), origin.z()) + way));
    }

    /** Takes the ray's own origin, of a surface that it meets at once. */
    void placeAt(Standpoint origin) {
        way = 0;
        place.place(origin.x(), origin.y(), origin.z(), origin.error());
    }

    /** Whether the direction's component along a unit normal has a sign beyond rounding. */
    static boolean isClear(double along, double dx, double dy, double dz) {
        return Math.abs(along) > ROUNDING * Vector.largestPart(dx, dy, dz);
    }

    /** Turns a unit normal that points out of the body towards where the ray comes from, and notes where that is. */
    void reach(double outwardX, double outwardY, double outwardZ, Departure side, int surface, Standpoint origin) {
        boolean isSeenFromInside = side == Departure.INWARD;
        normalX = isSeenFromInside ? -outwardX : outwardX;
        normalY = isSeenFromInside ? -outwardY : outwardY;
        normalZ = isSeenFromInside ? -outwardZ : outwardZ;
        place.reach(surface, side, origin, way);
    }

    /**
     * Whether the normal is that of one of some faces of a box.
     *
     * @param faces a bit 1 &lt;&lt; axis for each, with axis 0 for x, 1 for y, 2 for z
     * @return true if the normal runs along one of the axes named
     */
    public boolean isOnFace(int faces) {
        int axis = normalX != 0 ? 0 : normalY != 0 ? 1 : 2;
        return (faces & 1 << axis) != 0;
    }

    /** Brings back to size what was described at a fraction of it. */
    void enlarge(double factor, Standpoint origin) {
        place.place(factor * x(), factor * y(), factor * z(), factor * error());
        place.reach(surface(), side(), origin, factor * way);
    }

    /**
     * Where rays and lines from here start.
     *
     * @return the point, and what is known of the surfaces that it touches; overwritten by the next hit
     */
    public Standpoint place() {
        return place;
    }

    /**
     * The point.
     *
     * @return x part, world axes
     */
    public double x() {
        return place.x();
    }

    /**
     * The point.
     *
     * @return y part
     */
    public double y() {
        return place.y();
    }

    /**
     * The point.
     *
     * @return z part
     */
    public double z() {
        return place.z();
    }

    /**
     * How far the point may be off.
     *
     * @return bound for each part, in scene units
     */
    public double error() {
        return place.error();
    }

    /**
     * The surface that was met.
     *
     * @return its number, counted from 0 in the order of the scene
     */
    public int surface() {
        return place.surface();
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
        return place.side();
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
        return Departure.towards(side(), alongNormal(dx, dy, dz));
    }

    /**
     * Takes the numbers of a hit, without where it was seen from.
     *
     * @param hit any hit
     */
    public void take(Hit hit) {
        place.start(hit.point().x(), hit.point().y(), hit.point().z(), hit.pointError(), hit.surface(), hit.side());
        normalX = hit.normal().x();
        normalY = hit.normal().y();
        normalZ = hit.normal().z();
    }

    /**
     * Takes the numbers of another hit.
     *
     * @param other any hit
     */
    public void take(HitPoint other) {
        place.take(other.place);
        normalX = other.normalX;
        normalY = other.normalY;
        normalZ = other.normalZ;
        way = other.way;
    }

    /**
     * These numbers as a value that stays.
     *
     * @param material number of its material, counted from 0
     * @param distance the crossing, in multiples of the ray's direction
     * @return the hit
     */
    public Hit toHit(int material, double distance) {
        return new Hit(surface(), material, distance, place.point(), error(), new Vector(normalX, normalY, normalZ),
            side());
    }
}
